#include "CellUniforms.h"

#include "Isosurface/ClusteredCells.h"
#include "vtkHaspClusteredCellMapper.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
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
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

constexpr int MaxLights = 8; // as in vtkHaspClusteredCellFS.glsl
constexpr int MaxPlanes = 7;

glm::dmat4 FromVTK(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}

glm::dmat4 IndexToWorld(const hasp::GridGeometry& geometry)
{
  glm::dmat4 matrix(geometry.IndexToWorldMatrix());
  matrix[3] = glm::dvec4(geometry.origin, 1.0);
  return matrix;
}

/// VTK hands these out transposed for OpenGL: their memory is column-major.
struct CameraMatrices
{
  glm::dmat4 worldToView, worldToClip;

  explicit CameraMatrices(vtkRenderer* renderer)
  {
    vtkMatrix4x4 *view, *projection, *clip;
    vtkMatrix3x3* normal;
    vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
      ->GetKeyMatrices(renderer, view, normal, projection, clip);
    this->worldToView = glm::make_mat4(view->GetData());
    this->worldToClip = glm::make_mat4(clip->GetData());
  }
};

void SetMatrix(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix)
{
  glm::mat4 single(matrix);
  program->SetUniformMatrix4x4(name, glm::value_ptr(single));
}

void SetVector(vtkShaderProgram* program, const char* name, const glm::dvec4& vector)
{
  const glm::vec4 single(vector);
  program->SetUniform4f(name, glm::value_ptr(single));
}

/// (eye, 1), or (minus the view direction, 0) for a parallel projection: the point with clip
/// coordinates (0, 0, 1, 0).
glm::dvec4 EyeInIndex(const glm::dmat4& clipToIndex, bool parallel)
{
  const glm::dvec4 eye = clipToIndex * glm::dvec4(0, 0, 1, 0);
  return parallel ? glm::dvec4(-glm::normalize(glm::dvec3(eye)), 0.0) : eye / eye.w;
}

/// Planes as rows: a plane of world coordinates times indexToWorld is the same plane in index
/// coordinates.
void SetPlanes(vtkShaderProgram* program, vtkHaspClusteredCellMapper* mapper,
  const glm::dmat4& indexToWorld, const glm::dmat4& indexToClip)
{
  std::array<glm::vec4, MaxPlanes> planes{};
  int count = 0;
  planes[count++] = glm::vec4(glm::row(indexToClip, 2) + glm::row(indexToClip, 3));
  if (vtkPlaneCollection* clipping = mapper->GetClippingPlanes())
    for (int p = 0; p < clipping->GetNumberOfItems() && count < MaxPlanes; ++p)
    {
      vtkPlane* plane = clipping->GetItem(p);
      const glm::dvec3 normal = glm::make_vec3(plane->GetNormal());
      const glm::dvec3 origin = glm::make_vec3(plane->GetOrigin());
      planes[count++] = glm::vec4(glm::dvec4(normal, -glm::dot(normal, origin)) * indexToWorld);
    }
  program->SetUniformi("planeCount", count);
  program->SetUniform4fv("planes", count, &planes[0].x);
}

void SetLights(vtkShaderProgram* program, vtkRenderer* renderer, const glm::dmat4& worldToView)
{
  std::array<glm::vec3, MaxLights> color{}, position{}, direction{}, attenuation{}, cone{};
  int count = 0;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator next;
  lights->InitTraversal(next);
  for (vtkLight* light = lights->GetNextLight(next); light && count < MaxLights;
       light = lights->GetNextLight(next))
  {
    if (!light->GetSwitch())
      continue;
    double from[3], to[3], factors[3];
    light->GetTransformedPosition(from);
    light->GetTransformedFocalPoint(to);
    light->GetAttenuationValues(factors);
    const glm::dvec3 way = glm::make_vec3(to) - glm::make_vec3(from);
    color[count] = glm::dvec3(glm::make_vec3(light->GetDiffuseColor())) * light->GetIntensity();
    position[count] = glm::vec3(worldToView * glm::dvec4(glm::make_vec3(from), 1.0));
    direction[count] = glm::normalize(glm::dmat3(worldToView) * way);
    attenuation[count] = glm::vec3(factors[0], factors[1], factors[2]);
    const bool spot = light->GetPositional() && light->GetConeAngle() < 90.0;
    cone[count] = { spot ? std::cos(glm::radians(light->GetConeAngle())) : -1.0,
      spot ? light->GetExponent() : 0.0, light->GetPositional() ? 1.0 : 0.0 };
    ++count;
  }
  program->SetUniformi("lightCount", count);
  if (count == 0)
    return;
  program->SetUniform3fv("lightColor", count, &color[0].x);
  program->SetUniform3fv("lightPosition", count, &position[0].x);
  program->SetUniform3fv("lightDirection", count, &direction[0].x);
  program->SetUniform3fv("lightAttenuation", count, &attenuation[0].x);
  program->SetUniform3fv("lightCone", count, &cone[0].x);
}

void SetProperty(vtkShaderProgram* program, vtkProperty* property)
{
  // Unlit properties show their colour as it is.
  const bool lit = property->GetLighting();
  const auto color = [&](const char* name, const double* rgb, double share)
  {
    const glm::vec3 value(glm::make_vec3(rgb) * share);
    program->SetUniform3f(name, &value.x);
  };
  color("ambientColor", lit ? property->GetAmbientColor() : property->GetDiffuseColor(),
    lit ? property->GetAmbient() : 1.0);
  color("diffuseColor", property->GetDiffuseColor(), lit ? property->GetDiffuse() : 0.0);
  color("specularColor", property->GetSpecularColor(), lit ? property->GetSpecular() : 0.0);
  program->SetUniformf("specularPower", static_cast<float>(property->GetSpecularPower()));
  program->SetUniformf("opacity", static_cast<float>(property->GetOpacity()));
}

} // namespace

void SetCellUniforms(vtkShaderProgram* program, vtkHaspClusteredCellMapper* mapper,
  vtkRenderer* renderer, vtkActor* actor)
{
  const CameraMatrices camera(renderer);
  const bool parallel = renderer->GetActiveCamera()->GetParallelProjection();
  const glm::dmat4 indexToWorld =
    FromVTK(actor->GetMatrix()) * IndexToWorld(mapper->GetCells().geometry);
  const glm::dmat4 indexToView = camera.worldToView * indexToWorld;
  const glm::dmat4 indexToClip = camera.worldToClip * indexToWorld;
  const glm::dmat4 clipToIndex = glm::inverse(indexToClip);
  glm::mat3 normalToView(glm::transpose(glm::inverse(glm::dmat3(indexToView))));

  SetMatrix(program, "indexToClip", indexToClip);
  SetMatrix(program, "clipToIndex", clipToIndex);
  SetMatrix(program, "indexToView", indexToView);
  program->SetUniformMatrix3x3("normalToView", glm::value_ptr(normalToView));
  SetVector(program, "eyeIndex", EyeInIndex(clipToIndex, parallel));
  program->SetUniformi("parallelProjection", parallel);
  program->SetUniformf("isovalue", mapper->GetCells().isovalue);
  SetPlanes(program, mapper, indexToWorld, indexToClip);
  SetLights(program, renderer, camera.worldToView);
  SetProperty(program, actor->GetProperty());
}
