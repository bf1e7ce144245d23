#include "vtkHaspOpenGLClusteredCellMapper.h"

#include "CellScene.h"
#include "HaspGL.h"
#include "OpenGLClusteredCells.h"
#include "SelectionScope.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <exception>
#include <stdexcept>

vtkStandardNewMacro(vtkHaspOpenGLClusteredCellMapper);

namespace
{

/// In pixels; one less than OpenGL's limit, for the shader rounds up.
double LargestPoint()
{
  GLfloat sizes[2] = { 1, 1 };
  glGetFloatv(GL_POINT_SIZE_RANGE, sizes);
  return sizes[1] - 1.0;
}

/// Can what is drawn now hide what is drawn later in this pass?
bool HidesWhatIsBehind(vtkActor* actor)
{
  GLint function = 0;
  GLboolean writes = GL_FALSE;
  glGetIntegerv(GL_DEPTH_FUNC, &function);
  glGetBooleanv(GL_DEPTH_WRITEMASK, &writes);
  return writes && glIsEnabled(GL_DEPTH_TEST) && (function == GL_LEQUAL || function == GL_LESS) &&
         !actor->IsRenderingTranslucentPolygonalGeometry();
}

/// While one lives, vertex shaders give points their size.
class PointSizeScope
{
public:
  PointSizeScope() : Sized(glIsEnabled(GL_PROGRAM_POINT_SIZE)) { glEnable(GL_PROGRAM_POINT_SIZE); }
  ~PointSizeScope()
  {
    if (!this->Sized)
      glDisable(GL_PROGRAM_POINT_SIZE);
  }
  PointSizeScope(const PointSizeScope&) = delete;
  PointSizeScope& operator=(const PointSizeScope&) = delete;

private:
  bool Sized;
};

/// Which labels a pass draws where some are opaque and some translucent: 1 the opaque ones, 0 the
/// others, -1 all, for the actor has one pass alone.
int OpaquePass(vtkActor* actor)
{
  if (actor->GetForceOpaque() || actor->GetForceTranslucent() ||
      actor->GetProperty()->GetOpacity() < 1.0 || !actor->GetMapper()->HasOpaqueGeometry())
    return -1;
  return actor->IsRenderingTranslucentPolygonalGeometry() ? 0 : 1;
}

} // namespace

vtkHaspOpenGLClusteredCellMapper::vtkHaspOpenGLClusteredCellMapper() : GL(new OpenGL) {}
vtkHaspOpenGLClusteredCellMapper::~vtkHaspOpenGLClusteredCellMapper() = default;

void vtkHaspOpenGLClusteredCellMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->GL->Contexts.Free(vtkOpenGLRenderWindow::SafeDownCast(window));
}

std::size_t vtkHaspOpenGLClusteredCellMapper::GetStorageBlockBytes() const
{
  GLint bytes = 0;
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  return static_cast<std::size_t>(bytes);
}

void vtkHaspOpenGLClusteredCellMapper::SetRenderer(int renderer)
{
  if (renderer == Trace && !CellTracing::Available())
    vtkErrorMacro("Rays cannot be traced: this build of Hasp was made without Embree; configure it "
                  "with HASP_ENABLE_EMBREE=ON (Debian: libembree-dev).");
  else
    this->Superclass::SetRenderer(renderer);
}

std::string vtkHaspOpenGLClusteredCellMapper::GetRendererChoice() const
{
  return this->GL->Switch.Text();
}

void vtkHaspOpenGLClusteredCellMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window || !this->UpdateCells())
    return;
  window->MakeCurrent(); // not every window brings the last context back
  CellContext& context = this->GL->Contexts.Of(window);
  vtkOpenGLState::ScopedglEnableDisable cull(window->GetState(), GL_CULL_FACE);
  window->GetState()->vtkglDisable(GL_CULL_FACE); // rectangles have no sides
  // A cell draws the pixels whose centre it covers, whole: parts of pixels would leave seams.
  vtkOpenGLState::ScopedglEnableDisable samples(window->GetState(), GL_MULTISAMPLE);
  window->GetState()->vtkglDisable(GL_MULTISAMPLE);
  try
  {
    RendererSwitch& renderers = this->GL->Switch;
    const bool traceable = !this->NeedsRasterizer();
    const bool lit = this->AmbientOcclusion || this->Shadows;
    const bool traced =
      renderers.IsTraced({ this->Renderer, traceable, renderer, HidesWhatIsBehind(actor),
        context.Version, context.SoftwareOpenGL, this->GetCells().Count(), lit });
    const std::string& refusal = renderers.Refusal();
    this->NoteLight(lit && !traced && refusal.empty());
    if (traced)
      this->DrawTraced(context, renderer, actor);
    else if (refusal.empty())
      this->DrawRasterized(context, renderer, actor);
    const bool mayTrace = traced || renderers.MayTrace(this->Renderer);
    if (!traceable || !mayTrace || this->GetCells().Count() == 0)
    {
      this->GL->Tracing.Release();
      this->GL->Light.Release();
      context.Traced.Release();
    }
    if (!refusal.empty())
      throw std::runtime_error(refusal);
    vtkOpenGLCheckErrorMacro("after drawing active cells");
    context.Complaint.clear();
  }
  catch (const std::exception& e)
  {
    if (context.Complaint != e.what())
      vtkErrorMacro("Cannot draw the isosurface: " << e.what());
    context.Complaint = e.what();
  }
}

