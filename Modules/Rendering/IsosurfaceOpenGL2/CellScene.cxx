#include "CellScene.h"

#include "Grid/GridGeometry.h"
#include "HaspGL.h"

#include "vtkHaspStereoPair.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{

glm::dmat4 IndexToWorld(vtkActor* actor, const hasp::GridGeometry& geometry)
{
  glm::dmat4 indexToData(geometry.IndexToWorldMatrix());
  indexToData[3] = glm::dvec4(geometry.origin, 1.0);
  return glm::transpose(glm::make_mat4(actor->GetMatrix()->GetData())) * indexToData;
}

/// A row times indexToWorld: the same plane in index coordinates.
glm::dvec4 PlaneInIndex(vtkPlane* plane, const glm::dmat4& indexToWorld)
{
  const glm::dvec3 normal = glm::make_vec3(plane->GetNormal());
  const glm::dvec3 origin = glm::make_vec3(plane->GetOrigin());
  return glm::dvec4(normal, -glm::dot(normal, origin)) * indexToWorld;
}

void AddLight(CellScene& scene, vtkLight* light, const glm::dmat4& worldToView)
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

void SetMatrix(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix)
{
  glm::mat4 single(matrix);
  program->SetUniformMatrix4x4(name, glm::value_ptr(single));
}

/// (eye, 1), or (minus the view direction, 0) for a parallel projection: the point with clip
/// coordinates (0, 0, 1, 0).
glm::vec4 EyeInIndex(const glm::dmat4& clipToIndex, bool parallel)
{
  const glm::dvec4 eye = clipToIndex * glm::dvec4(0, 0, 1, 0);
  return parallel ? glm::dvec4(-glm::normalize(glm::dvec3(eye)), 0.0) : eye / eye.w;
}

} // namespace

