#include "vtkHaspOpenGLClusteredCellMapper.h"

#include "CellBuffers.h"
#include "CellLayout.h"
#include "CellScene.h"
#include "HaspGL.h"
#include "RayRoot.h"
#include "vtkHaspClusteredCellFS.h"
#include "vtkHaspClusteredCellVS.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <array>
#include <chrono>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkHaspOpenGLClusteredCellMapper);

namespace
{

enum Variant
{
  ShadeCells,
  PickCells,
  VariantCount
};

void Fill(std::string& shader, const std::string& slot, const std::string& text)
{
  const std::size_t at = shader.find("//Hasp::" + slot);
  if (at != std::string::npos)
    shader.replace(at, slot.size() + 8, text);
}

std::string CornerDefines(hasp::CornerType corners)
{
  switch (corners)
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

/// Between construction and destruction VTK's selector has blending off and knows which actor is
/// drawn.
class SelectionPass
{
public:
  explicit SelectionPass(vtkHardwareSelector* selector) : Selector(selector)
  {
    if (!selector)
      return;
    selector->BeginRenderProp();
    if (selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
      selector->RenderCompositeIndex(1);
  }
  ~SelectionPass()
  {
    if (this->Selector)
      this->Selector->EndRenderProp();
  }
  SelectionPass(const SelectionPass&) = delete;
  SelectionPass& operator=(const SelectionPass&) = delete;

  /// What is to be written in this pass; see vtkHardwareSelector::PassTypes.
  void SetUniforms(vtkShaderProgram* program) const
  {
    if (!this->Selector)
      return;
    int shift = -1;
    if (this->Selector->GetCurrentPass() == vtkHardwareSelector::CELL_ID_LOW24)
      shift = 0;
    if (this->Selector->GetCurrentPass() == vtkHardwareSelector::CELL_ID_HIGH24)
      shift = 24;
    float color[3];
    this->Selector->GetPropColorValue(color);
    program->SetUniformi("selectionShift", shift);
    program->SetUniform3f("selectionColor", color);
  }

private:
  vtkHardwareSelector* Selector;
};

/// In pixels; one less than OpenGL's limit, for the shader rounds up.
double LargestPoint()
{
  GLfloat sizes[2] = { 1, 1 };
  glGetFloatv(GL_POINT_SIZE_RANGE, sizes);
  return sizes[1] - 1.0;
}

} // namespace

struct vtkHaspOpenGLClusteredCellMapper::OpenGL
{
  CellBuffers Buffers;
  vtkMTimeType CellsTime = 0; ///< of what is uploaded
  double UploadMilliseconds = 0.0;
  std::array<double, VariantCount> CompileMilliseconds{}; ///< 0: never asked for
  vtkOpenGLRenderWindow* Window = nullptr;

  vtkShaderProgram* ReadyProgram(
    vtkOpenGLRenderWindow* window, const std::string& defines, Variant variant)
  {
    const auto start = std::chrono::steady_clock::now();
    std::string vertex = vtkHaspClusteredCellVS, fragment = vtkHaspClusteredCellFS;
    Fill(vertex, "Defines", defines);
    Fill(vertex, "CellLayout", CellLayout);
    Fill(fragment, "Defines", defines);
    Fill(fragment, "RayRoot", RayRoot);
    vtkShaderProgram* program =
      window->GetShaderCache()->ReadyShaderProgram(vertex.c_str(), fragment.c_str(), "");
    if (program && this->CompileMilliseconds[variant] == 0.0)
      this->CompileMilliseconds[variant] =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return program;
  }

  void Upload(const hasp::ClusteredCells& cells, vtkMTimeType time)
  {
    if (time == this->CellsTime)
      return;
    const auto start = std::chrono::steady_clock::now();
    this->Buffers.Upload(cells);
    this->CellsTime = time;
    this->UploadMilliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }
};

vtkHaspOpenGLClusteredCellMapper::vtkHaspOpenGLClusteredCellMapper() : GL(new OpenGL) {}
vtkHaspOpenGLClusteredCellMapper::~vtkHaspOpenGLClusteredCellMapper() = default;

void vtkHaspOpenGLClusteredCellMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  if (this->GL->Window && this->GL->Window == window)
    this->GL->Window->MakeCurrent();
  this->GL->Buffers.Release();
  *this->GL = {};
}

void vtkHaspOpenGLClusteredCellMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !this->UpdateCells())
    return;
  if (this->GL->Window && this->GL->Window != window)
    this->ReleaseGraphicsResources(this->GL->Window); // a mapper draws in one window at a time
  this->GL->Window = window;
  try
  {
    this->GL->Upload(this->GetCells(), this->GetCellsTime());
  }
  catch (const std::exception& e)
  {
    vtkErrorMacro("Cannot draw the isosurface: " << e.what());
    return;
  }
  if (!this->GL->Buffers.Uploaded())
    return; // no surface at this isovalue

  vtkHardwareSelector* selector = renderer->GetSelector();
  const CellScene scene(this, renderer, actor);
  std::string defines = CornerDefines(this->GetCells().cornerType) + scene.Defines();
  if (selector)
  {
    selector->UpdateMaximumCellId(static_cast<vtkIdType>(this->GetCells().Count()));
    defines += "#define HASP_SELECTION\n";
  }
  vtkShaderProgram* program =
    this->GL->ReadyProgram(window, defines, selector ? PickCells : ShadeCells);
  if (!program)
  {
    vtkErrorMacro("The shaders did not compile; OpenGL 4.3 is needed.");
    return;
  }
  scene.SetUniforms(program);
  const SelectionPass selection(selector);
  selection.SetUniforms(program);
  const hasp::VisibleCells visible =
    CullClusters(this->GetCells(), scene.indexToClip, scene.viewportSize, LargestPoint());

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  glEnable(GL_PROGRAM_POINT_SIZE);
  const auto draw = [&]
  {
    const auto setFirstCell = [&](int first) { program->SetUniformi("firstCell", first); };
    program->SetUniformi("points", 1);
    this->GL->Buffers.Draw(visible.points, GL_POINTS, 1, setFirstCell);
    program->SetUniformi("points", 0);
    this->GL->Buffers.Draw(visible.rectangles, GL_TRIANGLES, 6, setFirstCell);
  };
  if (!selector && actor->GetProperty()->GetOpacity() < 1.0)
  {
    // Cells come in no order: depth first, then only the nearest layer is blended.
    vtkOpenGLState::ScopedglDepthMask depthMask(state);
    vtkOpenGLState::ScopedglColorMask colorMask(state);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw();
  }
  draw();
  glDisable(GL_PROGRAM_POINT_SIZE);
  vtkOpenGLCheckErrorMacro("after drawing active cells");
}

void vtkHaspOpenGLClusteredCellMapper::ListResources(hasp::ResourceList& list) const
{
  this->Superclass::ListResources(list);
  const OpenGL& gl = *this->GL;
  list.push_back({ "active cells, GPU", gl.Buffers.Bytes(), gl.UploadMilliseconds,
    gl.Buffers.Uploaded() ? "drawn" : "nothing drawn yet" });
  list.push_back({ "shader: shaded cells", 0, gl.CompileMilliseconds[ShadeCells],
    gl.CompileMilliseconds[ShadeCells] > 0 ? "compiled at the first frame" : "nothing drawn yet" });
  list.push_back({ "shader: cell selection", 0, gl.CompileMilliseconds[PickCells],
    gl.CompileMilliseconds[PickCells] > 0 ? "a pick was asked for" : "no pick was asked for" });
  list.push_back({ "picking buffers", 0, 0.0, "none of its own: cell ids come from the cells" });
}
