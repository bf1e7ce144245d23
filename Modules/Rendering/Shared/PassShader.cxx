#include "PassShader.h"

#include "FinePeels.h"
#include "ShaderSlots.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <vector>

namespace
{

std::vector<vtkOpenGLRenderPass*> PassesOf(vtkActor* actor)
{
  std::vector<vtkOpenGLRenderPass*> passes;
  vtkInformation* info = actor->GetPropertyKeys();
  if (!info || !info->Has(vtkOpenGLRenderPass::RenderPasses()))
    return passes;
  for (int n = 0; n < info->Length(vtkOpenGLRenderPass::RenderPasses()); ++n)
    if (auto* pass =
          vtkOpenGLRenderPass::SafeDownCast(info->Get(vtkOpenGLRenderPass::RenderPasses(), n)))
      passes.push_back(pass);
  return passes;
}

/// VTK's passes write to gl_FragData[n], which core profiles lack: it becomes fragOutput<n>.
/// Returns the declarations of those but the first, which our shaders declare themselves, each with
/// a PASS_OUTPUT_<n> to tell.
std::string NameOutputs(std::string& fragment)
{
  std::string declarations;
  for (int n = 0; n < 8; ++n)
  {
    const std::string old = "gl_FragData[" + std::to_string(n) + "]";
    const std::string name = "fragOutput" + std::to_string(n);
    bool used = false;
    for (std::size_t at = fragment.find(old); at != std::string::npos; at = fragment.find(old, at))
    {
      fragment.replace(at, old.size(), name);
      used = true;
    }
    if (used && n > 0)
      declarations += "layout(location = " + std::to_string(n) + ") out vec4 " + name +
                      ";\n#define PASS_OUTPUT_" + std::to_string(n) + "\n";
  }
  return declarations;
}

/// VTK's dual depth peeling takes depths within 1e-7 for those of one layer. Our shaders compute
/// depths, and two cells that see the same point round it differently: some units of 2^-24 apart.
void MergeRoundedDepths(std::string& fragment)
{
  const std::string theirs = "float epsilon = 0.0000001;", ours = "float epsilon = 0.0000005;";
  if (const std::size_t at = fragment.find(theirs); at != std::string::npos)
    fragment.replace(at, theirs.size(), ours);
}

} // namespace

vtkShaderProgram* ReadyPassShader(vtkOpenGLRenderWindow* window, vtkMapper* mapper, vtkActor* actor,
  std::string vertex, std::string fragment, const std::string& defines)
{
  std::string geometry;
  const std::vector<vtkOpenGLRenderPass*> passes = PassesOf(actor);
  for (vtkOpenGLRenderPass* one : passes)
  {
    UseFinePeels(one);
    one->PreReplaceShaderValues(vertex, geometry, fragment, mapper, actor);
    one->PostReplaceShaderValues(vertex, geometry, fragment, mapper, actor);
  }
  MergeRoundedDepths(fragment);
  FillSlot(vertex, "Defines", defines);
  FillSlot(fragment, "Defines", defines + NameOutputs(fragment));
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    vertex.c_str(), fragment.c_str(), geometry.c_str());
  if (!program)
    return nullptr;
  for (vtkOpenGLRenderPass* one : passes)
    one->SetShaderParameters(program, mapper, actor);
  return program;
}
