#include "StereoOutputPass.h"

#include "HaspGL.h"
#include "vtkHaspStereoOutputFS.h"
#include "vtkHaspStereoOutputVS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <stdexcept>
#include <string>

namespace
{

/// What VTK may have left on and this pass must have off, and what it changes.
class PlainState
{
public:
  PlainState(vtkOpenGLState* s, const PixelRectangle& to)
    : state(s),
      blend(s, GL_BLEND),
      depth(s, GL_DEPTH_TEST),
      scissor(s, GL_SCISSOR_TEST),
      cull(s, GL_CULL_FACE),
      stencil(s, GL_STENCIL_TEST),
      depthMask(s),
      colorMask(s),
      viewport(s),
      unit(s)
  {
    s->PushFramebufferBindings();
    for (const GLenum off :
      { GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_CULL_FACE, GL_STENCIL_TEST })
      s->vtkglDisable(off);
    s->vtkglDepthMask(GL_FALSE);
    s->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    s->vtkglViewport(to.origin.x, to.origin.y, to.size.x, to.size.y);
  }
  ~PlainState() { this->state->PopFramebufferBindings(); }
  PlainState(const PlainState&) = delete;
  PlainState& operator=(const PlainState&) = delete;

private:
  vtkOpenGLState* state;
  vtkOpenGLState::ScopedglEnableDisable blend, depth, scissor, cull, stencil;
  vtkOpenGLState::ScopedglDepthMask depthMask;
  vtkOpenGLState::ScopedglColorMask colorMask;
  vtkOpenGLState::ScopedglViewport viewport;
  vtkOpenGLState::ScopedglActiveTexture unit;
};

vtkTextureObject* TextureOf(vtkOpenGLFramebufferObject* picture)
{
  return picture->GetColorAttachmentAsTextureObject(0);
}

void Sample(vtkShaderProgram* program, const char* name, vtkTextureObject* texture)
{
  texture->Activate();
  program->SetUniformi(name, texture->GetTextureUnit());
}

void SetOutput(vtkShaderProgram* program, const hasp::StereoOutput& output, glm::ivec2 eyeSize,
  const PixelRectangle& target)
{
  using hasp::MirrorFlip;
  using hasp::StereoLayout;
  const bool one = !hasp::NeedsSecondEye(output.layout);
  const bool right = one ? output.layout == StereoLayout::Right : output.swapEyes;
  const glm::ivec2 flip(output.flip == MirrorFlip::Horizontal || output.flip == MirrorFlip::Both,
    output.flip == MirrorFlip::Vertical || output.flip == MirrorFlip::Both);
  program->SetUniformi("outputLayout", static_cast<int>(output.layout));
  program->SetUniformi("halved", output.resolution == hasp::StereoResolution::Half);
  program->SetUniformi("firstIsRight", right);
  program->SetUniform2i("flip", &flip.x);
  program->SetUniform2i("size", &target.size.x);
  program->SetUniform2i("eyeSize", &eyeSize.x);
  program->SetUniform2i("origin", &target.origin.x);
}

} // namespace

void StereoOutputPass::FollowContext(vtkOpenGLRenderWindow* window)
{
  if (this->ContextTime == window->GetContextCreationTime())
    return;
  for (Eye& eye : this->Eyes) // VTK has released what the lost context had
  {
    eye.Picture = nullptr;
    eye.Lens = nullptr;
    eye.Size = glm::ivec2(0);
  }
  this->ContextTime = window->GetContextCreationTime();
}

