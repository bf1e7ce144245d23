#ifndef ActorFrame_h
#define ActorFrame_h

#include "vtkHaspRenderingSharedModule.h" // for export macro

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

class vtkActor;
class vtkMapper;
class vtkRenderer;
class vtkShaderProgram;

/// From a mapper's own coordinates to the screen, with the clipping planes: read from VTK once a
/// frame, in double precision. The eye is taken from the full matrix, so every kind of stereo and
/// off-axis camera comes out right. Threads: RENDER, inside vtkMapper::Render.
struct VTKHASPRENDERINGSHARED_EXPORT ActorFrame
{
  glm::dmat4 localToWorld, localToView, localToClip;
  glm::ivec2 viewportOrigin, viewportSize; ///< pixels of the window
  std::vector<glm::dvec4> planes;          ///< in local coordinates; the near plane first
  bool parallelProjection;

  /// localToData: from what the mapper counts in to the actor's data coordinates.
  ActorFrame(vtkMapper* mapper, vtkRenderer* renderer, vtkActor* actor,
    const glm::dmat4& localToData = glm::dmat4(1.0));

  /// Scale and offset: pixels of the window to [-1,1].
  glm::vec4 PixelsToDevice() const;
};

/// (eye, 1), or (minus the view direction, 0) for a parallel projection: the point with clip
/// coordinates (0, 0, 1, 0).
VTKHASPRENDERINGSHARED_EXPORT glm::vec4 EyeInLocal(const glm::dmat4& clipToLocal, bool parallel);

/// Rounds to float.
VTKHASPRENDERINGSHARED_EXPORT void SetMatrixUniform(
  vtkShaderProgram* program, const char* name, const glm::dmat4& matrix);
/// Of normals: transposed inverse of a matrix of points. Rounds to float.
VTKHASPRENDERINGSHARED_EXPORT void SetNormalMatrixUniform(
  vtkShaderProgram* program, const char* name, const glm::dmat4& points);

#endif