/// Says once that a picture lacks light.
void vtkHaspOpenGLClusteredCellMapper::NoteLight(bool lacking)
{
  if (lacking && !this->GL->Unlit)
    vtkErrorMacro("Ambient occlusion and shadows are not drawn, for they take traced rays; this "
                  "surface is "
                  << this->GL->Switch.Text() << ".");
  this->GL->Unlit = lacking;
}

/// The light of the picture at hand; null if none is asked for.
const CellLight* vtkHaspOpenGLClusteredCellMapper::UpdateLight(
  const CellScene& scene, vtkRenderer* renderer)
{
  CellLight& light = this->GL->Light;
  const CellLight::Wanted wanted{ this->AmbientOcclusion, this->Shadows,
    this->AmbientOcclusionDistance };
  if (!wanted.Any())
    light.Release();
  if (!wanted.Any() || renderer->GetSelector())
    return nullptr;
  CellLight::Edit edit{};
  edit.time = this->GetLastEdit(&edit.low.x, &edit.high.x);
  light.Update(this->GL->Tracing, scene, renderer, wanted, this->GetCellsTime(), edit);
  return &light;
}

/// One frame's worth of what the passes share.
struct vtkHaspOpenGLClusteredCellMapper::Pass
{
  CellContext& context;
  vtkOpenGLRenderWindow* window;
  vtkRenderer* renderer;
  vtkActor* actor;
  const CellScene& scene;
  vtkHardwareSelector* selector;
};

/// The clusters in view; for the other eye of a rig, too, whose frame then finds them.
CellDraws vtkHaspOpenGLClusteredCellMapper::InView(const Pass& pass, double margin)
{
  CellContext& context = pass.context;
  const CellScene& scene = pass.scene;
  const double pointLimit = LargestPoint();
  const auto cull = [&](std::span<const glm::dmat4> views)
  {
    return context.Attributes.Moved()
             ? context.Attributes.Cull(views, scene.viewportSize, pointLimit, margin)
             : CullClusters(this->GetCells(), views, scene.viewportSize, pointLimit, margin);
  };
  if (!scene.otherIndexToClip)
    return CellDraws(cull(std::span(&scene.indexToClip, 1)).front(), context.Buffers.Parts());
  const EyeCulling::View view{ scene.indexToClip, scene.viewportSize, pointLimit, margin,
    std::max(this->GetCellsTime(), this->GetAttributesTime()), this->GetLabelsTime() };
  return CellDraws(
    context.Eyes.Visible(view, *scene.otherIndexToClip, cull), context.Buffers.Parts());
}

vtkShaderProgram* vtkHaspOpenGLClusteredCellMapper::ReadyProgram(const Pass& pass, CellPass what)
{
  AttributeBuffers& attributes = pass.context.Attributes;
  vtkShaderProgram* program = pass.context.Program.Ready(
    pass.window, this, pass.actor, pass.scene, attributes, pass.selector, what);
  if (!program)
    throw std::runtime_error("the shaders did not compile");
  if (attributes.Labelled())
    program->SetUniformi("opaquePass", pass.selector ? -1 : OpaquePass(pass.actor));
  return program;
}

void vtkHaspOpenGLClusteredCellMapper::DrawCells(
  const Pass& pass, vtkShaderProgram* program, const CellDraws& draws, bool occlusion)
{
  CellContext& context = pass.context;
  const hasp::ClusteredCells& cells = this->GetCells();
  const auto prepare = [&](const DrawRange& range)
  {
    context.Attributes.Bind(cells, range.part.first, range.part.end, program);
    program->SetUniformi("points", range.points);
    program->SetUniformi("firstWord", static_cast<int>(range.part.firstWord));
  };
  if (occlusion)
    context.UseCulling(cells).Draw({ pass.window, pass.renderer, pass.actor,
      static_cast<bool>(pass.renderer->GetActiveCamera()->GetLeftEye()), pass.scene,
      context.Buffers, draws, [&] { pass.window->GetShaderCache()->ReadyShaderProgram(program); },
      prepare });
  else
    context.Buffers.Draw(draws, prepare, context.SoftwareOpenGL);
  context.Attributes.Unbind();
}

