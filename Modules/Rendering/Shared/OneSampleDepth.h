#ifndef OneSampleDepth_h
#define OneSampleDepth_h

#include "HaspGL.h"

#include <glm/vec2.hpp>

/// The sized format of the depth that is drawn to; 0 if there is none.
inline GLenum DepthFormat(GLint framebuffer)
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
    glReadBuffer(GL_NONE);
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

#endif
