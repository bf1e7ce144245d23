#include "CellProgram.h"

#include "AttributeBuffers.h"
#include "CellColors.h"
#include "CellFrame.h"
#include "CellLayout.h"
#include "CellScene.h"
#include "CellSelection.h"
#include "CellShading.h"
#include "CellSplat.h"
#include "RayRoot.h"
#include "SelectionScope.h"
#include "ShaderSlots.h"
#include "vtkHaspClusteredCellFS.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspClusteredCellVS.h"
#include "vtkHaspTracedCellFS.h"
#include "vtkHaspTracedCellVS.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

#include <chrono>
#include <string>
#include <vector>

namespace
{

std::string CornerDefines(const hasp::ClusteredCells& cells)
{
  if (cells.precision == hasp::CellPrecision::Compact)
    return "#define HASP_COMPACT_CORNERS\n";
  switch (cells.cornerType)
  {
    case hasp::CornerType::Float32:
      return "#define HASP_FLOAT_CORNERS\n";
    case hasp::CornerType::UInt16:
      return "#define HASP_UNSIGNED_CORNERS\n";
    case hasp::CornerType::Int16:
      break;
  }
  return {};
}

std::string AttributeDefines(const AttributeBuffers& attributes)
{
  std::string text;
  if (attributes.Labelled())
    text += "#define HASP_LABELS\n";
  if (attributes.Colored())
    text += "#define HASP_COLORS\n";
  if (attributes.Tabled())
    text += "#define HASP_COLOR_TABLE\n";
  return text;
}

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
/// Returns the declarations of those that our shader does not declare itself.
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
      declarations += "layout(location = " + std::to_string(n) + ") out vec4 " + name + ";\n";
  }
  return declarations;
}

} // namespace

/// What a variant is put together from, without what scene and passes add.
struct CellProgram::Variant
{
  CellPass pass;
  std::string vertex, fragment, defines;
};

vtkShaderProgram* CellProgram::Ready(Variant& variant, vtkOpenGLRenderWindow* window,
  vtkHaspClusteredCellMapper* mapper, vtkActor* actor, const CellScene& scene,
  vtkHardwareSelector* selector)
{
  const auto start = std::chrono::steady_clock::now();
  std::string geometry;
  const std::vector<vtkOpenGLRenderPass*> passes = PassesOf(actor);
  for (vtkOpenGLRenderPass* one : passes)
  {
    one->PreReplaceShaderValues(variant.vertex, geometry, variant.fragment, mapper, actor);
    one->PostReplaceShaderValues(variant.vertex, geometry, variant.fragment, mapper, actor);
  }
  variant.defines += scene.Defines();
  FillSlot(variant.vertex, "Defines", variant.defines);
  FillSlot(variant.fragment, "Defines", variant.defines + NameOutputs(variant.fragment));
  vtkShaderProgram* program = window->GetShaderCache()->ReadyShaderProgram(
    variant.vertex.c_str(), variant.fragment.c_str(), geometry.c_str());
  if (!program)
    return nullptr;
  double& milliseconds = this->Milliseconds[static_cast<int>(variant.pass)];
  if (milliseconds == 0.0)
    milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  for (vtkOpenGLRenderPass* one : passes)
    one->SetShaderParameters(program, mapper, actor);
  scene.SetUniforms(program);
  if (selector)
    SetSelectionUniforms(program, selector);
  return program;
}

vtkShaderProgram* CellProgram::Ready(vtkOpenGLRenderWindow* window,
  vtkHaspClusteredCellMapper* mapper, vtkActor* actor, const CellScene& scene,
  const AttributeBuffers& attributes, vtkHardwareSelector* selector, CellPass pass)
{
  constexpr const char* passDefines[] = { "", "#define HASP_SELECTION\n", "#define HASP_HITS\n",
    "#define HASP_SPLATS\n" };
  Variant variant{ pass, vtkHaspClusteredCellVS, vtkHaspClusteredCellFS,
    CornerDefines(mapper->GetCells()) + AttributeDefines(attributes) +
      passDefines[static_cast<int>(pass)] };
  FillSlot(variant.vertex, "CellLayout", CellLayout);
  FillSlot(variant.vertex, "CellFrame", CellFrame);
  FillSlot(variant.fragment, "RayRoot", RayRoot);
  FillSlot(variant.fragment, "CellFrame", CellFrame);
  FillSlot(variant.fragment, "CellShading", CellShading);
  FillSlot(variant.fragment, "CellColors", CellColors);
  FillSlot(variant.fragment, "CellSplat", CellSplat);
  FillSlot(variant.fragment, "CellSelection", CellSelection);
  vtkShaderProgram* program = this->Ready(variant, window, mapper, actor, scene, selector);
  const std::vector<float>& levels = mapper->GetCells().levels;
  if (program && !levels.empty())
    program->SetUniform1fv("levels", static_cast<int>(levels.size()), levels.data());
  return program;
}

vtkShaderProgram* CellProgram::ReadyTraced(vtkOpenGLRenderWindow* window,
  vtkHaspClusteredCellMapper* mapper, vtkActor* actor, const CellScene& scene,
  vtkHardwareSelector* selector, bool lit)
{
  Variant variant{ CellPass::Traced, vtkHaspTracedCellVS, vtkHaspTracedCellFS,
    selector ? "#define HASP_SELECTION\n"
    : lit    ? "#define HASP_TRACED_LIGHT\n"
             : "" };
  FillSlot(variant.fragment, "CellShading", CellShading);
  FillSlot(variant.fragment, "CellSelection", CellSelection);
  return this->Ready(variant, window, mapper, actor, scene, selector);
}
