#include "NormalBlending.h"

#include "CellScene.h"
#include "CellShading.h"
#include "HaspGL.h"
#include "ShaderSlots.h"
#include "vtkHaspBlendedCellFS.h"
#include "vtkHaspBlendedCellVS.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <stdexcept>
#include <string>

namespace
{

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

void Sample(vtkShaderProgram* program, const char* name, vtkTextureObject* texture)
{
  texture->Activate();
  program->SetUniformi(name, texture->GetTextureUnit());
}

constexpr float Zero[4] = { 0, 0, 0, 0 };

} // namespace

void NormalBlending::Allocate(vtkOpenGLRenderWindow* window, const glm::ivec2& size, bool colored)
{
  if (this->Depth && this->Size == size && this->Colored == colored)
    return;
  this->Release();
  this->Size = size;
  this->Colored = colored;
  this->Depth = MakeTexture(window, size, 0);
  this->Frame = MakeTexture(window, size, 1);
  for (int n = 0; n < (colored ? 3 : 1); ++n)
    this->Sums[n] = MakeTexture(window, size, 4);
  this->HitTarget = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->HitTarget->SetContext(window);
  this->HitTarget->Bind();
  this->HitTarget->AddColorAttachment(0, this->Frame);
  this->HitTarget->AddDepthAttachment(this->Depth);
  this->SumTarget = vtkSmartPointer<vtkOpenGLFramebufferObject>::New();
  this->SumTarget->SetContext(window);
  this->SumTarget->Bind();
  for (int n = 0; n < (colored ? 3 : 1); ++n)
    this->SumTarget->AddColorAttachment(n, this->Sums[n]);
}

void NormalBlending::DrawHits(vtkOpenGLRenderWindow* window, const std::function<void()>& hits)
{
  vtkOpenGLState::ScopedglEnableDisable blend(window->GetState(), GL_BLEND);
  window->GetState()->vtkglDisable(GL_BLEND);
  this->HitTarget->Bind();
  this->HitTarget->ActivateDrawBuffers(1);
  const float far = 1.0F;
  glClearBufferfv(GL_COLOR, 0, Zero);
  glClearBufferfv(GL_DEPTH, 0, &far);
  hits();
}

void NormalBlending::DrawSplats(
  vtkOpenGLRenderWindow* window, const std::function<void(const Textures&)>& splats)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND), test(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  state->vtkglDisable(GL_DEPTH_TEST);
  const int count = this->Colored ? 3 : 1;
  this->SumTarget->Bind();
  this->SumTarget->ActivateDrawBuffers(count);
  for (int n = 0; n < count; ++n)
    glClearBufferfv(GL_COLOR, n, Zero);
  splats(
    [this](vtkShaderProgram* program)
    {
      Sample(program, "hitDepth", this->Depth);
      Sample(program, "hitFrame", this->Frame);
    });
  this->Depth->Deactivate();
  this->Frame->Deactivate();
}

void NormalBlending::Resolve(vtkOpenGLRenderWindow* window, const CellScene& scene)
{
  std::string fragment = vtkHaspBlendedCellFS;
  FillSlot(fragment, "CellShading", CellShading);
  FillSlot(
    fragment, "Defines", scene.Defines() + (this->Colored ? "#define HASP_BLENDED_COLORS\n" : ""));
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vtkHaspBlendedCellVS, fragment.c_str(), "");
  if (!program)
    throw std::runtime_error("the shader of blended normals did not compile");
  scene.SetUniforms(program);
  constexpr const char* names[] = { "blendedNormal", "blendedDiffuse", "blendedAmbient" };
  Sample(program, "hitDepth", this->Depth);
  for (int n = 0; n < (this->Colored ? 3 : 1); ++n)
    Sample(program, names[n], this->Sums[n]);
  GLuint array = 0; // core profiles draw nothing without one
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glDeleteVertexArrays(1, &array);
  this->Depth->Deactivate();
  for (int n = 0; n < (this->Colored ? 3 : 1); ++n)
    this->Sums[n]->Deactivate();
}

void NormalBlending::Draw(vtkOpenGLRenderWindow* window, const CellScene& scene, bool colored,
  const std::function<void()>& hits, const std::function<void(const Textures&)>& splats)
{
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglActiveTexture unit(state);
  state->PushFramebufferBindings();
  try
  {
    // Textures reach from the window's corner, so that gl_FragCoord is that of the window.
    this->Allocate(window, scene.viewportOrigin + scene.viewportSize, colored);
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
  this->Resolve(window, scene);
}

void NormalBlending::Release()
{
  for (vtkTextureObject* texture : { this->Depth.Get(), this->Frame.Get(), this->Sums[0].Get(),
         this->Sums[1].Get(), this->Sums[2].Get() })
    if (texture)
      texture->ReleaseGraphicsResources(texture->GetContext());
  for (vtkOpenGLFramebufferObject* target : { this->HitTarget.Get(), this->SumTarget.Get() })
    if (target)
      target->ReleaseGraphicsResources(target->GetContext());
  *this = {};
}

std::size_t NormalBlending::Bytes() const
{
  const std::size_t pixels = std::size_t(this->Size.x) * this->Size.y;
  return this->Depth ? pixels * (this->Colored ? 56 : 24) : 0;
}