/// Is something asked for that only the rasteriser draws?
bool vtkHaspOpenGLClusteredCellMapper::NeedsRasterizer() const
{
  const hasp::ClusteredCells& cells = this->GetCells();
  return this->BlendNormals || (!cells.labels.empty() && !this->GetLabels().empty()) ||
         (this->ScalarVisibility && !cells.colors.empty());
}

void vtkHaspOpenGLClusteredCellMapper::DrawTraced(
  CellContext& context, vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->GL->Switch.Measures())
    context.ReleaseUnusedBuffers();
  context.Attributes.Release(); // NeedsRasterizer() says that nothing of them is asked for
  context.Blending.Release();
  if (this->GetCells().Count() == 0)
    return;
  CellTracing& tracing = this->GL->Tracing;
  this->GL->Switch.Start(); // new cells cost a tree, or an upload
  tracing.Update(this->GetCells(), this->GetCellsTime());
  const CellScene scene(this, this->GetCells().geometry, this->GetCells().isovalue, renderer, actor,
    this->GetColoring().uniform);
  vtkHardwareSelector* selector = renderer->GetSelector();
  const SelectionScope selection(selector, static_cast<vtkIdType>(this->GetCells().Count()));
  // A pick has several passes, each a frame of its own, and follows one that was looked at.
  const vtkMTimeType since = this->GL->Switch.Measures() ? VTK_MTIME_MAX
                             : selector                  ? 0
                                                         : context.GetFrameTime();
  tracing.Trace(scene, since, !selector && (this->AmbientOcclusion || this->Shadows));
  const CellLight* light = this->UpdateLight(scene, renderer);
  context.Traced.Upload(window, tracing, selector != nullptr, light);
  vtkShaderProgram* program =
    context.Program.ReadyTraced(window, this, actor, scene, selector, light != nullptr);
  if (!program)
    throw std::runtime_error("the shaders did not compile");
  context.Traced.Draw(program, tracing, scene);
  this->GL->Switch.Finish();
}

void vtkHaspOpenGLClusteredCellMapper::DrawRasterized(
  CellContext& context, vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  AttributeBuffers& attributes = context.Attributes;
  this->GL->Switch.Start();
  context.Upload(this->GetCells(), this->GetCellsTime(), this->GetStorageBlockBytes());
  hasp::CellRange edited;
  const bool edit = this->GetLastLabelEdit(attributes.CellsTime(), edited.first, edited.end);
  attributes.Update(this->GetCells(), this->GetColoring(), this->GetLabels(),
    this->ScalarVisibility,
    { std::max(this->GetCellsTime(), this->GetAttributesTime()), this->GetLabelsTime() },
    edit ? std::optional(edited) : std::nullopt);
  if (!this->OcclusionCulling || attributes.Moved())
    context.Culling.Release();
  if (!this->BlendNormals)
    context.Blending.Release();
  if (!context.Buffers.Uploaded())
    return; // no surface at this isovalue
  const CellScene scene(this, this->GetCells().geometry, this->GetCells().isovalue, renderer, actor,
    this->GetColoring().uniform);
  if (attributes.Labelled())
    attributes.UpdateFrames(scene);
  vtkHardwareSelector* selector = renderer->GetSelector();
  const SelectionScope selection(selector, static_cast<vtkIdType>(this->GetCells().Count()));
  const Pass pass{ context, window, renderer, actor, scene, selector };
  const PointSizeScope sizes;
  const CellDraws draws = this->InView(pass, 0.0);
  const bool hides = !selector && HidesWhatIsBehind(actor);
  const bool occlusion = this->OcclusionCulling && hides && !attributes.Moved();
  if (this->BlendNormals && hides)
    context.Blending.Draw(
      window, scene, attributes.Labelled() || attributes.Colored(),
      [&] { this->DrawCells(pass, this->ReadyProgram(pass, CellPass::Hits), draws, occlusion); },
      [&](const NormalBlending::Textures& bind)
      {
        vtkShaderProgram* program = this->ReadyProgram(pass, CellPass::Splats);
        bind(program);
        this->DrawCells(pass, program, this->InView(pass, 0.5), false);
      });
  else
    this->DrawCells(pass, this->ReadyProgram(pass, selector ? CellPass::Select : CellPass::Shade),
      draws, occlusion);
  this->GL->Switch.Finish();
}
