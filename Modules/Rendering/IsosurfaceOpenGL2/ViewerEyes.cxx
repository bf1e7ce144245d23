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

/// The sized format of the depth that is drawn to; 0 if there is none.
GLenum DepthFormat(GLint framebuffer)
{
  const auto ask = [](GLenum attachment, GLenum what)
  {
    GLint answer = GL_NONE;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &answer);
    return answer;
  };
  const GLenum depth = framebuffer == 0 ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  if (ask(depth, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
    return 0;
  const GLenum other = framebuffer == 0 ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
  const bool stencil = ask(other, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE &&
                       ask(other, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0;
  const GLint bits = ask(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  if (ask(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
    return stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
  if (bits == 24)
    return stencil ? GL_DEPTH24_STENCIL8 : GL_DEPTH_COMPONENT24;
  return bits == 16 ? GL_DEPTH_COMPONENT16 : GL_DEPTH_COMPONENT32;
}

/// While one lives, what is read is a copy of a part of the framebuffer's depth with one sample a
/// pixel, from (0, 0) on.
class OneSampleScope
{
public:
  OneSampleScope(GLint framebuffer, const glm::ivec2& origin, const glm::ivec2& size)
    : Scissored(glIsEnabled(GL_SCISSOR_TEST))
  {
    const GLenum format = DepthFormat(framebuffer); // of both, or nothing is copied
    if (format == 0)
      return;
    glGetIntegerv(GL_RENDERBUFFER_BINDING, &this->Bound);
    glGenRenderbuffers(1, &this->Depth);
    glBindRenderbuffer(GL_RENDERBUFFER, this->Depth);
    glRenderbufferStorage(GL_RENDERBUFFER, format, size.x, size.y);
    glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(this->Bound));
    glGenFramebuffers(1, &this->Copy);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Copy);
    glFramebufferRenderbuffer(
      GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, this->Depth);
    glDrawBuffer(GL_NONE);
    glDisable(GL_SCISSOR_TEST);
    glBlitFramebuffer(origin.x, origin.y, origin.x + size.x, origin.y + size.y, 0, 0, size.x,
      size.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    if (this->Scissored)
      glEnable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, this->Copy);
  }
  ~OneSampleScope()
  {
    glDeleteFramebuffers(1, &this->Copy); // 0 is nothing
    glDeleteRenderbuffers(1, &this->Depth);
  }
  OneSampleScope(const OneSampleScope&) = delete;
  OneSampleScope& operator=(const OneSampleScope&) = delete;
  bool Ready() const { return this->Copy != 0; }

private:
  GLboolean Scissored;
  GLint Bound = 0;
  GLuint Depth = 0, Copy = 0;
};

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
