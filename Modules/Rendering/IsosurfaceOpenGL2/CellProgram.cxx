#include "CellProgram.h"

#include "AttributeBuffers.h"
#include "CellColors.h"
#include "CellFrame.h"
#include "CellLayers.h"
#include "CellLayout.h"
#include "CellScene.h"
#include "CellSplat.h"
#include "HaspGL.h"
#include "PassShader.h"
#include "RayRoot.h"
#include "SelectionColor.h"
#include "SelectionScope.h"
#include "ShaderSlots.h"
#include "SurfaceShading.h"
#include "vtkHaspClusteredCellFS.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspClusteredCellVS.h"
#include "vtkHaspTracedCellFS.h"
#include "vtkHaspTracedCellVS.h"

#include "vtkActor.h"
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

/// Of surfaces that others are seen through: all of them count, not the nearest alone.
std::string LayerDefines(vtkActor* actor)
{
  if (!actor->IsRenderingTranslucentPolygonalGeometry())
    return {};
  GLint equation = GL_FUNC_ADD;
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &equation);
  const bool peels = glIsEnabled(GL_BLEND) && equation == GL_MAX;
  return std::string("#define HASP_LAYERS\n") + (peels ? "#define HASP_PEELS\n" : "");
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
  vtkShaderProgram* program = ReadyPassShader(
    window, mapper, actor, variant.vertex, variant.fragment, variant.defines + scene.Defines());
  if (!program)
    return nullptr;
  double& milliseconds = this->Milliseconds[static_cast<int>(variant.pass)];
  if (milliseconds == 0.0)
    milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
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
      passDefines[static_cast<int>(pass)] + (pass == CellPass::Shade ? LayerDefines(actor) : "") };
  FillSlot(variant.fragment, "CellLayers", CellLayers);
  FillSlot(variant.vertex, "CellLayout", CellLayout);
  FillSlot(variant.vertex, "CellFrame", CellFrame);
  FillSlot(variant.fragment, "RayRoot", RayRoot);
  FillSlot(variant.fragment, "CellFrame", CellFrame);
  FillSlot(variant.fragment, "SurfaceShading", SurfaceShading);
  FillSlot(variant.fragment, "CellColors", CellColors);
  FillSlot(variant.fragment, "CellSplat", CellSplat);
  FillSlot(variant.fragment, "SelectionColor", SelectionColor);
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
  FillSlot(variant.fragment, "SurfaceShading", SurfaceShading);
  FillSlot(variant.fragment, "SelectionColor", SelectionColor);
  return this->Ready(variant, window, mapper, actor, scene, selector);
}
