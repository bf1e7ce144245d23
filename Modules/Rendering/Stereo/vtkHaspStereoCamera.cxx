#include "vtkHaspStereoCamera.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkMatrixToHomogeneousTransform.h"
#include "vtkNew.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{

double HalfTangent(double degrees)
{
  return std::tan(0.5 * degrees * std::numbers::pi / 180.0);
}

void RequirePerspective(vtkCamera* camera)
{
  if (camera->GetParallelProjection())
    throw std::invalid_argument(
      "stereo: a parallel projection has no eye; switch the camera to perspective");
  double shear[3];
  camera->GetViewShear(shear);
  if (camera->GetUseOffAxisProjection() || shear[0] != 0.0 || shear[1] != 0.0)
    throw std::invalid_argument("stereo: the camera has an off-axis projection or a shear already; "
                                "give the rig itself instead");
  if (camera->GetUseExplicitProjectionTransformMatrix() || camera->GetUseExplicitAspectRatio())
    throw std::invalid_argument(
      "stereo: the camera has an explicit projection or aspect, which says "
      "nothing of eyes; give the rig itself instead");
}

/// What a perspective camera sees at its focal point. A view up along the axis gives NaN,
/// which ValidateStereoRig and TransformStereoRig refuse.
struct Look
{
  explicit Look(vtkCamera* camera)
  {
    glm::dvec3 viewUp;
    camera->GetPosition(&this->position.x);
    camera->GetFocalPoint(&this->focalPoint.x);
    camera->GetViewUp(&viewUp.x);
    this->distance = glm::length(this->focalPoint - this->position);
    const glm::dvec3 forward = (this->focalPoint - this->position) / this->distance;
    this->right = glm::normalize(glm::cross(forward, viewUp));
    this->up = glm::cross(this->right, forward);
    this->half = this->distance * HalfTangent(camera->GetViewAngle());
  }
  glm::dvec3 position, focalPoint, right, up;
  double distance, half; ///< half: of the height there, or of the width
};

void SetAxes(vtkCamera* camera, const EyeView& view, StereoEye eye)
{
  constexpr double widest = 179.0; // vtkCamera clamps there: the picture would be wrong
  if (view.viewAngleDegrees > widest)
    throw std::invalid_argument(
      "stereo: the screen's height fills " + std::to_string(view.viewAngleDegrees) +
      " degrees of the eye's view, VTK allows " + std::to_string(widest) + "; move the eye back");
  camera->SetUseOffAxisProjection(false);
  camera->SetParallelProjection(false);
  camera->SetUseHorizontalViewAngle(false);
  camera->SetUseExplicitProjectionTransformMatrix(false);
  camera->SetUseExplicitAspectRatio(false);
  camera->SetViewShear(0, 0, 1);
  camera->SetPosition(view.position.x, view.position.y, view.position.z);
  camera->SetFocalPoint(view.focalPoint.x, view.focalPoint.y, view.focalPoint.z);
  camera->SetViewUp(view.viewUp.x, view.viewUp.y, view.viewUp.z);
  camera->SetViewAngle(view.viewAngleDegrees);
  camera->SetWindowCenter(view.windowCenter.x, view.windowCenter.y);
  camera->SetLeftEye(eye == StereoEye::Left);
}

} // namespace

void SetCameraToEye(vtkCamera* camera, const StereoRig& rig, StereoEye eye)
{
  SetAxes(camera, ViewOfEye(rig, eye), eye);
}

