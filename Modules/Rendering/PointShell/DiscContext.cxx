#include "DiscContext.h"

#include "ActorFrame.h"
#include "HaspGL.h"
#include "PassShader.h"
#include "SelectionColor.h"
#include "SelectionScope.h"
#include "ShadedScene.h"
#include "ShaderSlots.h"
#include "SurfaceShading.h"
#include "vtkHaspBlendedDiscFS.h"
#include "vtkHaspBlendedDiscVS.h"
#include "vtkHaspPointShellMapper.h"
#include "vtkHaspShellDiscFS.h"
#include "vtkHaspShellDiscVS.h"

#include "vtkActor.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <glm/matrix.hpp>

#include <chrono>
#include <stdexcept>

namespace
{

using Clock = std::chrono::steady_clock;

double MillisecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void SetLevelColors(vtkShaderProgram* program)
{
  float colors[8][3];
  for (int level = 0; level < 8; ++level)
  {
    double rgb[3];
    vtkHaspPointShellMapper::GetLevelColor(level, rgb);
    for (int n = 0; n < 3; ++n)
      colors[level][n] = static_cast<float>(rgb[n]);
  }
  program->SetUniform3fv("levelColors", 8, colors);
}

} // namespace

/// One frame's worth of what the passes share.
struct DiscContext::Pass
{
  vtkOpenGLRenderWindow* window;
  vtkMapper* mapper;
  vtkActor* actor;
  const ActorFrame& frame;
  const ShadedScene& scene;
  vtkHardwareSelector* selector;
  const Look& look;

  std::string Defines() const
  {
    std::string text =
      "#define HASP_PLANES " + std::to_string(this->frame.planes.size() - 1) + "\n";
    if (this->look.levels)
      text += "#define HASP_LEVELS\n";
    if (this->selector)
      text += "#define HASP_SELECTION\n";
    return text;
  }
};

void DiscContext::Free(vtkOpenGLRenderWindow* window)
{
  this->Home.Leave(window,
    [this]
    {
      this->Buffer.Release();
      this->Targets.Release();
    });
  this->Buffer = {};
  this->Targets = {};
}

void DiscContext::DrawDiscs(const Pass& pass, bool hits)
{
  const auto start = Clock::now();
  const std::string defines = pass.Defines() + (hits ? "#define HASP_HITS\n" : "");
  std::string vertex = vtkHaspShellDiscVS, fragment = vtkHaspShellDiscFS;
  FillSlot(vertex, "Defines", defines);
  FillSlot(fragment, "Defines", defines);
  vtkShaderProgram* program =
    pass.window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
  if (!program)
    throw std::runtime_error("the shader of discs did not compile");
  if (this->ShaderMilliseconds == 0.0)
    this->ShaderMilliseconds = MillisecondsSince(start);
  const ActorFrame& frame = pass.frame;
  const glm::dmat4 viewToClip = frame.localToClip * glm::inverse(frame.localToView);
  const glm::vec4 eye = EyeInLocal(glm::inverse(frame.localToClip), frame.parallelProjection);
  const glm::vec2 size(frame.viewportSize), origin(frame.viewportOrigin);
  const glm::vec2 step(-viewToClip[2].z, -viewToClip[2].w);
  SetMatrixUniform(program, "localToClip", frame.localToClip);
  SetMatrixUniform(program, "localToView", frame.localToView);
  SetNormalMatrixUniform(program, "normalToView", frame.localToView);
  program->SetUniform4f("eyeLocal", &eye.x);
  program->SetUniform2f("viewport", &size.x);
  program->SetUniform2f("viewportOrigin", &origin.x);
  program->SetUniform2f("depthStep", &step.x);
  program->SetUniformf("overlap", static_cast<float>(pass.look.overlap));
  vtkProperty* property = pass.actor->GetProperty();
  program->SetUniformi("culledSide",
    (property->GetBackfaceCulling() ? 1 : 0) + (property->GetFrontfaceCulling() ? 2 : 0));
  const std::vector<glm::vec4> planes(frame.planes.begin() + 1, frame.planes.end());
  if (!planes.empty())
    program->SetUniform4fv("planes", static_cast<int>(planes.size()), &planes[0].x);
  if (pass.look.levels)
    SetLevelColors(program);
  if (!hits)
    this->Targets.SampleDepth(program, "hitDepth");
  this->Buffer.Bind(pass.window, program, pass.look.levels);
  this->Buffer.Draw();
  this->Buffer.Unbind(pass.window);
  if (!hits)
    this->Targets.Deactivate();
}

void DiscContext::Resolve(const Pass& pass)
{
  std::string fragment = vtkHaspBlendedDiscFS;
  FillSlot(fragment, "SurfaceShading", SurfaceShading);
  FillSlot(fragment, "SelectionColor", SelectionColor);
  vtkShaderProgram* program = ReadyPassShader(pass.window, pass.mapper, pass.actor,
    vtkHaspBlendedDiscVS, fragment, pass.Defines() + pass.scene.ShadingDefines());
  if (!program)
    throw std::runtime_error("the shader of blended discs did not compile");
  const glm::vec4 toDevice = pass.frame.PixelsToDevice();
  SetMatrixUniform(
    program, "clipToView", pass.frame.localToView * glm::inverse(pass.frame.localToClip));
  program->SetUniform4f("viewportToDevice", &toDevice.x);
  pass.scene.SetShadingUniforms(program);
  if (pass.selector)
    SetSelectionUniforms(program, pass.selector);
  vtkOpenGLState::ScopedglActiveTexture unit(pass.window->GetState());
  this->Targets.SampleDepth(program, "hitDepth");
  this->Targets.SampleSum(0, program, "sumNormal");
  this->Targets.SampleSum(1, program, "sumDepth");
  if (pass.selector)
    this->Targets.SampleNumber(program, "hitNumber");
  DrawViewportTriangle();
  this->Targets.Deactivate();
}

void DiscContext::Draw(vtkMapper* mapper, vtkRenderer* renderer, vtkActor* actor,
  const std::shared_ptr<const Discs>& discs, const Look& look)
{
  const auto start = Clock::now();
  this->Buffer.Upload(discs);
  if (this->UploadMilliseconds == 0.0)
    this->UploadMilliseconds = MillisecondsSince(start);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkHardwareSelector* selector = renderer->GetSelector();
  const ActorFrame frame(mapper, renderer, actor);
  const ShadedScene scene(renderer, actor);
  const SelectionScope selection(selector, static_cast<vtkIdType>(discs->size()));
  const Pass pass{ window, mapper, actor, frame, scene, selector, look };
  const SplatTargets::Shape shape{ frame.viewportOrigin + frame.viewportSize, selector != nullptr,
    { 4, look.levels ? 4 : 1 } };
  this->Targets.Draw(
    window, shape, [&] { this->DrawDiscs(pass, true); }, [&] { this->DrawDiscs(pass, false); });
  this->Resolve(pass);
}
