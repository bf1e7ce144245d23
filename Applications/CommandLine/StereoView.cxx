#include "StereoView.h"

#include "Devices/MouseHeadPose.h"
#include "Failure.h"
#include "HeadChoices.h"
#include "PictureFile.h"
#include "StereoSketch.h"
#include "VtkMessages.h"
#include "vtkHaspStereoCamera.h"
#include "vtkHaspStereoWindows.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace hasp
{
namespace
{

StereoHead HeadOf(const HeadPose& pose, double eyeSeparationMm)
{
  StereoHead head;
  head.position = pose.position;
  head.right = pose.orientation * glm::dvec3(1, 0, 0);
  head.up = pose.orientation * glm::dvec3(0, 1, 0);
  head.eyeSeparationMm = eyeSeparationMm;
  return head;
}

bool Differ(const HeadPose& a, const HeadPose& b)
{
  constexpr double mm = 0.1, degrees = 0.02;
  const double halfTurn = std::abs(glm::dot(a.orientation, b.orientation)); // cosine
  return glm::distance(a.position, b.position) > mm ||
         halfTurn < std::cos(0.5 * glm::radians(degrees));
}

} // namespace

struct StereoView::Parts
{
  vtkRenderer* renderer;
  vtkRenderWindow* window;
  StereoChoices choices;
  StereoWindow settings;
  StereoHead head;
  std::unique_ptr<HeadTracker> tracker;
  TrackedHead drawn; ///< in the last frame
  vtkSmartPointer<vtkRenderWindow> rightWindow;
  vtkNew<vtkHaspStereoWindows> windows;

  void AddWindows()
  {
    if (this->settings.output.layout != StereoLayout::DualWindow)
    {
      this->windows->AddWindow(this->window, this->settings);
      return;
    }
    this->rightWindow = vtkSmartPointer<vtkRenderWindow>::New();
    this->rightWindow->SetOffScreenRendering(this->window->GetOffScreenRendering());
    this->rightWindow->SetWindowName("hasp view, right eye");
    this->rightWindow->SetSize(this->window->GetSize());
    this->windows->AddDualWindow(this->window, this->rightWindow, this->settings);
  }
};

StereoView::StereoView(vtkRenderer* renderer, vtkRenderWindow* window, const StereoChoices& choices,
  std::unique_ptr<HeadTracker> tracker)
  : Self(new Parts{ renderer, window, choices, MakeStereoWindow(choices), RoomHead(choices),
      std::move(tracker), {}, nullptr, {} })
{
  Parts& self = *this->Self;
  self.windows->SetRenderer(renderer);
  self.windows->SetEyeAngle(choices.eyeAngle.value_or(2.0));
  self.windows->SetHead(self.head);
  self.AddWindows();
  if (choices.lifeSize)
  {
    ShowLifeSize(renderer->GetActiveCamera(), *self.settings.screen);
    renderer->ResetCameraClippingRange();
  }
  ThrowVtkError(ExitCode::WrongUse, "cannot draw for these eyes");
}

StereoView::~StereoView() = default;

bool StereoView::Draw(double nowS)
{
  Parts& self = *this->Self;
  if (self.tracker)
  {
    self.drawn = self.tracker->At(nowS);
    self.windows->SetHead(HeadOf(self.drawn.pose, self.head.eyeSeparationMm));
  }
  return self.windows->Render();
}

bool StereoView::HeadMoved(double nowS)
{
  Parts& self = *this->Self;
  return self.tracker && Differ(self.tracker->At(nowS).pose, self.drawn.pose);
}

bool StereoView::IsTracked() const
{
  return this->Self->tracker != nullptr;
}

void StereoView::PointAt(double x, double y)
{
  if (!this->Self->tracker)
    return;
  if (auto* mouse = dynamic_cast<MouseHeadPose*>(&this->Self->tracker->Source()))
    mouse->SetPosition({ x, y });
}

std::optional<std::pair<WorldPoint, WorldPoint>> StereoView::RayOf(int x, int y) const
{
  const Parts& self = *this->Self;
  glm::dvec3 eye, through;
  if (!self.windows->GetRay(self.window, x, y, &eye.x, &through.x))
    return std::nullopt;
  double bounds[6];
  self.renderer->ComputeVisiblePropBounds(bounds);
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  const double far = glm::distance(eye, 0.5 * (low + high)) + glm::distance(low, high);
  const glm::dvec3 end = eye + far * glm::normalize(through - eye);
  return std::pair{ WorldPoint{ eye.x, eye.y, eye.z }, WorldPoint{ end.x, end.y, end.z } };
}

std::string StereoView::Text() const
{
  const Parts& self = *this->Self;
  return self.tracker ? HeadText(self.drawn, self.tracker->Source().Name()) : std::string();
}

std::vector<std::string> StereoView::TakeWarnings()
{
  return this->Self->tracker ? this->Self->tracker->TakeWarnings() : std::vector<std::string>();
}

std::string StereoView::SketchPng() const
{
  const Parts& self = *this->Self;
  const StereoScreen& screen = *self.settings.screen; // --sketch needs --screen
  const glm::dmat4 roomToWorld = RoomOnScreen(self.renderer->GetActiveCamera(), screen);
  const double scale = std::cbrt(glm::determinant(glm::dmat3(roomToWorld)));
  char title[160];
  std::snprintf(title, sizeof title, "%s, at %.0f %% of life size (a mm on the screen is %.2f mm)",
    StereoLayoutName(self.settings.output.layout), 100.0 / scale, scale);
  StereoSketch sketch{ title, { screen, self.head }, std::array<glm::dvec3, 8>{} };
  double bounds[6];
  self.renderer->ComputeVisiblePropBounds(bounds);
  for (int n = 0; n < 8; ++n)
    (*sketch.content)[n] =
      glm::dvec3(glm::inverse(roomToWorld) *
                 glm::dvec4(bounds[n & 1], bounds[2 + (n >> 1 & 1)], bounds[4 + (n >> 2)], 1.0));
  return PngFile(DrawStereoSketch(sketch));
}

void StereoView::ListResources(ResourceList& list) const
{
  this->Self->windows->ListResources(list);
  list.push_back({ "head tracker", 0, 0.0,
    this->Self->tracker ? this->Self->tracker->Source().Name() : "no --head was given" });
}

} // namespace hasp
