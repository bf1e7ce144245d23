#include "RendererSwitch.h"

#include "CellTracing.h"
#include "HaspGL.h"
#include "vtkHaspClusteredCellMapper.h"

#include "vtkRenderer.h"

#include <algorithm>

bool RendererSwitch::IsTraced(const Frame& frame)
{
  this->Last = this->Measuring = -1;
  this->RefusalText.clear();
  const std::string lack = frame.openGL.Lack("rasterising");
  const auto trace = [this](const std::string& why)
  {
    this->Reason = "traced: " + why;
    return true;
  };
  const auto rasterize = [&](const std::string& why, const char* remedy = "")
  {
    this->Reason = lack.empty() ? "rasterised: " + why : "not drawn: " + lack;
    this->RefusalText = lack.empty() ? std::string() : lack + "; " + remedy;
    return false;
  };
  if (frame.wanted == vtkHaspClusteredCellMapper::Rasterize)
    return rasterize("as asked for", "the renderer automatic traces rays on the CPU instead");
  if (!frame.traceable)
    return rasterize("labels, scalar colours and blended normals always are",
      "labels, scalar colours and blended normals are drawn in no other way");
  if (!frame.hides)
    return rasterize("translucent surfaces always are",
      "translucent surfaces are drawn in no other way; make it opaque");
  if (frame.wanted == vtkHaspClusteredCellMapper::Trace)
    return trace("as asked for");
  if (!CellTracing::Available())
    return rasterize("this build has no ray tracing (Embree)",
      "rays on the CPU would do with 3.2, and need a build with Embree: HASP_ENABLE_EMBREE=ON "
      "(Debian: libembree-dev)");
  if (!lack.empty())
    return trace(lack);
  if (frame.lit)
    return trace("ambient occlusion and shadows take rays");
  if (!frame.softwareOpenGL)
    return rasterize("OpenGL is not software");

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
