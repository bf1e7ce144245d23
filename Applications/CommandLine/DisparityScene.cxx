#include "DisparityScene.h"

#include "Failure.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace hasp
{
namespace
{

const glm::ivec2 Size(DisparityScene::Width, DisparityScene::Height);

/// Whose a display's pixel is: 0 left eye, 1 right eye, -1 both. `top` counts rows from the top.
int EyeOfPixel(StereoLayout layout, int x, int top)
{
  switch (layout)
  {
    case StereoLayout::SideBySide:
      return 2 * x >= Size.x;
    case StereoLayout::TopBottom:
      return 2 * top >= Size.y;
    case StereoLayout::Interlaced:
      return top % 2;
    case StereoLayout::Checkerboard:
      return (top + x) % 2;
    default:
      return -1;
  }
}

/// Where the ball's light has its middle for one eye, in pixels of the screen.
glm::dvec2 Middle(vtkUnsignedCharArray* rgb, StereoLayout layout, int eye)
{
  glm::dvec2 sum(0.0);
  double all = 0.0;
  for (int y = 0; y < Size.y; ++y)
    for (int x = 0; x < Size.x; ++x)
    {
      const int whose = EyeOfPixel(layout, x, Size.y - 1 - y);
      if (whose >= 0 && whose != eye)
        continue;
      const int channel = layout == StereoLayout::Anaglyph && eye == 0 ? 0 : 1;
      const double light = rgb->GetValue(3 * (static_cast<vtkIdType>(y) * Size.x + x) + channel);
      glm::dvec2 at(x + 0.5, y + 0.5);
      if (layout == StereoLayout::SideBySide)
        at.x = std::fmod(2.0 * at.x, Size.x);
      if (layout == StereoLayout::TopBottom)
        at.y = std::fmod(2.0 * at.y, Size.y);
      sum += light * at;
      all += light;
    }
  if (all == 0.0)
    throw Failure(ExitCode::CannotDraw, "stereo report: the ball is not in the picture");
  return sum / all;
}

vtkSmartPointer<vtkUnsignedCharArray> Pixels(vtkRenderWindow* window, bool right = false)
{
  vtkNew<vtkUnsignedCharArray> rgb;
  window->GetPixelData(0, 0, Size.x - 1, Size.y - 1, 1, rgb, right);
  return rgb.Get();
}

int VtkTypeOf(StereoLayout layout)
{
  switch (layout)
  {
    case StereoLayout::SideBySide:
      return VTK_STEREO_SPLITVIEWPORT_HORIZONTAL;
    case StereoLayout::Anaglyph:
      return VTK_STEREO_ANAGLYPH;
    case StereoLayout::Interlaced:
      return VTK_STEREO_INTERLACED;
    case StereoLayout::Checkerboard:
      return VTK_STEREO_CHECKERBOARD;
    case StereoLayout::QuadBuffer:
      return VTK_STEREO_CRYSTAL_EYES;
    default:
      return 0;
  }
}

} // namespace

DisparityScene::DisparityScene(const StereoWindow& window) : Settings(window)
{
  for (auto& shown : this->Shown)
  {
    shown->SetOffScreenRendering(true);
    shown->SetSize(Size.x, Size.y);
  }
  this->SetSamples(4); // an outline that fills pixels in part is known better
  this->Shown[0]->StereoCapableWindowOn();
  this->Shown[0]->AddRenderer(this->Renderer);
  this->Windows->SetRenderer(this->Renderer);
  vtkNew<vtkMatrix4x4> same;
  this->Windows->SetRoomToWorld(same);
  const bool dual = window.output.layout == StereoLayout::DualWindow;
  if (!(dual ? this->Windows->AddDualWindow(this->Shown[0], this->Shown[1], window)
             : this->Windows->AddWindow(this->Shown[0], window)))
    throw Failure(ExitCode::CannotDraw, "stereo report: no window");
}

void DisparityScene::Place(const StereoHead& head, const glm::dvec3& center)
{
  this->Head = head;
  this->Center = center;
  this->Windows->SetHead(head);
  this->Renderer->RemoveAllViewProps();
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(center.x, center.y, center.z);
  ball->SetRadius(RadiusMm);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  this->Renderer->AddActor(actor);
}

glm::dvec2 DisparityScene::Drawn()
{
  if (!this->Windows->Render())
    throw Failure(ExitCode::CannotDraw, "stereo report: no picture");
  const StereoLayout layout = this->Settings.output.layout;
  const auto left = Pixels(this->Shown[0]);
  auto right = left;
  if (layout == StereoLayout::DualWindow)
    right = Pixels(this->Shown[1]);
  else if (layout == StereoLayout::QuadBuffer)
    right = Pixels(this->Shown[0], true);
  return Middle(right, layout, 1) - Middle(left, layout, 0);
}

glm::dvec2 DisparityScene::SeenAt(StereoEye eye) const
{
  // A ball's outline has its middle at tangent * z^2 / (z^2 - r^2): where a point nearer by r^2 / z
  // would be.
  const glm::dvec3 position = EyePosition(this->Head, eye);
  const glm::dvec3 back = this->Settings.hmd
                            ? glm::cross(glm::normalize(this->Head.right), this->Head.up)
                            : glm::dvec3(0, 0, 1); // of the screen
  const double depth = glm::dot(position - this->Center, back);
  const double outline = depth - RadiusMm * RadiusMm / depth;
  if (!this->Settings.hmd)
    return 0.5 * glm::dvec2(Size) *
           ProjectToScreen(
             { *this->Settings.screen, this->Head }, eye, this->Center + (depth - outline) * back);
  const FieldOfView& field = this->Settings.hmd->fields[eye == StereoEye::Right];
  const glm::dvec3 off = this->Center - position;
  const double x = glm::dot(off, glm::normalize(this->Head.right)) / outline;
  const double y = glm::dot(off, this->Head.up) / outline;
  return glm::dvec2(Size) * glm::dvec2((x + field.left) / (field.left + field.right),
                              (y + field.down) / (field.up + field.down));
}

glm::dvec2 DisparityScene::Truth() const
{
  return this->SeenAt(StereoEye::Right) - this->SeenAt(StereoEye::Left);
}

void DisparityScene::LookAsVtk()
{
  const double distance = glm::length(this->Head.position);
  const double height = this->Settings.screen ? this->Settings.screen->heightMm : 325.0;
  const auto degrees = [](double radians) { return radians * 180.0 / std::numbers::pi; };
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(this->Head.position.x, this->Head.position.y, this->Head.position.z);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(degrees(2.0 * std::atan(0.5 * height / distance)));
  camera->SetEyeAngle(degrees(2.0 * std::atan(0.5 * this->Head.eyeSeparationMm / distance)));
  this->Renderer->ResetCameraClippingRange();
}

glm::dvec2 DisparityScene::ByVtk()
{
  this->LookAsVtk();
  vtkRenderWindow* window = this->Shown[0];
  std::array<glm::dvec2, 2> middles;
  window->SetStereoRender(true);
  for (int eye = 0; eye < 2; ++eye)
  {
    window->SetStereoType(eye == 0 ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
    window->Render();
    middles[eye] = Middle(Pixels(window), StereoLayout::Mono, eye);
  }
  window->SetStereoRender(false);
  return middles[1] - middles[0];
}

void DisparityScene::SetSamples(int samples)
{
  for (auto& shown : this->Shown)
    shown->SetMultiSamples(samples);
}

Timing DisparityScene::TimeOurs()
{
  return TimeOf(
    [&]
    {
      this->Windows->Render();
      for (auto& shown : this->Shown)
        shown->WaitForCompletion();
    });
}

const char* DisparityScene::VtkName() const
{
  return VtkTypeOf(this->Settings.output.layout) ? "VTK's stereo of this layout"
                                                 : "VTK: two frames of one eye";
}

Timing DisparityScene::TimeVtk()
{
  this->LookAsVtk();
  vtkRenderWindow* window = this->Shown[0];
  const int type = VtkTypeOf(this->Settings.output.layout);
  if (type != 0)
    window->SetStereoType(type);
  window->SetStereoRender(type != 0);
  const Timing time = TimeOf(
    [&]
    {
      for (int frame = 0; frame < (type != 0 ? 1 : 2); ++frame)
      {
        window->Render();
        window->WaitForCompletion();
      }
    });
  window->SetStereoRender(false);
  return time;
}

} // namespace hasp
