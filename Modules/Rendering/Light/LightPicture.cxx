#include "LightPicture.h"

#include "HaspGL.h"
#include "OneSampleDepth.h"
#include "SplatTargets.h"
#include "vtkHaspLightFS.h"
#include "vtkHaspLightVS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace
{

/// Room for a viewport's pixels, four values of VTK's type each; `pixels` are copied there if
/// given.
void MakePixels(vtkSmartPointer<vtkTextureObject>& texture, vtkOpenGLRenderWindow* window,
  const glm::ivec2& size, int type, const void* pixels)
{
  if (!texture || texture->GetContext() != window)
  {
    texture = vtkSmartPointer<vtkTextureObject>::New();
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  if (!texture->Create2DFromRaw(static_cast<unsigned>(size.x), static_cast<unsigned>(size.y), 4,
        type, const_cast<void*>(pixels)))
    throw std::runtime_error("light: the GPU has no room for a picture of " +
                             std::to_string(size.x) + " x " + std::to_string(size.y) + " pixels");
}

std::size_t BytesOf(vtkTextureObject* texture, std::size_t bytesAPixel)
{
  return texture ? std::size_t(texture->GetWidth()) * texture->GetHeight() * bytesAPixel : 0;
}

} // namespace

int ReadDepths(const LightViewport& viewport, std::vector<float>& depths)
{
  const glm::ivec2& size = viewport.size;
  depths.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  GLint drawn = 0, read = 0, samples = 0, alignment = 4;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(drawn));
  glGetIntegerv(GL_SAMPLES, &samples);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  const auto readFrom = [&](const glm::ivec2& origin) {
    glReadPixels(origin.x, origin.y, size.x, size.y, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  };
  if (samples > 1)
  {
    const OneSampleScope copy(drawn, viewport.origin, size);
    if (!copy.Ready())
      throw std::runtime_error("light: the window has no depth that can be read");
    readFrom(glm::ivec2(0));
  }
  else
    readFrom(viewport.origin);
  glPixelStorei(GL_PACK_ALIGNMENT, alignment);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
  return std::max(1, static_cast<int>(samples));
}

void LightPicture::KeepBehind(vtkOpenGLRenderWindow* window, const LightViewport& viewport)
{
  const glm::ivec2 &size = viewport.size, &from = viewport.origin;
  // As VTK's windows have it: what has several samples a pixel is copied to the same format alone.
  MakePixels(this->Behind, window, size, VTK_UNSIGNED_CHAR, nullptr);
  GLint drawn = 0, read = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  const GLboolean scissored = glIsEnabled(GL_SCISSOR_TEST);
  GLuint copy = 0;
  glGenFramebuffers(1, &copy);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(drawn));
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, copy);
  glFramebufferTexture2D(
    GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Behind->GetHandle(), 0);
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(from.x, from.y, from.x + size.x, from.y + size.y, 0, 0, size.x, size.y,
    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  if (scissored)
    glEnable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawn));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
  glDeleteFramebuffers(1, &copy);
}

void LightPicture::Draw(vtkOpenGLRenderWindow* window, const LightViewport& viewport,
  const hasp::LitPicture& picture, float exposure, bool encoded)
{
  if (picture.size() != std::size_t(viewport.size.x) * std::size_t(viewport.size.y))
    throw std::logic_error("light: the picture has another size than the viewport");
  MakePixels(this->Texture, window, viewport.size, VTK_FLOAT, picture.data());
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable depth(state, GL_DEPTH_TEST), blend(state, GL_BLEND),
    cull(state, GL_CULL_FACE);
  const vtkOpenGLState::ScopedglBlendFuncSeparate blending(state);
  const vtkOpenGLState::ScopedglDepthMask mask(state);
  const vtkOpenGLState::ScopedglActiveTexture unit(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglDepthMask(GL_FALSE);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vtkHaspLightVS, vtkHaspLightFS, "");
  if (!program)
    throw std::runtime_error("light: the shaders did not compile");
  const auto& behind = this->Behind ? this->Behind : this->Texture; // nobody asks for it
  this->Texture->Activate();
  behind->Activate();
  program->SetUniformi("light", this->Texture->GetTextureUnit());
  program->SetUniformi("behind", behind->GetTextureUnit());
  program->SetUniform2i("firstPixel", &viewport.origin.x);
  program->SetUniformf("exposure", exposure);
  program->SetUniformi("encoded", encoded);
  DrawViewportTriangle();
  behind->Deactivate();
  this->Texture->Deactivate();
}

std::size_t LightPicture::Bytes() const
{
  return BytesOf(this->Texture, 16) + BytesOf(this->Behind, 4);
}