void SetCameraToView(vtkCamera* camera, const EyeView& view, StereoEye eye, const EyeGrid& grid)
{
  SetAxes(camera, view, eye);
  // VTK's projection has the aspect of the viewport; x of the view is `squeeze` times its x.
  const double squeeze = grid.size.x / (grid.size.y * view.aspect);
  if (std::abs(squeeze - 1.0) < 1e-12 && glm::length(grid.scale - 1.0) < 1e-12 &&
      grid.shift == glm::dvec2(0.0))
    return;
  camera->SetWindowCenter(view.windowCenter.x / squeeze, view.windowCenter.y);
  vtkNew<vtkMatrix4x4> stretch; // the view, what the user does with it, the pixels drawn of that
  stretch->SetElement(0, 0, squeeze);
  if (camera->GetUserTransform())
    vtkMatrix4x4::Multiply4x4(camera->GetUserTransform()->GetMatrix(), stretch, stretch);
  vtkNew<vtkMatrix4x4> pixels;
  pixels->SetElement(0, 0, grid.scale.x);
  pixels->SetElement(1, 1, grid.scale.y);
  pixels->SetElement(0, 3, grid.shift.x);
  pixels->SetElement(1, 3, grid.shift.y);
  vtkMatrix4x4::Multiply4x4(pixels, stretch, stretch);
  vtkNew<vtkMatrixToHomogeneousTransform> transform;
  transform->SetInput(stretch);
  camera->SetUserTransform(transform);
}

StereoRig RigFromCamera(vtkCamera* camera, double aspect, double eyeAngleDegrees)
{
  if (!(aspect > 0.0) || !std::isfinite(aspect))
    throw std::invalid_argument(
      "stereo: the viewport's aspect is " + std::to_string(aspect) + ", must be > 0");
  if (!(eyeAngleDegrees >= 0.0 && eyeAngleDegrees <= 90.0))
    throw std::invalid_argument("stereo: the eye angle is " + std::to_string(eyeAngleDegrees) +
                                " degrees, must be in [0, 90]");
  RequirePerspective(camera);
  const Look look(camera);
  const bool horizontal = camera->GetUseHorizontalViewAngle();
  const double halfWidth = horizontal ? look.half : aspect * look.half;
  const double halfHeight = horizontal ? look.half / aspect : look.half;
  double window[2];
  camera->GetWindowCenter(window);
  StereoRig rig;
  rig.screen = { look.focalPoint + window[0] * halfWidth * look.right +
                   window[1] * halfHeight * look.up,
    look.right, look.up, 2.0 * halfWidth, 2.0 * halfHeight };
  rig.head = { look.position, look.right, 2.0 * look.distance * HalfTangent(eyeAngleDegrees),
    look.up };
  ValidateStereoRig(rig);
  return rig;
}

glm::dmat4 RoomOnScreen(vtkCamera* camera, const StereoScreen& screen)
{
  RequirePerspective(camera);
  StereoRig rig; // a viewer before the middle, for the check of the screen
  rig.screen = screen;
  rig.head.right = screen.right;
  rig.head.position = screen.center + glm::cross(screen.right, screen.up);
  rig.head.eyeSeparationMm = 0.0;
  ValidateStereoRig(rig);
  const Look look(camera);
  const double size = camera->GetUseHorizontalViewAngle() ? screen.widthMm : screen.heightMm;
  const glm::dvec3 right = glm::normalize(screen.right), up = glm::normalize(screen.up);
  const glm::dmat3 roomAxes(right, up, glm::cross(right, up));
  const glm::dmat3 lookAxes(look.right, look.up, glm::cross(look.right, look.up));
  const glm::dmat3 turned = (2.0 * look.half / size) * lookAxes * glm::transpose(roomAxes);
  return glm::translate(glm::dmat4(1.0), look.focalPoint) * glm::dmat4(turned) *
         glm::translate(glm::dmat4(1.0), -screen.center);
}

StereoRig RigOnScreen(vtkCamera* camera, const StereoRig& roomRig)
{
  return TransformStereoRig(roomRig, RoomOnScreen(camera, roomRig.screen));
}

void ShowLifeSize(vtkCamera* camera, const StereoScreen& screen)
{
  RoomOnScreen(camera, screen); // throws what is wrong with either
  const Look look(camera);
  const double size = camera->GetUseHorizontalViewAngle() ? screen.widthMm : screen.heightMm;
  const glm::dvec3 position =
    look.focalPoint + (look.position - look.focalPoint) * (0.5 * size / look.half);
  camera->SetPosition(position.x, position.y, position.z);
}

} // namespace hasp
