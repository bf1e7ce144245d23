#include "WindowDrawing.h"

#include "BorrowedView.h"
#include "HaspGL.h"
#include "WindowTextures.h"
#include "vtkHaspStereoCamera.h"

#include "vtkCamera.h"
#include "vtkHomogeneousTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

using hasp::StereoEye;
using hasp::StereoLayout;

namespace
{

void RequireQuadBuffers(vtkOpenGLRenderWindow* window)
{
  window->Initialize(); // VTK withdraws the promise where the driver gives no such window
  bool there = window->GetStereoCapableWindow();
  if (there && !window->GetUseOffScreenBuffers())
  {
    vtkOpenGLState* state = window->GetState();
    window->MakeCurrent();
    state->PushFramebufferBindings();
    state->vtkglBindFramebuffer(GL_FRAMEBUFFER, 0);
    GLboolean stereo = GL_FALSE;
    glGetBooleanv(GL_STEREO, &stereo);
    state->PopFramebufferBindings();
    there = stereo;
  }
  if (!there)
    throw std::runtime_error(
      "stereo: the window has no quad buffers: this display's driver gives none, or the program "
      "did "
      "not call StereoCapableWindowOn() before it was first drawn; take another layout "
      "(side-by-side, interlaced)");
}

/// While one lives, the window's frames go to the left and right buffer.
class QuadBuffers
{
public:
  explicit QuadBuffers(vtkRenderWindow* w)
    : window(w),
      type(w->GetStereoType()),
      render(w->GetStereoRender())
  {
    w->SetStereoTypeToCrystalEyes();
    w->SetStereoRender(true);
  }
  ~QuadBuffers()
  {
    this->window->SetStereoRender(this->render);
    this->window->SetStereoType(this->type);
  }
  QuadBuffers(const QuadBuffers&) = delete;
  QuadBuffers& operator=(const QuadBuffers&) = delete;

private:
  vtkRenderWindow* window;
  int type, render;
};

/// Where the camera itself sees what its user transform, if it has one, shows at `device`. Right
/// for what turns, moves and scales the view; one that depends on depth has no straight rays.
glm::dvec2 BeforeUser(vtkCamera* camera, glm::dvec2 device)
{
  if (!camera->GetUserTransform())
    return device;
  vtkNew<vtkMatrix4x4> back;
  vtkMatrix4x4::Invert(camera->GetUserTransform()->GetMatrix(), back);
  const double shown[4] = { device.x, device.y, 0.0, 1.0 };
  double seen[4];
  back->MultiplyPoint(shown, seen);
  return glm::dvec2(seen[0], seen[1]) / seen[3];
}

bool IsPlain(const hasp::StereoWindow& set)
{
  return !hasp::NeedsSecondEye(set.output.layout) && set.output.flip == hasp::MirrorFlip::None &&
         !set.lens;
}

} // namespace

WindowDrawing::WindowDrawing(vtkRenderWindow* window, const hasp::StereoWindow& settings)
  : Shown(window),
    Set(settings)
{
}

void WindowDrawing::ChangeSettings(const hasp::StereoWindow& settings)
{
  this->Set = settings;
  this->LensSize = glm::ivec2(0); // it may be another lens
}

bool WindowDrawing::IsNews(const std::string& error)
{
  return std::exchange(this->LastError, error) != error;
}

vtkRenderer* WindowDrawing::RendererFor(const ViewedScene& scene)
{
  if (scene.renderer->GetRenderWindow() == this->Shown)
  {
    this->Follower.reset();
    return scene.renderer;
  }
  if (!this->Follower || this->Follower->Renderer()->GetRenderWindow() != this->Shown)
    this->Follower = std::make_unique<SceneFollower>(this->Shown);
  this->Follower->Follow(scene.renderer);
  return this->Follower->Renderer();
}

void WindowDrawing::Leave(const ViewedScene& scene)
{
  if (this->Shown)
    ReleaseTextures(this->RendererFor(scene));
}

std::array<hasp::EyeView, 2> WindowDrawing::Views(const ViewedScene& scene, glm::ivec2 size) const
{
  if (this->Set.screen || this->Set.hmd)
    return hasp::ViewsOfEyes(this->Set, scene.head, scene.roomToWorld);
  glm::dvec2 shape(size);
  if (this->Set.output.resolution == hasp::StereoResolution::Full)
    shape = hasp::GridOfEye(this->Set.output, size, StereoEye::Left).size;
  const bool mono = this->Set.output.layout == StereoLayout::Mono;
  const hasp::StereoRig rig = hasp::RigFromCamera(
    scene.renderer->GetActiveCamera(), shape.x / shape.y, mono ? 0.0 : scene.eyeAngle);
  return { hasp::ViewOfEye(rig, StereoEye::Left), hasp::ViewOfEye(rig, StereoEye::Right) };
}

void WindowDrawing::UpdateLenses(const std::array<hasp::EyeView, 2>& views, glm::ivec2 eyeSize)
{
  const glm::dvec2 aspects(views[0].aspect, views[1].aspect);
  if (this->LensSize == eyeSize && this->LensAspects == aspects)
    return;
  this->LensSize = glm::ivec2(0);
  this->Output.SetLenses({});
  if (this->Set.lens)
    this->Output.SetLenses(
      { hasp::MakeLensTable(*this->Set.lens, StereoEye::Left, eyeSize, aspects.x),
        hasp::MakeLensTable(*this->Set.lens, StereoEye::Right, eyeSize, aspects.y) });
  this->LensSize = eyeSize;
  this->LensAspects = aspects;
}

