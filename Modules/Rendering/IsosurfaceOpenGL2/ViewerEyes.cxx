#include "ViewerEyes.h"

#include "HaspGL.h"
#include "OneSampleDepth.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <utility>

namespace
{

constexpr double PredictedFrustum = 1.1; // as wide as the picture's

} // namespace

/// Hears when the renderer begins a frame.
class ViewerEye::FrameObserver : public vtkCommand
{
public:
  explicit FrameObserver(vtkRenderer* renderer) : Renderer(renderer)
  {
    this->Tag = renderer->AddObserver(vtkCommand::StartEvent, this);
  }
  void Execute(vtkObject*, unsigned long, void*) override
  {
    if (this->Renderer->GetSelector())
      return; // nobody looks at what a pick draws
    this->Begins = true;
    ++this->Frames;
  }
  void Stop()
  {
    if (this->Renderer)
      this->Renderer->RemoveObserver(this->Tag);
  }

  vtkWeakPointer<vtkRenderer> Renderer;
  bool Begins = true;
  int Frames = 0; ///< begun since the last one that this eye was drawn in

private:
  unsigned long Tag;
};

ViewerEye::ViewerEye(vtkRenderer* renderer, vtkActor* actor, bool left, int number)
  : Number(number),
    Observer(new FrameObserver(renderer), [](FrameObserver* observer) { observer->Delete(); }),
    Actor(actor),
    Left(left)
{
}

ViewerEye::~ViewerEye()
{
  this->Observer->Stop();
}

bool ViewerEye::Is(vtkRenderer* renderer, vtkActor* actor, bool left) const
{
  return this->Observer->Renderer == renderer && this->Actor == actor && this->Left == left;
}

bool ViewerEye::Lost() const
{
  return !this->Observer->Renderer || !this->Actor;
}

bool ViewerEye::IsBeside(const ViewerEye& other) const
{
  return this->Observer->Renderer == other.Observer->Renderer && this->Actor == other.Actor;
}

bool ViewerEye::IsDrawn(bool stereo) const
{
  return !this->Lost() && this->Observer->Renderer->GetRenderWindow() &&
         this->Observer->Frames < (stereo ? 2 : 1);
}

void ViewerEye::IsDrawnNow()
{
  this->Observer->Frames = 0;
}

bool ViewerEye::BeginsFrame()
{
  return std::exchange(this->Observer->Begins, false);
}

std::optional<glm::dmat4> ViewerEye::Predict(const glm::dmat4& indexToClip) const
{
  if (!this->Last || *this->Last == indexToClip)
    return std::nullopt;
  // With C = P V of this frame and P V' of the last, C (P V')^-1 C = P (V V'^-1) V.
  glm::dmat4 wider(1.0);
  wider[0][0] = wider[1][1] = 1.0 / PredictedFrustum;
  return wider * indexToClip * glm::inverse(*this->Last) * indexToClip;
}

std::optional<glm::dmat4> ViewerEye::Beside(
  const ViewerEye& other, const glm::dmat4& indexToClip) const
{
  if (!this->Last || !other.Last)
    return std::nullopt;
  // With P E V of this eye and P' V of the other, P E P'^-1 is the same while the eyes move as one.
  return *this->Last * glm::inverse(*other.Last) * indexToClip;
}

void ViewerEye::ReadDepth(const glm::ivec2& origin, const glm::ivec2& size)
{
  this->DepthSize = glm::ivec2(0);
  this->DepthPixels.clear();
  GLint samples = 0, target = 0, source = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &source);
  if (size.x <= 0 || size.y <= 0)
    return;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(target));
  glPixelStorei(GL_PACK_ALIGNMENT, 1); // as VTK leaves it, and reads its own pictures by
  const auto read = [&](const glm::ivec2& from)
  {
    this->DepthSize = size;
    this->DepthPixels.resize(std::size_t(size.x) * size.y);
    glReadPixels(
      from.x, from.y, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, this->DepthPixels.data());
  };
  if (samples == 0)
    read(origin);
  else if (const OneSampleScope copy(target, origin, size); copy.Ready())
    read(glm::ivec2(0));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(source));
}

