#ifndef CellScene_h
#define CellScene_h

#include "ShadedScene.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hasp
{
struct GridGeometry;
}

class vtkActor;
class vtkMapper;
class vtkRenderer;
class vtkShaderProgram;

/// What the shaders of the clustered cells know of camera, actor, clipping planes and lights: read
/// from VTK once a frame, in double precision; rounded to float when it goes to the GPU. The eye is
/// taken from the full matrix, so every kind of stereo and off-axis camera comes out right.
struct CellScene : ShadedScene
{
  glm::dmat4 indexToClip, indexToView;
  /// indexToClip of the eye that is not drawn now, where a rig says it (vtkHaspStereoPair.h).
  std::optional<glm::dmat4> otherIndexToClip;
  glm::ivec2 viewportOrigin, viewportSize; ///< pixels of the window
  std::vector<glm::dvec4> planes;          ///< in index coordinates; the near plane first
  float isovalue;

  /// mapper: for its clipping planes. surfaceColor takes the place of the property's colour and
  /// multiplies its opacity. RENDER thread, inside vtkMapper::Render.
  CellScene(vtkMapper* mapper, const hasp::GridGeometry& geometry, double isovalue,
    vtkRenderer* renderer, vtkActor* actor, const std::optional<glm::vec4>& surfaceColor = {});

  /// The #define lines of the shader variant this scene needs: what it does not have is not in it.
  std::string Defines() const;
  /// Appends a CellFrame (CellFrame.glsl) of cells that are moved, in index coordinates.
  void AppendFrame(std::vector<float>& data, const glm::dmat4& move) const;
  /// RENDER thread, with a program of that variant bound.
  void SetUniforms(vtkShaderProgram* program) const;
  /// Of the program that draws the boxes of clusters (OcclusionCulling). RENDER thread.
  void SetBoxUniforms(vtkShaderProgram* program) const;
};

#endif
