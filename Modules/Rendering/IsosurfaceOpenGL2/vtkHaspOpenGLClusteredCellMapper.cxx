#include "vtkHaspOpenGLClusteredCellMapper.h"

#include "CellBuffers.h"
#include "CellProgram.h"
#include "CellScene.h"
#include "HaspGL.h"

#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkWeakPointer.h"

#include <chrono>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspOpenGLClusteredCellMapper);

namespace
{

/// While one lives, VTK's selector knows which actor is drawn and has blending off.
class SelectionScope
{
public:
  SelectionScope(vtkHardwareSelector* selector, std::size_t cells) : Selector(selector)
  {
    if (!selector)
      return;
    selector->UpdateMaximumCellId(static_cast<vtkIdType>(cells)); // decides if high bits get a pass
    selector->BeginRenderProp();
    if (selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
      selector->RenderCompositeIndex(1);
  }
  ~SelectionScope()
  {
    if (this->Selector)
      this->Selector->EndRenderProp();
  }
  SelectionScope(const SelectionScope&) = delete;
  SelectionScope& operator=(const SelectionScope&) = delete;

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
  CellProgram Program;
  vtkMTimeType CellsTime = 0; ///< of what is uploaded
  double UploadMilliseconds = 0.0;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkMTimeType Context = 0; ///< creation time, unique, of the window's context all this lives in

  bool LivesIn(vtkOpenGLRenderWindow* window) const
  {
    return window && window->GetContextCreationTime() == this->Context;
  }

  /// Back to nothing. What died with its context is forgotten, for its names may be others' by now.
  void Free(vtkOpenGLRenderWindow* window)
  {
    if (this->LivesIn(window))
    {
      window->PushContext();
      if (window->IsCurrent())
        this->Buffers.Release();
      window->PopContext();
    }
    *this = {};
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

  void Draw(vtkShaderProgram* program, const hasp::VisibleClusters& visible) const
  {
    const auto setFirstWord = [&](int first) { program->SetUniformi("firstWord", first); };
    const bool sized = glIsEnabled(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_PROGRAM_POINT_SIZE);
    program->SetUniformi("points", 1);
    this->Buffers.Draw(visible.points, GL_POINTS, 1, setFirstWord);
    if (!sized)
      glDisable(GL_PROGRAM_POINT_SIZE);
    program->SetUniformi("points", 0);
    this->Buffers.Draw(visible.rectangles, GL_TRIANGLES, 6, setFirstWord);
  }
};

vtkHaspOpenGLClusteredCellMapper::vtkHaspOpenGLClusteredCellMapper() : GL(new OpenGL) {}
vtkHaspOpenGLClusteredCellMapper::~vtkHaspOpenGLClusteredCellMapper()
{
  this->GL->Free(this->GL->Window);
}

void vtkHaspOpenGLClusteredCellMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  // A window that is being deleted is no longer behind the weak pointer, but still releases.
  auto* releasing = vtkOpenGLRenderWindow::SafeDownCast(window);
  this->GL->Free(this->GL->LivesIn(releasing) ? releasing : this->GL->Window.Get());
}

void vtkHaspOpenGLClusteredCellMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !this->UpdateCells())
    return;
  if (!this->GL->LivesIn(window)) // a mapper draws in one window at a time
  {
    this->GL->Free(this->GL->Window);
    window->MakeCurrent(); // not every window brings the last context back
    this->GL->Window = window;
    this->GL->Context = window->GetContextCreationTime();
  }
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

  const CellScene scene(this, renderer, actor);
  vtkHardwareSelector* selector = renderer->GetSelector();
  const SelectionScope selection(selector, this->GetCells().Count());
  vtkShaderProgram* program = this->GL->Program.Ready(window, this, actor, scene, selector);
  if (!program)
  {
    vtkErrorMacro("The shaders did not compile; OpenGL 4.3 is needed.");
    return;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  this->GL->Draw(
    program, CullClusters(this->GetCells(), scene.indexToClip, scene.viewportSize, LargestPoint()));
  vtkOpenGLCheckErrorMacro("after drawing active cells");
}

void vtkHaspOpenGLClusteredCellMapper::ListResources(hasp::ResourceList& list) const
{
  this->Superclass::ListResources(list);
  const CellBuffers& buffers = this->GL->Buffers;
  const CellProgram& program = this->GL->Program;
  list.push_back({ "active cells, GPU", buffers.Bytes(), this->GL->UploadMilliseconds,
    buffers.Uploaded() ? "drawn" : "nothing drawn" });
  list.push_back({ "shader: shaded cells", 0, program.ShadeMilliseconds(),
    program.ShadeMilliseconds() > 0 ? "compiled at the first frame" : "nothing drawn" });
  list.push_back({ "shader: cell selection", 0, program.SelectMilliseconds(),
    program.SelectMilliseconds() > 0 ? "a pick was asked for" : "no pick was asked for" });
  list.push_back({ "picking buffers", 0, 0.0, "none of its own: cell ids come from the cells" });
}
