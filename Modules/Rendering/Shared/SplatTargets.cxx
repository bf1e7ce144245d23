#include "SplatTargets.h"

#include "HaspGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <stdexcept>

namespace
{

/// components 0: depth.
vtkSmartPointer<vtkTextureObject> MakeTexture(
  vtkOpenGLRenderWindow* window, const glm::ivec2& size, int components)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  const bool made = components == 0
                      ? texture->AllocateDepth(size.x, size.y, vtkTextureObject::Float32)
                      : texture->Allocate2D(size.x, size.y, components, VTK_FLOAT);
  if (!made)
    throw std::runtime_error("the GPU has no room for the textures that normals are blended in");
  return texture;
}

vtkSmartPointer<vtkOpenGLFramebufferObject> MakeTarget(vtkOpenGLRenderWindow* window)
{
  auto target = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  target->SetContext(window);
  target->Bind();
  return target;
}

void Sample(vtkShaderProgram* program, const char* name, vtkTextureObject* texture)
{
  texture->Activate();
  program->SetUniformi(name, texture->GetTextureUnit());
}

constexpr float Zero[4] = { 0, 0, 0, 0 };

} // namespace

void SplatTargets::Allocate(vtkOpenGLRenderWindow* window, const Shape& shape)
{
  if (this->Depth && this->Made == shape)
    return;
  this->Release();
  this->Made = shape;
  this->Depth = MakeTexture(window, shape.size, 0);
  if (shape.numbered)
    this->Number = MakeTexture(window, shape.size, 1);
  for (const int components : shape.sums)
    this->Sums.push_back(MakeTexture(window, shape.size, components));
  this->HitTarget = MakeTarget(window);
  if (this->Number)
    this->HitTarget->AddColorAttachment(0, this->Number);
  this->HitTarget->AddDepthAttachment(this->Depth);
  this->SumTarget = MakeTarget(window);
  for (std::size_t n = 0; n < this->Sums.size(); ++n)
    this->SumTarget->AddColorAttachment(static_cast<unsigned int>(n), this->Sums[n]);
}

void SplatTargets::DrawHits(vtkOpenGLRenderWindow* window, const std::function<void()>& hits)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND), test(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglDepthMask mask(state);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE); // off in translucent passes
  this->HitTarget->Bind();
  if (this->Number)
    this->HitTarget->ActivateDrawBuffers(1);
  else
    this->HitTarget->DeactivateDrawBuffers();
  const float far = 1.0F;
  if (this->Number)
    glClearBufferfv(GL_COLOR, 0, Zero);
  glClearBufferfv(GL_DEPTH, 0, &far);
  hits();
}

void SplatTargets::DrawSplats(vtkOpenGLRenderWindow* window, const std::function<void()>& splats)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND), test(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  state->vtkglDisable(GL_DEPTH_TEST);
  this->SumTarget->Bind();
  this->SumTarget->ActivateDrawBuffers(static_cast<unsigned int>(this->Sums.size()));
  for (std::size_t n = 0; n < this->Sums.size(); ++n)
    glClearBufferfv(GL_COLOR, static_cast<GLint>(n), Zero);
  splats();
}

void SplatTargets::Draw(vtkOpenGLRenderWindow* window, const Shape& shape,
  const std::function<void()>& hits, const std::function<void()>& splats)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglActiveTexture unit(state);
  state->PushFramebufferBindings();
  try
  {
    this->Allocate(window, shape);
    this->DrawHits(window, hits);
    this->DrawSplats(window, splats);
  }
  catch (...)
  {
    state->PopFramebufferBindings();
    this->Release(); // some of it may not have been made
    throw;
  }
  state->PopFramebufferBindings();
}

void SplatTargets::SampleDepth(vtkShaderProgram* program, const char* name)
{
  Sample(program, name, this->Depth);
}

void SplatTargets::SampleNumber(vtkShaderProgram* program, const char* name)
{
  Sample(program, name, this->Number);
}

void SplatTargets::SampleSum(std::size_t n, vtkShaderProgram* program, const char* name)
{
  Sample(program, name, this->Sums[n]);
}

void SplatTargets::Deactivate()
{
  this->Depth->Deactivate();
  if (this->Number)
    this->Number->Deactivate();
  for (const auto& sum : this->Sums)
    sum->Deactivate();
}

void SplatTargets::Release()
{
  const auto release = [](auto& one)
  {
    if (one)
      one->ReleaseGraphicsResources(one->GetContext());
  };
  release(this->Depth);
  release(this->Number);
  for (auto& sum : this->Sums)
    release(sum);
  release(this->HitTarget);
  release(this->SumTarget);
  *this = {};
}

std::size_t SplatTargets::Bytes() const
{
  if (!this->Depth)
    return 0;
  std::size_t components = this->Number ? 2 : 1;
  for (const int sum : this->Made.sums)
    components += static_cast<std::size_t>(sum);
  return components * sizeof(float) * this->Made.size.x * this->Made.size.y;
}

void DrawViewportTriangle()
{
  GLuint array = 0; // core profiles draw nothing without one
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &array);
}