void WindowDrawing::ShowQuadBuffers(vtkOpenGLRenderWindow* window, const PixelRectangle& target)
{
  hasp::StereoOutput one = this->Set.output;
  const auto compose = [&](bool right)
  {
    one.layout = right != one.swapEyes ? StereoLayout::Right : StereoLayout::Left;
    this->Output.Compose(window, one, target);
  };
  const QuadBuffers both(window);
  compose(false);
  window->StereoMidpoint(); // VTK puts the frame aside as the left buffer's
  compose(true);
  window->Frame();
}

void WindowDrawing::DrawEyes(
  vtkOpenGLRenderWindow* window, BorrowedView& view, const std::array<hasp::EyeView, 2>& views)
{
  const hasp::StereoOutput& output = this->Set.output;
  const PixelRectangle target{ view.Origin(), view.Size() };
  const auto gridOf = [&](StereoEye eye) { return hasp::GridOfEye(output, target.size, eye); };
  const auto draw = [&](StereoEye eye)
  {
    const hasp::EyeGrid grid = gridOf(eye);
    view.Draw(views[eye == StereoEye::Right], eye, grid);
    window->MakeCurrent();
    this->Output.Keep(window, eye, { target.origin, grid.size });
    return grid.size;
  };
  const bool both = hasp::NeedsSecondEye(output.layout);
  const bool rightAlone = output.layout == StereoLayout::Right;
  if (both)
    view.Announce({ views[0], gridOf(StereoEye::Left) }, { views[1], gridOf(StereoEye::Right) });
  const glm::ivec2 eyeSize = draw(rightAlone ? StereoEye::Right : StereoEye::Left);
  if (both)
  {
    const auto start = std::chrono::steady_clock::now();
    draw(StereoEye::Right);
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - start;
    this->SecondEye = spent.count();
  }
  else
    this->Output.ForgetPicture(rightAlone ? StereoEye::Left : StereoEye::Right);
  this->UpdateLenses(views, eyeSize);
  view.ShowFrames();
  if (output.layout == StereoLayout::QuadBuffer)
  {
    this->ShowQuadBuffers(window, target);
    return;
  }
  this->Output.Compose(window, output, target);
  window->Frame();
}

void WindowDrawing::Draw(const ViewedScene& scene)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Shown);
  if (!window)
    throw std::invalid_argument("stereo: the window is no OpenGL window");
  this->SecondEye = 0.0;
  if (this->Set.output.layout == StereoLayout::QuadBuffer)
    RequireQuadBuffers(window);
  vtkRenderer* renderer = this->RendererFor(scene);
  if (window->GetSize()[0] < 1)
    window->Initialize(); // it takes VTK's default size
  const glm::ivec2 size = ViewportSize(renderer);
  const auto views = this->Views(scene, size);
  BorrowedView view(renderer, scene.renderer->GetActiveCamera());
  if (!IsPlain(this->Set))
  {
    this->DrawEyes(window, view, views);
    return;
  }
  this->Output.Release();
  this->LensSize = glm::ivec2(0);
  const StereoEye eye =
    this->Set.output.layout == StereoLayout::Right ? StereoEye::Right : StereoEye::Left;
  view.ShowFrames(); // this one
  view.Draw(views[eye == StereoEye::Right], eye, hasp::GridOfEye(this->Set.output, size, eye));
}

std::optional<WindowDrawing::Position> WindowDrawing::FindPosition(
  const ViewedScene& scene, glm::ivec2 pixel, std::optional<StereoEye> of)
{
  vtkRenderer* renderer = this->RendererFor(scene);
  const glm::ivec2 size = ViewportSize(renderer);
  glm::ivec2 origin, unused;
  renderer->GetTiledSizeAndOrigin(&unused.x, &unused.y, &origin.x, &origin.y);
  pixel -= origin;
  const hasp::StereoOutput& output = this->Set.output;
  if (!of && (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y))
    return std::nullopt;
  const hasp::EyePixel from = of ? hasp::EyePixel{ *of, hasp::PixelOfEye(output, size, *of, pixel) }
                                 : hasp::EyePixelAt(output, size, pixel);
  const hasp::EyeView view = this->Views(scene, size)[from.eye == StereoEye::Right];
  const hasp::EyeGrid grid = hasp::GridOfEye(output, size, from.eye);
  glm::dvec2 device = 2.0 * (glm::dvec2(from.pixel) + 0.5) / glm::dvec2(grid.size) - 1.0;
  if (this->Set.lens)
  {
    constexpr int green = 1; // the middle of the spectrum
    const glm::dvec2 half(view.aspect, 1.0);
    device = hasp::SeenThroughLens(*this->Set.lens, from.eye, green, device * half) / half;
    if (std::abs(device.x) > 1.0 || std::abs(device.y) > 1.0)
      return std::nullopt;
  }
  device = (device - grid.shift) / grid.scale;
  const glm::dvec2 onScreen = BeforeUser(scene.renderer->GetActiveCamera(), device);
  return Position{ from.eye, device, view.position, hasp::PointOnScreen(view, onScreen) };
}
