#include "vtkHaspStereoCamera.h"

#include "vtkCamera.h"

#include <glm/geometric.hpp>

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

} // namespace

void SetCameraToEye(vtkCamera* camera, const StereoRig& rig, StereoEye eye)
{
  const EyeView view = ViewOfEye(rig, eye);
  constexpr double widest = 179.0; // vtkCamera clamps there: the picture would be wrong
  if (view.viewAngleDegrees > widest)
    throw std::invalid_argument(
      "stereo: the screen's height fills " + std::to_string(view.viewAngleDegrees) +
      " degrees of the eye's view, VTK allows " + std::to_string(widest) + "; move the eye back");
  camera->SetUseOffAxisProjection(false);
  camera->SetParallelProjection(false);
  camera->SetUseHorizontalViewAngle(false);
  camera->SetViewShear(0, 0, 1);
  camera->SetPosition(view.position.x, view.position.y, view.position.z);
  camera->SetFocalPoint(view.focalPoint.x, view.focalPoint.y, view.focalPoint.z);
  camera->SetViewUp(view.viewUp.x, view.viewUp.y, view.viewUp.z);
  camera->SetViewAngle(view.viewAngleDegrees);
  camera->SetWindowCenter(view.windowCenter.x, view.windowCenter.y);
  camera->SetLeftEye(eye == StereoEye::Left);
}

StereoRig RigFromCamera(vtkCamera* camera, double aspect, double eyeAngleDegrees)
{
  if (!(aspect > 0.0) || !std::isfinite(aspect))
    throw std::invalid_argument(
      "stereo: the viewport's aspect is " + std::to_string(aspect) + ", must be > 0");
  if (!(eyeAngleDegrees >= 0.0 && eyeAngleDegrees <= 90.0))
    throw std::invalid_argument("stereo: the eye angle is " + std::to_string(eyeAngleDegrees) +
                                " degrees, must be in [0, 90]");
  if (camera->GetParallelProjection())
    throw std::invalid_argument(
      "stereo: a parallel projection has no eye; switch the camera to perspective");
  double shear[3];
  camera->GetViewShear(shear);
  if (camera->GetUseOffAxisProjection() || shear[0] != 0.0 || shear[1] != 0.0)
    throw std::invalid_argument("stereo: the camera has an off-axis projection or a shear already; "
                                "give the rig itself instead");
  glm::dvec3 position, focalPoint, viewUp;
  camera->GetPosition(&position.x);
  camera->GetFocalPoint(&focalPoint.x);
  camera->GetViewUp(&viewUp.x);
  const double distance = glm::length(focalPoint - position);
  const glm::dvec3 forward = (focalPoint - position) / distance;
  const glm::dvec3 right = glm::normalize(glm::cross(forward, viewUp));
  const glm::dvec3 up = glm::cross(right, forward);
  const double half = distance * HalfTangent(camera->GetViewAngle());
  const bool horizontal = camera->GetUseHorizontalViewAngle();
  const double halfWidth = horizontal ? half : aspect * half;
  const double halfHeight = horizontal ? half / aspect : half;
  double window[2];
  camera->GetWindowCenter(window);
  StereoRig rig;
  rig.screen = { focalPoint + window[0] * halfWidth * right + window[1] * halfHeight * up, right,
    up, 2.0 * halfWidth, 2.0 * halfHeight };
  rig.head = { position, right, 2.0 * distance * HalfTangent(eyeAngleDegrees) };
  ValidateStereoRig(rig);
  return rig;
}

} // namespace hasp
