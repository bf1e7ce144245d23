#include "NormalBlending.h"

#include "CellScene.h"
#include "ShaderSlots.h"
#include "SurfaceShading.h"
#include "vtkHaspBlendedCellFS.h"
#include "vtkHaspBlendedCellVS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <stdexcept>
#include <string>

void NormalBlending::Resolve(vtkOpenGLRenderWindow* window, const CellScene& scene, bool colored)
{
  std::string fragment = vtkHaspBlendedCellFS;
  FillSlot(fragment, "SurfaceShading", SurfaceShading);
  FillSlot(fragment, "Defines", scene.Defines() + (colored ? "#define HASP_BLENDED_COLORS\n" : ""));
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vtkHaspBlendedCellVS, fragment.c_str(), "");
  if (!program)
    throw std::runtime_error("the shader of blended normals did not compile");
  scene.SetUniforms(program);
  vtkOpenGLState::ScopedglActiveTexture unit(window->GetState());
  constexpr const char* names[] = { "blendedNormal", "blendedDiffuse", "blendedAmbient" };
  this->Targets.SampleDepth(program, "hitDepth");
  for (std::size_t n = 0; n < (colored ? 3U : 1U); ++n)
    this->Targets.SampleSum(n, program, names[n]);
  DrawViewportTriangle();
  this->Targets.Deactivate();
}

void NormalBlending::Draw(vtkOpenGLRenderWindow* window, const CellScene& scene, bool colored,
  const std::function<void()>& hits, const std::function<void(const Textures&)>& splats)
{
  SplatTargets::Shape shape{ scene.viewportOrigin + scene.viewportSize, true, { 4 } };
  if (colored)
    shape.sums = { 4, 4, 4 };
  this->Targets.Draw(window, shape, hits,
    [&]
    {
      splats(
        [this](vtkShaderProgram* program)
        {
          this->Targets.SampleDepth(program, "hitDepth");
          this->Targets.SampleNumber(program, "hitFrame");
        });
      this->Targets.Deactivate();
    });
  this->Resolve(window, scene, colored);
}
