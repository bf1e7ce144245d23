#ifndef ShadedScene_h
#define ShadedScene_h

#include "vtkHaspRenderingSharedModule.h" // for export macro

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <optional>
#include <string>
#include <vector>

class vtkActor;
class vtkRenderer;
class vtkShaderProgram;

/// What glsl/SurfaceShading.glsl knows of lights and the actor's property: read from VTK once a
/// frame. Threads: RENDER, inside vtkMapper::Render.
struct VTKHASPRENDERINGSHARED_EXPORT ShadedScene
{
  bool parallelProjection;
  /// One entry a light that is switched on, in view coordinates.
  std::vector<glm::vec3> lightColor, lightDirection, lightPosition, lightAttenuation, lightCone;
  bool positionalLights = false;
  glm::vec3 ambientColor, diffuseColor, specularColor;
  glm::vec2 colorShares; ///< ambient and diffuse, of colours that take the place of the property's
  float specularPower, opacity;

  /// surfaceColor takes the place of the property's colour and multiplies its opacity.
  ShadedScene(
    vtkRenderer* renderer, vtkActor* actor, const std::optional<glm::vec4>& surfaceColor = {});

  /// The #define lines of the shader variant this scene needs: what it does not have is not in it.
  std::string ShadingDefines() const;
  /// With a program of that variant bound.
  void SetShadingUniforms(vtkShaderProgram* program) const;
};

#endif
