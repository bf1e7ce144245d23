#include "ViewerEyes.h"

#include "HaspGL.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

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
  void Execute(vtkObject*, unsigned long, void*) override { this->Begins = true; }
  void Stop()
  {
    if (this->Renderer)
      this->Renderer->RemoveObserver(this->Tag);
  }

  vtkWeakPointer<vtkRenderer> Renderer;
  bool Begins = true;

private:
  unsigned long Tag;
};

ViewerEye::ViewerEye(vtkRenderer* renderer, bool left, int number)
  : Number(number),
    Observer(new FrameObserver(renderer), [](FrameObserver* observer) { observer->Delete(); }),
    Left(left)
{
}

ViewerEye::~ViewerEye()
{
  this->Observer->Stop();
}

bool ViewerEye::Is(vtkRenderer* renderer, bool left) const
{
  return this->Observer->Renderer == renderer && this->Left == left;
}

bool ViewerEye::Lost() const
{
  return !this->Observer->Renderer;
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

void ViewerEye::ReadDepth(const glm::ivec2& origin, const glm::ivec2& size)
{
  this->DepthSize = glm::ivec2(0);
  this->DepthPixels.clear();
  GLint samples = 0, target = 0, source = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &source);
  if (samples > 0 || size.x <= 0 || size.y <= 0)
    return;
  this->DepthSize = size;
  this->DepthPixels.resize(std::size_t(size.x) * size.y);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(target));
  glPixelStorei(GL_PACK_ALIGNMENT, 1); // as VTK leaves it, and reads its own pictures by
  glReadPixels(
    origin.x, origin.y, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, this->DepthPixels.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(source));
}

const std::vector<float>& ViewerEye::Depth(const glm::ivec2& size)
{
  if (size != this->DepthSize)
    this->DepthPixels.clear();
  return this->DepthPixels;
}

ViewerEye& ViewerEyes::Of(vtkRenderer* renderer)
{
  std::erase_if(this->Eyes, [](const auto& eye) { return eye->Lost(); });
  const bool left =
    !renderer->GetRenderWindow()->GetStereoRender() || renderer->GetActiveCamera()->GetLeftEye();
  for (const auto& eye : this->Eyes)
    if (eye->Is(renderer, left))
      return *eye;
  int number = 0;
  for (const auto& eye : this->Eyes)
    number = std::max(number, eye->Number + 1);
  return *this->Eyes.emplace_back(std::make_unique<ViewerEye>(renderer, left, number));
}

std::size_t ViewerEyes::Bytes() const
{
  std::size_t bytes = 0;
  for (const auto& eye : this->Eyes)
    bytes += eye->DepthBytes();
  return bytes;
}
