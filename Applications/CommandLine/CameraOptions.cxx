#include "CameraOptions.h"

#include "Failure.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

const AnatomicalView& Named(const std::string& name)
{
  std::string known;
  for (const AnatomicalView& view : AnatomicalViews())
  {
    if (view.name == name)
      return view;
    known += (known.empty() ? "" : ", ") + std::string(view.name);
  }
  throw Failure(ExitCode::WrongUse, "unknown view '" + name + "'; known are " + known);
}

std::array<double, 3> Unit(std::array<double, 3> vector, const char* option)
{
  const double length = vtkMath::Norm(vector.data());
  if (!(length > 0.0) || !std::isfinite(length))
    throw Failure(ExitCode::WrongUse, std::string(option) + " must be a vector of some length");
  vtkMath::Normalize(vector.data());
  return vector;
}

/// Where no up is given: the patient's head, and for a view along the body the face.
std::array<double, 3> UsualUp(const std::array<double, 3>& direction)
{
  if (std::abs(direction[2]) < 0.999)
    return { 0, 0, 1 };
  return { 0, -1, 0 };
}

/// Radius of a ball that fills a view of that aspect, through its distance: as ResetCamera has it.
double HalfSine(vtkCamera* camera, double aspect)
{
  const double tangent = std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  return std::sin(std::atan(tangent * std::min(1.0, aspect)));
}

} // namespace

const std::vector<AnatomicalView>& AnatomicalViews()
{
  static const std::vector<AnatomicalView> views{
    { "front", { 0, 1, 0 }, { 0, 0, 1 } },
    { "right", { 1, 0, 0 }, { 0, 0, 1 } },
    { "left", { -1, 0, 0 }, { 0, 0, 1 } },
    { "back", { 0, -1, 0 }, { 0, 0, 1 } },
    { "top", { 0, 0, -1 }, { 0, -1, 0 } },
    { "bottom", { 0, 0, 1 }, { 0, -1, 0 } },
  };
  return views;
}

void PlaceCamera(vtkRenderer* renderer, const CameraOptions& options)
{
  if (!(options.zoom > 0.0) || !std::isfinite(options.zoom))
    throw Failure(ExitCode::WrongUse, "--zoom must be > 0");
  const AnatomicalView& view = Named(options.view);
  const auto direction = Unit(options.direction.value_or(view.direction), "--camera-direction");
  const auto up =
    Unit(options.viewUp.value_or(options.direction ? UsualUp(direction) : view.up), "--view-up");
  if (std::abs(vtkMath::Dot(direction.data(), up.data())) > 0.9999) // within 0.8 degrees
    throw Failure(
      ExitCode::WrongUse, "--view-up is parallel to the viewing direction; give one across it");
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(-direction[0], -direction[1], -direction[2]);
  camera->SetViewUp(up.data());
  renderer->ResetCamera();
  if (options.aspect) // ResetCamera went by the window's
    camera->Dolly(
      HalfSine(camera, *options.aspect) / HalfSine(camera, renderer->GetTiledAspectRatio()));
  camera->Zoom(options.zoom);
  renderer->ResetCameraClippingRange();
}

} // namespace hasp