const std::vector<float>& ViewerEye::Depth(const glm::ivec2& size)
{
  if (size != this->DepthSize)
    this->DepthPixels.clear();
  return this->DepthPixels;
}

void ViewerEye::Forget()
{
  this->ForgetDepth();
  this->Last.reset();
  this->ServedTurn = 0;
  this->Progress = {};
}

ViewerEye& ViewerEyes::Of(vtkRenderer* renderer, vtkActor* actor, bool& begins)
{
  constexpr long long forgotten = 256; // frames of others
  std::erase_if(this->Eyes,
    [&](const auto& eye) { return eye->Lost() || this->Turns - eye->Turn > forgotten; });
  const bool left = renderer->GetActiveCamera()->GetLeftEye();
  auto found = std::find_if(this->Eyes.begin(), this->Eyes.end(),
    [&](const auto& eye) { return eye->Is(renderer, actor, left); });
  if (found == this->Eyes.end())
  {
    int number = 0;
    for (const auto& eye : this->Eyes)
      number = std::max(number, eye->Number + 1);
    found = this->Eyes.insert(found, std::make_unique<ViewerEye>(renderer, actor, left, number));
  }
  ViewerEye& eye = **found;
  begins = false;
  if (renderer->GetSelector())
    return eye;
  eye.IsDrawnNow();
  begins = eye.BeginsFrame();
  if (begins)
    eye.Turn = ++this->Turns;
  return eye;
}

ViewerEye* ViewerEyes::SecondOf(const ViewerEye& first)
{
  const auto found = std::find_if(this->Eyes.begin(), this->Eyes.end(),
    [&](const auto& eye)
    { return first.IsLeft() && !eye->IsLeft() && eye->IsBeside(first) && eye->IsDrawn(true); });
  return found == this->Eyes.end() ? nullptr : found->get();
}

ViewerEye& ViewerEyes::FirstOf(ViewerEye& eye) const
{
  const auto found = std::find_if(this->Eyes.begin(), this->Eyes.end(),
    [&](const auto& first)
    { return first->IsLeft() && !eye.IsLeft() && first->IsBeside(eye) && first->IsDrawn(true); });
  return found == this->Eyes.end() ? eye : **found;
}

std::size_t ViewerEyes::Bytes() const
{
  std::size_t bytes = 0;
  for (const auto& eye : this->Eyes)
    bytes += eye->DepthBytes();
  return bytes;
}

void ViewerEyes::Forget()
{
  for (const auto& eye : this->Eyes)
    eye->Forget();
}

void ViewerEyes::ForgetChoices()
{
  for (const auto& eye : this->Eyes)
    eye->Choice = {};
}

void ViewerEyes::Unfill()
{
  for (const auto& eye : this->Eyes)
    eye->Progress.Unfill();
}

bool ViewerEyes::Refining() const
{
  // Eyes take turns: one that was left out while all others had theirs is no longer drawn.
  const auto turn = static_cast<long long>(this->Eyes.size());
  return std::any_of(this->Eyes.begin(), this->Eyes.end(),
    [&](const auto& eye)
    {
      const bool stereo = std::any_of(this->Eyes.begin(), this->Eyes.end(),
        [&](const auto& other) { return other != eye && other->IsBeside(*eye); });
      return this->Turns - eye->Turn < turn && eye->IsDrawn(stereo) && eye->Progress.Refining();
    });
}

DrawingChoice::Frame ViewerEyes::MayDraw() const
{
  DrawingChoice::Frame may{ false, false, false };
  for (const auto& eye : this->Eyes)
  {
    const DrawingChoice::Frame own = this->FirstOf(*eye).Choice.MayDraw(eye->Progress.Filled());
    may = { may.sample || own.sample, may.cache || own.cache, may.whole || own.whole };
  }
  return may;
}
