#include "ShadedScene.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace
{

void AddLight(ShadedScene& scene, vtkLight* light, const glm::dmat4& worldToView)
{
  double from[3], to[3], factors[3];
  light->GetTransformedPosition(from);
  light->GetTransformedFocalPoint(to);
  light->GetAttenuationValues(factors);
  const glm::dvec3 way = glm::make_vec3(to) - glm::make_vec3(from);
  const double length = glm::length(way); // 0: a positional light without a direction
  const bool positional = light->GetPositional();
  const bool spot = positional && light->GetConeAngle() < 90.0;
  scene.positionalLights |= positional;
  scene.lightColor.emplace_back(
    glm::dvec3(glm::make_vec3(light->GetDiffuseColor())) * light->GetIntensity());
  scene.lightPosition.emplace_back(worldToView * glm::dvec4(glm::make_vec3(from), 1.0));
  scene.lightDirection.emplace_back(
    glm::dmat3(worldToView) * (length > 0.0 ? way / length : glm::dvec3(0.0)));
  scene.lightAttenuation.emplace_back(factors[0], factors[1], factors[2]);
  scene.lightCone.emplace_back(spot ? std::cos(glm::radians(light->GetConeAngle())) : -1.0,
    spot ? light->GetExponent() : 0.0, positional ? 1.0 : 0.0);
}

glm::dmat4 WorldToView(vtkRenderer* renderer)
{
  vtkMatrix4x4 *view, *projection, *clip; // column-major memory, for OpenGL
  vtkMatrix3x3* normal;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, view, normal, projection, clip);
  return glm::make_mat4(view->GetData());
}

} // namespace

ShadedScene::ShadedScene(
  vtkRenderer* renderer, vtkActor* actor, const std::optional<glm::vec4>& surfaceColor)
  : parallelProjection(renderer->GetActiveCamera()->GetParallelProjection())
{
  vtkProperty* property = actor->GetProperty();
  if (property->GetLighting())
  {
    const glm::dmat4 worldToView = WorldToView(renderer);
    vtkLightCollection* lights = renderer->GetLights();
    vtkCollectionSimpleIterator next;
    lights->InitTraversal(next);
    while (vtkLight* light = lights->GetNextLight(next))
      if (light->GetSwitch())
        AddLight(*this, light, worldToView);
  }
  const auto color = [](const double* rgb, double share)
  { return glm::vec3(glm::make_vec3(rgb) * share); };
  const bool unlit = this->lightColor.empty(); // VTK then shows ambient and diffuse as they are
  this->colorShares = { property->GetAmbient() + (unlit ? property->GetDiffuse() : 0.0),
    property->GetDiffuse() };
  this->ambientColor = color(property->GetAmbientColor(), property->GetAmbient());
  this->diffuseColor = color(property->GetDiffuseColor(), property->GetDiffuse());
  if (unlit)
    this->ambientColor += this->diffuseColor;
  this->specularColor = color(property->GetSpecularColor(), property->GetSpecular());
  this->specularPower = static_cast<float>(property->GetSpecularPower());
  this->opacity = static_cast<float>(property->GetOpacity());
  if (surfaceColor)
  {
    this->ambientColor = this->colorShares.x * glm::vec3(*surfaceColor);
    this->diffuseColor = this->colorShares.y * glm::vec3(*surfaceColor);
    this->opacity *= surfaceColor->a;
  }
}

std::string ShadedScene::ShadingDefines() const
{
  std::string text = "#define HASP_LIGHTS " + std::to_string(this->lightColor.size()) + "\n";
  if (this->positionalLights)
    text += "#define HASP_POSITIONAL_LIGHTS\n";
  if (this->specularColor != glm::vec3(0.0F))
    text += "#define HASP_SPECULAR\n";
  return text;
}

void ShadedScene::SetShadingUniforms(vtkShaderProgram* program) const
{
  program->SetUniformi("parallelProjection", this->parallelProjection);
  program->SetUniform3f("ambientColor", &this->ambientColor.x);
  program->SetUniform3f("diffuseColor", &this->diffuseColor.x);
  program->SetUniform2f("colorShares", &this->colorShares.x);
  program->SetUniform3f("specularColor", &this->specularColor.x);
  program->SetUniformf("specularPower", this->specularPower);
  program->SetUniformf("opacity", this->opacity);
  const auto perLight = [&](const char* name, const std::vector<glm::vec3>& values)
  {
    if (!values.empty())
      program->SetUniform3fv(name, static_cast<int>(values.size()), &values[0].x);
  };
  perLight("lightColor", this->lightColor);
  perLight("lightDirection", this->lightDirection);
  if (!this->positionalLights)
    return;
  perLight("lightPosition", this->lightPosition);
  perLight("lightAttenuation", this->lightAttenuation);
  perLight("lightCone", this->lightCone);
}