CellScene::CellScene(vtkMapper* mapper, const hasp::GridGeometry& geometry, double isoValue,
  vtkRenderer* renderer, vtkActor* actor, const std::optional<glm::vec4>& surfaceColor)
{
  vtkMatrix4x4 *view, *projection,
    *clip; // VTK hands these out with column-major memory, for OpenGL
  vtkMatrix3x3* normal;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, view, normal, projection, clip);
  const glm::dmat4 worldToView = glm::make_mat4(view->GetData());
  const glm::dmat4 indexToWorld = IndexToWorld(actor, geometry);
  this->indexToView = worldToView * indexToWorld;
  this->indexToClip = glm::dmat4(glm::make_mat4(clip->GetData())) * indexToWorld;
  vtkCamera* camera = renderer->GetActiveCamera();
  if (const auto pair = hasp::StereoPairOf(camera->GetInformation()))
    this->otherIndexToClip = (camera->GetLeftEye() ? pair->right : pair->left) * indexToWorld;
  this->parallelProjection = renderer->GetActiveCamera()->GetParallelProjection();
  this->isovalue = static_cast<float>(isoValue);
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  this->viewportOrigin = { viewport[0], viewport[1] };
  this->viewportSize = { viewport[2], viewport[3] };

  this->planes.push_back(glm::row(this->indexToClip, 2) + glm::row(this->indexToClip, 3));
  if (vtkPlaneCollection* clipping = mapper->GetClippingPlanes())
    for (int p = 0; p < clipping->GetNumberOfItems(); ++p)
      this->planes.push_back(PlaneInIndex(clipping->GetItem(p), indexToWorld));

  vtkProperty* property = actor->GetProperty();
  if (property->GetLighting())
  {
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

std::string CellScene::Defines() const
{
  std::string text = "#define HASP_PLANES " + std::to_string(this->planes.size()) + "\n";
  text += "#define HASP_LIGHTS " + std::to_string(this->lightColor.size()) + "\n";
  if (this->positionalLights)
    text += "#define HASP_POSITIONAL_LIGHTS\n";
  if (this->specularColor != glm::vec3(0.0F))
    text += "#define HASP_SPECULAR\n";
  return text;
}

void CellScene::AppendFrame(std::vector<float>& data, const glm::dmat4& move) const
{
  const glm::dmat4 toClip = this->indexToClip * move, toView = this->indexToView * move;
  const glm::dmat4 fromClip = glm::inverse(toClip);
  const glm::dmat4 normals(glm::transpose(glm::inverse(glm::dmat3(toView))));
  const auto append = [&](const auto& value)
  {
    for (int n = 0; n < static_cast<int>(sizeof(value) / sizeof(double)); ++n)
      data.push_back(static_cast<float>(glm::value_ptr(value)[n]));
  };
  for (const glm::dmat4& matrix : { toClip, fromClip, toView, normals })
    append(matrix);
  append(glm::dvec4(EyeInIndex(fromClip, this->parallelProjection)));
  for (const glm::dvec4& plane : this->planes)
    append(plane * move);
}

void CellScene::SetUniforms(vtkShaderProgram* program) const
{
  const glm::dmat4 clipToIndex = glm::inverse(this->indexToClip);
  const glm::mat3 normalToView(glm::transpose(glm::inverse(glm::dmat3(this->indexToView))));
  const glm::vec4 eye = EyeInIndex(clipToIndex, this->parallelProjection);
  const glm::vec2 size(this->viewportSize);
  const glm::vec4 toDevice(
    glm::vec2(2.0F) / size, -2.0F * glm::vec2(this->viewportOrigin) / size - 1.0F);
  SetMatrix(program, "indexToClip", this->indexToClip);
  SetMatrix(program, "clipToIndex", clipToIndex);
  SetMatrix(program, "indexToView", this->indexToView);
  SetMatrix(program, "clipToView", this->indexToView * clipToIndex);
  program->SetUniformMatrix3x3("normalToView", const_cast<float*>(glm::value_ptr(normalToView)));
  program->SetUniform4f("eyeIndex", &eye.x);
  program->SetUniform2f("viewport", &size.x);
  program->SetUniform4f("viewportToDevice", &toDevice.x);
  program->SetUniformi("parallelProjection", this->parallelProjection);
  program->SetUniformf("isovalue", this->isovalue);
  const std::vector<glm::vec4> single(this->planes.begin(), this->planes.end());
  program->SetUniform4fv("planes", static_cast<int>(single.size()), &single[0].x);

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

void CellScene::SetBoxUniforms(vtkShaderProgram* program) const
{
  const glm::dmat4 clipToIndex = glm::inverse(this->indexToClip);
  const glm::vec4 eye = EyeInIndex(clipToIndex, this->parallelProjection);
  // A step of one mm to the side, in pixels at w = 1; then of one pixel, in voxels along each axis.
  const glm::dmat4 viewToClip = this->indexToClip * glm::inverse(this->indexToView);
  const glm::dvec2 pixelsPerMm =
    0.5 * glm::dvec2(this->viewportSize) *
    glm::dvec2(glm::length(glm::dvec2(viewToClip[0])), glm::length(glm::dvec2(viewToClip[1])));
  const double mmPerPixel = 1.0 / std::min(pixelsPerMm.x, pixelsPerMm.y);
  const glm::dmat3 viewToIndex = glm::inverse(glm::dmat3(this->indexToView));
  glm::vec3 voxelsPerPixel;
  for (int a = 0; a < 3; ++a)
    voxelsPerPixel[a] = static_cast<float>(mmPerPixel * glm::length(glm::row(viewToIndex, a)));
  // Places are rounded to 2^-24 of their distance from the origin and from the eye.
  const double far = glm::length(glm::dvec3(glm::inverse(this->indexToView)[3]));
  const glm::vec2 size(this->viewportSize);
  SetMatrix(program, "indexToClip", this->indexToClip);
  program->SetUniform4f("eyeIndex", &eye.x);
  program->SetUniform3f("voxelsPerPixel", &voxelsPerPixel.x);
  program->SetUniformf("roundingVoxels", static_cast<float>(0.01 + 1e-6 * far));
  program->SetUniform2f("viewport", &size.x);
}
