#include "RendererSwitch.h"

#include "CellTracing.h"
#include "HaspGL.h"
#include "vtkHaspClusteredCellMapper.h"

#include "vtkRenderer.h"

#include <algorithm>

bool RendererSwitch::IsTraced(const Frame& frame)
{
  this->Last = this->Measuring = -1;
  const auto because = [this](bool traced, const char* why)
  {
    this->Reason = std::string(traced ? "traced: " : "rasterised: ") + why;
    return traced;
  };
  if (frame.wanted == vtkHaspClusteredCellMapper::Rasterize)
    return because(false, "as asked for");
  if (!frame.traceable)
    return because(false, "labels, scalar colours and blended normals always are");
  if (!frame.hides)
    return because(false, "translucent surfaces always are");
  if (frame.wanted == vtkHaspClusteredCellMapper::Trace)
    return because(true, "as asked for");
  if (!CellTracing::Available())
    return because(false, "this build has no ray tracing (Embree)");
  if (frame.lit)
    return because(true, "ambient occlusion and shadows take rays");
  if (!frame.softwareOpenGL)
    return because(false, "OpenGL is not software");

  std::erase_if(this->Viewers, [](const Viewer& viewer) { return !viewer.renderer; });
  auto found = std::find_if(this->Viewers.begin(), this->Viewers.end(),
    [&](const Viewer& viewer) { return viewer.renderer == frame.renderer; });
  if (found == this->Viewers.end())
    found = this->Viewers.insert(found, Viewer{ frame.renderer, {} });
  this->Last = static_cast<int>(found - this->Viewers.begin());
  const int* size = frame.renderer->GetSize();
  const bool traced = found->choice.Trace(
    frame.cells, static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  if (!found->choice.Decided() && !frame.renderer->GetSelector())
    this->Measuring = this->Last;
  return traced;
}

std::string RendererSwitch::Text() const
{
  return this->Last < 0 ? this->Reason : this->Viewers[this->Last].choice.Text();
}

bool RendererSwitch::MayTrace(int wanted) const
{
  if (wanted != vtkHaspClusteredCellMapper::Automatic)
    return wanted == vtkHaspClusteredCellMapper::Trace;
  return std::any_of(this->Viewers.begin(), this->Viewers.end(),
    [](const Viewer& viewer) { return viewer.choice.MayTrace(); });
}

void RendererSwitch::Start()
{
  if (!this->Measures())
    return;
  glFinish();
  this->Begin = std::chrono::steady_clock::now();
}

void RendererSwitch::Finish()
{
  if (!this->Measures())
    return;
  glFinish();
  const std::chrono::duration<double, std::milli> spent =
    std::chrono::steady_clock::now() - this->Begin;
  this->Viewers[this->Measuring].choice.Note(spent.count());
}
