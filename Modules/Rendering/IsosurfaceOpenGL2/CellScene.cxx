#include "CellScene.h"

#include "ActorFrame.h"
#include "Grid/GridGeometry.h"

#include "vtkHaspStereoPair.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace
{

glm::dmat4 IndexToData(const hasp::GridGeometry& geometry)
{
  glm::dmat4 indexToData(geometry.IndexToWorldMatrix());
  indexToData[3] = glm::dvec4(geometry.origin, 1.0);
  return indexToData;
}

} // namespace

CellScene::CellScene(vtkMapper* mapper, const hasp::GridGeometry& geometry, double isoValue,
  vtkRenderer* renderer, vtkActor* actor, const std::optional<glm::vec4>& surfaceColor)
  : ShadedScene(renderer, actor, surfaceColor),
    isovalue(static_cast<float>(isoValue))
{
  const ActorFrame frame(mapper, renderer, actor, IndexToData(geometry));
  this->indexToView = frame.localToView;
  this->indexToClip = frame.localToClip;
  this->viewportOrigin = frame.viewportOrigin;
  this->viewportSize = frame.viewportSize;
  this->planes = frame.planes;
  vtkCamera* camera = renderer->GetActiveCamera();
  if (const auto pair = hasp::StereoPairOf(camera->GetInformation()))
    this->otherIndexToClip = (camera->GetLeftEye() ? pair->right : pair->left) * frame.localToWorld;
}

std::string CellScene::Defines() const
{
  return "#define HASP_PLANES " + std::to_string(this->planes.size()) + "\n" +
         this->ShadingDefines();
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
  append(glm::dvec4(EyeInLocal(fromClip, this->parallelProjection)));
  for (const glm::dvec4& plane : this->planes)
    append(plane * move);
}

void CellScene::SetUniforms(vtkShaderProgram* program) const
{
  const glm::dmat4 clipToIndex = glm::inverse(this->indexToClip);
  const glm::vec4 eye = EyeInLocal(clipToIndex, this->parallelProjection);
  const glm::vec2 size(this->viewportSize);
  const glm::vec4 toDevice(
    glm::vec2(2.0F) / size, -2.0F * glm::vec2(this->viewportOrigin) / size - 1.0F);
  SetMatrixUniform(program, "indexToClip", this->indexToClip);
  SetMatrixUniform(program, "clipToIndex", clipToIndex);
  SetMatrixUniform(program, "indexToView", this->indexToView);
  SetMatrixUniform(program, "clipToView", this->indexToView * clipToIndex);
  SetNormalMatrixUniform(program, "normalToView", this->indexToView);
  program->SetUniform4f("eyeIndex", &eye.x);
  program->SetUniform2f("viewport", &size.x);
  program->SetUniform4f("viewportToDevice", &toDevice.x);
  this->SetShadingUniforms(program);
  program->SetUniformf("isovalue", this->isovalue);
  const std::vector<glm::vec4> single(this->planes.begin(), this->planes.end());
  program->SetUniform4fv("planes", static_cast<int>(single.size()), &single[0].x);
}

void CellScene::SetBoxUniforms(vtkShaderProgram* program) const
{
  const glm::dmat4 clipToIndex = glm::inverse(this->indexToClip);
  const glm::vec4 eye = EyeInLocal(clipToIndex, this->parallelProjection);
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
  SetMatrixUniform(program, "indexToClip", this->indexToClip);
  program->SetUniform4f("eyeIndex", &eye.x);
  program->SetUniform3f("voxelsPerPixel", &voxelsPerPixel.x);
  program->SetUniformf("roundingVoxels", static_cast<float>(0.01 + 1e-6 * far));
  program->SetUniform2f("viewport", &size.x);
}
