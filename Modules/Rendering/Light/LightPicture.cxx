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

void LightPicture::Draw(vtkOpenGLRenderWindow* window, const LightViewport& viewport,
  const hasp::LitPicture& picture, float exposure, bool encoded)
{
  if (picture.size() != std::size_t(viewport.size.x) * std::size_t(viewport.size.y))
    throw std::logic_error("light: the picture has another size than the viewport");
  if (!this->Texture || this->Texture->GetContext() != window)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Texture->SetContext(window);
    this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  }
  if (!this->Texture->Create2DFromRaw(static_cast<unsigned>(viewport.size.x),
        static_cast<unsigned>(viewport.size.y), 4, VTK_FLOAT,
        const_cast<glm::vec4*>(picture.data())))
    throw std::runtime_error("light: the GPU has no room for a picture of " +
                             std::to_string(viewport.size.x) + " x " +
                             std::to_string(viewport.size.y) + " pixels");
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
  this->Texture->Activate();
  program->SetUniformi("light", this->Texture->GetTextureUnit());
  program->SetUniform2i("firstPixel", &viewport.origin.x);
  program->SetUniformf("exposure", exposure);
  program->SetUniformi("encoded", encoded);
  DrawViewportTriangle();
  this->Texture->Deactivate();
}

std::size_t LightPicture::Bytes() const
{
  return this->Texture ? std::size_t(this->Texture->GetWidth()) * this->Texture->GetHeight() * 16
                       : 0;
}
