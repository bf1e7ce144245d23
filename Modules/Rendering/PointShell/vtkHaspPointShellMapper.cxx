#include "vtkHaspPointShellMapper.h"

#include "DiscContext.h"
#include "DiscInput.h"
#include "Haptics/PointShell.h"
#include "HaspGL.h"
#include "WindowContexts.h"

#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <exception>
#include <utility>

vtkStandardNewMacro(vtkHaspPointShellMapper);

struct vtkHaspPointShellMapper::Internals
{
  /// What the discs are made from.
  struct Source
  {
    std::shared_ptr<const hasp::PointShell> shell;
    std::shared_ptr<const Discs> discs;
    int levels = 0;
    vtkDataObject* input = nullptr;
    vtkMTimeType inputTime = 0;
    std::string areaArray;
    double overlap = 0.0; // for the bounds
    bool operator==(const Source&) const = default;
  };

  Source Given, Made;
  std::shared_ptr<const Discs> All = std::make_shared<const Discs>();
  DiscBounds Bounds;
  WindowContexts<DiscContext> Contexts;
};

vtkHaspPointShellMapper::vtkHaspPointShellMapper() : Inside(new Internals)
{
  this->ScalarVisibility = 0;
}

vtkHaspPointShellMapper::~vtkHaspPointShellMapper() = default;

int vtkHaspPointShellMapper::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkHaspPointShellMapper::SetPointShell(std::shared_ptr<const hasp::PointShell> shell)
{
  if (shell == this->Inside->Given.shell && !this->Inside->Given.discs)
    return;
  this->Inside->Given.shell = std::move(shell);
  this->Inside->Given.discs = nullptr;
  this->Modified();
}

void vtkHaspPointShellMapper::SetDiscs(std::shared_ptr<const Discs> discs)
{
  if (discs == this->Inside->Given.discs && !this->Inside->Given.shell)
    return;
  this->Inside->Given.discs = std::move(discs);
  this->Inside->Given.shell = nullptr;
  this->Modified();
}

void vtkHaspPointShellMapper::SetAreaArrayName(const std::string& name)
{
  if (name == this->AreaArrayName)
    return;
  this->AreaArrayName = name;
  this->Modified();
}

void vtkHaspPointShellMapper::GetLevelColor(int level, double rgb[3])
{
  // Set apart also for who cannot tell red from green: after Okabe and Ito, the dark ones
  // lightened.
  constexpr double colors[8][3] = { { 0.90, 0.62, 0.00 }, { 0.34, 0.71, 0.91 },
    { 0.00, 0.62, 0.45 }, { 0.94, 0.89, 0.26 }, { 0.10, 0.45, 0.75 }, { 0.84, 0.37, 0.00 },
    { 0.80, 0.47, 0.65 }, { 0.60, 0.60, 0.60 } };
  std::copy_n(colors[static_cast<unsigned int>(level) % 8U], 3, rgb);
}

void vtkHaspPointShellMapper::UpdateDiscs()
{
  Internals& in = *this->Inside;
  Internals::Source source = in.Given;
  source.overlap = this->Overlap;
  if (source.shell)
    source.levels = this->Levels;
  vtkPolyData* points = nullptr;
  if (!source.shell && !source.discs && this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->Update();
    points = vtkPolyData::SafeDownCast(this->GetInputDataObject(0, 0));
    source.input = points;
    source.inputTime = points ? points->GetMTime() : 0;
    source.areaArray = this->AreaArrayName;
  }
  if (source == in.Made)
    return;
  in.Made = source;
  in.All = std::make_shared<const Discs>();
  in.Bounds = {};
  try
  {
    std::shared_ptr<const Discs> all = source.shell   ? DiscsOfShell(*source.shell, source.levels)
                                       : source.discs ? source.discs
                                       : points       ? DiscsOfPoints(points, source.areaArray)
                                                      : in.All;
    in.Bounds = CheckDiscs(*all, this->Overlap);
    in.All = std::move(all);
  }
  catch (const std::exception& e)
  {
    vtkErrorMacro("Cannot draw the pointshell: " << e.what() << ".");
  }
}

vtkIdType vtkHaspPointShellMapper::GetNumberOfDiscs()
{
  this->UpdateDiscs();
  return static_cast<vtkIdType>(this->Inside->All->size());
}

double* vtkHaspPointShellMapper::GetBounds()
{
  this->UpdateDiscs();
  vtkMath::UninitializeBounds(this->Bounds);
  const DiscBounds& bounds = this->Inside->Bounds;
  for (int axis = 0; axis < 3 && bounds.Any(); ++axis)
  {
    this->Bounds[2 * axis] = bounds.low[axis];
    this->Bounds[2 * axis + 1] = bounds.high[axis];
  }
  return this->Bounds;
}

void vtkHaspPointShellMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->UpdateDiscs();
  if (!window || this->Inside->All->empty())
    return;
  window->MakeCurrent(); // not every window brings the last context back
  DiscContext& context = this->Inside->Contexts.Of(window);
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE), samples(state, GL_MULTISAMPLE);
  state->vtkglDisable(GL_CULL_FACE); // rectangles have no sides
  state->vtkglDisable(GL_MULTISAMPLE);
  try
  {
    context.Draw(this, renderer, actor, this->Inside->All, { this->Overlap, this->ColorByLevel });
    vtkOpenGLCheckErrorMacro("after drawing discs");
    context.Complaint.clear();
  }
  catch (const std::exception& e)
  {
    if (context.Complaint != e.what())
      vtkErrorMacro("Cannot draw the pointshell: " << e.what() << ".");
    context.Complaint = e.what();
  }
}

void vtkHaspPointShellMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Inside->Contexts.Free(vtkOpenGLRenderWindow::SafeDownCast(window));
}

void vtkHaspPointShellMapper::ListResources(hasp::ResourceList& list) const
{
  hasp::ResourceUse discs{ "discs, GPU", 0, 0.0, "no disc was drawn" };
  hasp::ResourceUse textures{ "disc blending", 0, 0.0, "no disc was drawn" };
  hasp::ResourceUse shaders{ "shader: discs", 0, 0.0, "no disc was drawn" };
  for (const auto& context : this->Inside->Contexts)
  {
    discs.bytes += context->Buffer.Bytes();
    discs.milliseconds += context->UploadMilliseconds;
    if (context->Buffer.Bytes() > 0)
      discs.reason = std::to_string(context->Buffer.UploadedDiscs()) + " uploaded last";
    textures.bytes += context->Targets.Bytes();
    if (context->Targets.Bytes() > 0)
      textures.reason = "textures as large as the window";
    shaders.milliseconds += context->ShaderMilliseconds;
    if (context->ShaderMilliseconds > 0.0)
      shaders.reason = "compiled at the first frame";
  }
  list.push_back(discs);
  list.push_back(textures);
  list.push_back(shaders);
}