void StereoOutputPass::Keep(
  vtkOpenGLRenderWindow* window, hasp::StereoEye which, const PixelRectangle& drawn)
{
  this->FollowContext(window);
  const PlainState plain(window->GetState(), drawn);
  Eye& eye = this->Eyes[which == hasp::StereoEye::Right];
  if (!eye.Picture || eye.Size != drawn.size)
  {
    eye.Picture = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
    eye.Picture->SetContext(window);
    eye.Size = glm::ivec2(0);
    if (!eye.Picture->PopulateFramebuffer(
          drawn.size.x, drawn.size.y, true, 1, VTK_UNSIGNED_CHAR, false, 0, 0, false))
      throw std::runtime_error("stereo: the GPU has no room for an eye's picture");
    eye.Size = drawn.size;
  }
  eye.Picture->Bind(GL_DRAW_FRAMEBUFFER);
  eye.Picture->ActivateDrawBuffer(0);
  window->GetRenderFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  window->GetRenderFramebuffer()->ActivateReadBuffer(0);
  const glm::ivec2 end = drawn.origin + drawn.size;
  glBlitFramebuffer(drawn.origin.x, drawn.origin.y, end.x, end.y, 0, 0, drawn.size.x, drawn.size.y,
    GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void StereoOutputPass::SetLenses(const std::array<hasp::LensTable, 2>& lenses)
{
  for (int n = 0; n < 2; ++n)
  {
    this->Eyes[n].Table = lenses[n];
    this->Eyes[n].Lens = nullptr;
  }
}

void StereoOutputPass::UploadLens(vtkOpenGLRenderWindow* window, Eye& eye)
{
  if (eye.Lens)
    return;
  auto lens = vtkSmartPointer<vtkTextureObject>::New();
  lens->SetContext(window);
  lens->SetMinificationFilter(vtkTextureObject::Nearest);
  lens->SetMagnificationFilter(vtkTextureObject::Nearest);
  if (!lens->Create2DFromRaw(static_cast<unsigned int>(eye.Table.size.x),
        static_cast<unsigned int>(eye.Table.size.y * eye.Table.channels), 2, VTK_FLOAT,
        eye.Table.positions.data()))
    throw std::runtime_error("stereo: the GPU has no room for a lens table");
  eye.Lens = lens;
}

void StereoOutputPass::Compose(
  vtkOpenGLRenderWindow* window, const hasp::StereoOutput& output, const PixelRectangle& target)
{
  const PlainState plain(window->GetState(), target);
  std::array<Eye*, 2> eyes{ &this->Eyes[0], &this->Eyes[1] };
  for (int n = 0; n < 2; ++n)
    if (!eyes[n]->Picture)
      eyes[n] = eyes[1 - n];
  const bool lens = eyes[0]->Table.size.x > 0;
  std::string fragment = vtkHaspStereoOutputFS;
  const std::string slot = "//Hasp::Defines";
  fragment.replace(fragment.find(slot), slot.size(), lens ? "#define HASP_LENS" : "");
  window->GetRenderFramebuffer()->Bind(GL_DRAW_FRAMEBUFFER);
  window->GetRenderFramebuffer()->ActivateDrawBuffer(0);
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vtkHaspStereoOutputVS, fragment.c_str(), "");
  if (!program)
    throw std::runtime_error("stereo: the shader of the output did not compile");
  SetOutput(program, output, eyes[0]->Size, target);
  constexpr const char* pictureNames[] = { "leftEye", "rightEye" };
  constexpr const char* lensNames[] = { "leftLens", "rightLens" };
  for (int n = 0; n < 2; ++n)
  {
    Sample(program, pictureNames[n], TextureOf(eyes[n]->Picture));
    if (!lens)
      continue;
    this->UploadLens(window, *eyes[n]);
    Sample(program, lensNames[n], eyes[n]->Lens);
    program->SetUniformi("channels", eyes[n]->Table.channels);
  }
  GLuint array = 0; // core profiles draw nothing without one
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &array);
  for (Eye* eye : eyes)
  {
    TextureOf(eye->Picture)->Deactivate();
    if (eye->Lens)
      eye->Lens->Deactivate();
  }
}

void StereoOutputPass::ForgetPicture(hasp::StereoEye eye)
{
  this->Eyes[eye == hasp::StereoEye::Right].Picture = nullptr;
  this->Eyes[eye == hasp::StereoEye::Right].Size = glm::ivec2(0);
}

void StereoOutputPass::Release()
{
  this->Eyes = {}; // VTK's objects make their context current to free what they hold
}

std::size_t StereoOutputPass::PictureBytes() const
{
  std::size_t bytes = 0;
  for (const Eye& eye : this->Eyes)
    bytes += std::size_t(4) * eye.Size.x * eye.Size.y;
  return bytes;
}

std::size_t StereoOutputPass::LensBytes() const
{
  std::size_t bytes = 0;
  for (const Eye& eye : this->Eyes)
    if (eye.Lens)
      bytes += eye.Table.positions.size() * sizeof(float);
  return bytes;
}
