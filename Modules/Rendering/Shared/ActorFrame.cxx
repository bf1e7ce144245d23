#include "ActorFrame.h"

#include "HaspGL.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace
{

/// A row times localToWorld: the same plane in local coordinates.
glm::dvec4 PlaneInLocal(vtkPlane* plane, const glm::dmat4& localToWorld)
{
  const glm::dvec3 normal = glm::make_vec3(plane->GetNormal());
  const glm::dvec3 origin = glm::make_vec3(plane->GetOrigin());
  return glm::dvec4(normal, -glm::dot(normal, origin)) * localToWorld;
}

} // namespace

ActorFrame::ActorFrame(
  vtkMapper* mapper, vtkRenderer* renderer, vtkActor* actor, const glm::dmat4& localToData)
{
  vtkMatrix4x4 *view, *projection,
    *clip; // VTK hands these out with column-major memory, for OpenGL
  vtkMatrix3x3* normal;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, view, normal, projection, clip);
  this->localToWorld = glm::transpose(glm::make_mat4(actor->GetMatrix()->GetData())) * localToData;
  this->localToView = glm::dmat4(glm::make_mat4(view->GetData())) * this->localToWorld;
  this->localToClip = glm::dmat4(glm::make_mat4(clip->GetData())) * this->localToWorld;
  this->parallelProjection = renderer->GetActiveCamera()->GetParallelProjection();
  GLint viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  this->viewportOrigin = { viewport[0], viewport[1] };
  this->viewportSize = { viewport[2], viewport[3] };

  this->planes.push_back(glm::row(this->localToClip, 2) + glm::row(this->localToClip, 3));
  if (vtkPlaneCollection* clipping = mapper->GetClippingPlanes())
    for (int p = 0; p < clipping->GetNumberOfItems(); ++p)
      this->planes.push_back(PlaneInLocal(clipping->GetItem(p), this->localToWorld));
}

glm::vec4 ActorFrame::PixelsToDevice() const
{
  const glm::vec2 size(this->viewportSize);
  return { glm::vec2(2.0F) / size, -2.0F * glm::vec2(this->viewportOrigin) / size - 1.0F };
}

glm::vec4 EyeInLocal(const glm::dmat4& clipToLocal, bool parallel)
{
  const glm::dvec4 eye = clipToLocal * glm::dvec4(0, 0, 1, 0);
  return parallel ? glm::dvec4(-glm::normalize(glm::dvec3(eye)), 0.0) : eye / eye.w;
}

void SetMatrixUniform(vtkShaderProgram* program, const char* name, const glm::dmat4& matrix)
{
  glm::mat4 single(matrix);
  program->SetUniformMatrix4x4(name, glm::value_ptr(single));
}

void SetNormalMatrixUniform(vtkShaderProgram* program, const char* name, const glm::dmat4& points)
{
  glm::mat3 single(glm::transpose(glm::inverse(glm::dmat3(points))));
  program->SetUniformMatrix3x3(name, glm::value_ptr(single));
}
