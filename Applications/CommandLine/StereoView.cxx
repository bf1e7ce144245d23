#include "StereoView.h"

#include "Devices/MouseHeadPose.h"
#include "Failure.h"
#include "HeadChoices.h"
#include "PictureFile.h"
#include "StereoSketch.h"
#include "TrackedViewer.h"
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

struct StereoView::Parts
{
  vtkRenderer* renderer;
  vtkRenderWindow* pointed; ///< the window whose pixels are asked for
  StereoChoices choices;
  StereoWindow settings;
  StereoHead head;
  std::unique_ptr<HeadTracker> tracker;
  TrackedHead drawn;       ///< in the last frame
  int unseen = 0;          ///< frames whose head saw nothing of the screen
  bool saidUnseen = false; ///< that there are such
  vtkNew<vtkHaspStereoWindows> windows;

  /// Millimetres of the world in one of the room.
  double Scale() const
  {
    const glm::dmat4 roomToWorld = RoomOnScreen(
      this->renderer->GetActiveCamera(), this->settings.screen.value_or(StereoScreen{}));
    return std::cbrt(glm::determinant(glm::dmat3(roomToWorld)));
  }
  bool EyesApart() const
  {
    const StereoLayout layout = this->settings.output.layout;
    return layout == StereoLayout::SideBySide || layout == StereoLayout::TopBottom;
  }
  bool Placed() const { return this->settings.screen || this->settings.hmd; }
};

StereoView::StereoView(vtkRenderer* renderer, vtkRenderWindow* window, const StereoChoices& choices,
  std::unique_ptr<HeadTracker> tracker, vtkRenderWindow* right)
  : Self(new Parts{ renderer, window, choices, MakeStereoWindow(choices), RoomHead(choices),
      std::move(tracker), {}, 0, false, {} })
{
  Parts& self = *this->Self;
  self.windows->SetRenderer(renderer);
  self.windows->SetEyeAngle(choices.eyeAngle.value_or(2.0));
  self.windows->SetHead(self.head);
  if (self.settings.output.layout == StereoLayout::DualWindow)
    self.windows->AddDualWindow(window, right, self.settings);
  else
    self.windows->AddWindow(window, self.settings);
  this->CameraPlaced();
  ThrowVtkError(ExitCode::WrongUse, "cannot draw for these eyes");
}

StereoView::~StereoView() = default;

void StereoView::CameraPlaced()
{
  const Parts& self = *this->Self;
  if (!self.choices.lifeSize)
    return;
  ShowLifeSize(self.renderer->GetActiveCamera(), self.settings.screen.value_or(StereoScreen{}));
  self.renderer->ResetCameraClippingRange();
}

bool StereoView::Draw(double nowS)
{
  Parts& self = *this->Self;
  if (self.tracker)
  {
    self.drawn = self.tracker->At(nowS);
    const StereoHead head = HeadOf(self.drawn.pose, self.head.eyeSeparationMm);
    if (Sees(head, self.settings))
      self.windows->SetHead(head);
    else
      ++self.unseen;
  }
  return self.windows->Render();
}

bool StereoView::HeadMoved(double nowS)
{
  Parts& self = *this->Self;
  if (!self.tracker)
    return false;
  const TrackedHead head = self.tracker->At(nowS);
  return head.state != self.drawn.state || Differ(head.pose, self.drawn.pose);
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

void StereoView::PointIn(vtkRenderWindow* window)
{
  this->Self->pointed = window;
}

std::optional<std::pair<WorldPoint, WorldPoint>> StereoView::RayOf(int x, int y) const
{
  const Parts& self = *this->Self;
  glm::dvec3 eye, through;
  if (!self.windows->GetRay(self.pointed, x, y, &eye.x, &through.x))
    return std::nullopt;
  double bounds[6];
  self.renderer->ComputeVisiblePropBounds(bounds);
  const glm::dvec3 low(bounds[0], bounds[2], bounds[4]), high(bounds[1], bounds[3], bounds[5]);
  const double far = glm::distance(eye, 0.5 * (low + high)) + glm::distance(low, high);
  const glm::dvec3 end = eye + far * glm::normalize(through - eye);
  return std::pair{ WorldPoint{ eye.x, eye.y, eye.z }, WorldPoint{ end.x, end.y, end.z } };
}

std::optional<StereoView::ViewPosition> StereoView::PositionInView(int x, int y) const
{
  const Parts& self = *this->Self;
  StereoEye eye = StereoEye::Left;
  double device[2];
  if (!self.windows->GetPositionInView(self.pointed, x, y, eye, device))
    return std::nullopt;
  return ViewPosition{ device[0], device[1], self.EyesApart(), eye == StereoEye::Right };
}

std::optional<StereoView::ViewPosition> StereoView::PositionInEye(bool rightEye, int x, int y) const
{
  const Parts& self = *this->Self;
  double device[2];
  if (!self.windows->GetPositionInViewOf(
        rightEye ? StereoEye::Right : StereoEye::Left, self.pointed, x, y, device))
    return std::nullopt;
  return ViewPosition{ device[0], device[1], self.EyesApart(), rightEye };
}

std::string StereoView::Text() const
{
  const Parts& self = *this->Self;
  std::string text;
  if (self.Placed())
  {
    char size[60];
    std::snprintf(size, sizeof size, "at %.0f %% of life size", 100.0 / self.Scale());
    text = size;
  }
  if (self.tracker)
    text.append(text.empty() ? "" : "\n")
      .append(HeadText(self.drawn, self.tracker->Source().Name()));
  return text;
}

std::vector<std::string> StereoView::TakeWarnings()
{
  Parts& self = *this->Self;
  if (!self.tracker)
    return {};
  std::vector<std::string> warnings = self.tracker->TakeWarnings();
  if (self.unseen > 0 && !std::exchange(self.saidUnseen, true))
    warnings.push_back("the head is behind the screen or too close to it, where nothing can be "
                       "seen; the view stays. Is the tracker calibrated?");
  return warnings;
}

std::string StereoView::SketchPng(const std::optional<ContentBox>& content) const
{
  const Parts& self = *this->Self;
  const StereoScreen& screen = *self.settings.screen; // --sketch needs --screen
  const glm::dmat4 roomToWorld = RoomOnScreen(self.renderer->GetActiveCamera(), screen);
  const double scale = std::cbrt(glm::determinant(glm::dmat3(roomToWorld)));
  char title[160];
  std::snprintf(title, sizeof title,
    "%s, at %.0f %% of life size (a mm on the screen is %.2f mm of the patient)",
    StereoLayoutName(self.settings.output.layout), 100.0 / scale, scale);
  StereoSketch sketch{ title, { screen, self.head }, self.settings.output.layout };
  if (content)
  {
    const WorldBounds& box = content->bounds;
    sketch.contentIsVolume = content->ofVolume;
    sketch.content.emplace();
    for (int n = 0; n < 8; ++n)
      (*sketch.content)[n] =
        glm::dvec3(glm::inverse(roomToWorld) *
                   glm::dvec4(box[n & 1], box[2 + (n >> 1 & 1)], box[4 + (n >> 2)], 1.0));
  }
  return PngFile(DrawStereoSketch(sketch));
}

void StereoView::ListResources(ResourceList& list) const
{
  this->Self->windows->ListResources(list);
  list.push_back({ "head tracker", 0, 0.0,
    this->Self->tracker ? this->Self->tracker->Source().Name() : "no --head was given" });
}

} // namespace hasp
