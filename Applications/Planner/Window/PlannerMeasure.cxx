#include "Window/PlannerMeasure.h"

#include "Grid/Phantom.h"
#include "Window/MeasureDrag.h"
#include "Window/MeasureWindow.h"
#include "Window/PlannerWindow.h"
#include "vtkHaspVolumeHash.h"
#include "vtkHaspVolumeView.h"

#include "vtkActor.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;
constexpr double LowIso = 226.0, HighIso = 400.0;
constexpr int WarmUps = 2;

/// A phantom of so many samples a side, as the plan's only scan.
void ShowPhantom(PlannerWindow& window, int size)
{
  const GridGeometry grid = PhantomGridOfSize(glm::ivec3(size));
  std::vector<std::int16_t> samples = SamplePhantom(grid);
  ShelfScan scan;
  scan.passport.geometry = grid;
  scan.passport.hounsfield = true;
  scan.passport.hash = VolumeHash(GridView<const std::int16_t>{ samples.data(), grid });
  scan.image = MakeImage(grid, std::move(samples));
  Planner& parts = window.Parts();
  parts.plan.BeginNew();
  const std::string hash = scan.passport.hash;
  parts.scans.Put(std::move(scan));
  parts.plan.Do(AddObject<PlanVolume>{ { parts.plan.NewId(), "phantom", hash } });
  WaitSettled(window);
  parts.scene.LookFrom('A');
  WaitSettled(window);
}

/// VTK's way in the same view: a mesh anew, and its picture.
class MeshRival
{
public:
  explicit MeshRival(Planner& planner) : Of(planner)
  {
    this->Edges->SetInputData(planner.scene.ShownImage());
    this->Edges->ComputeNormalsOn();
    this->Mapper->SetInputConnection(this->Edges->GetOutputPort());
    this->Mapper->ScalarVisibilityOff();
    this->Actor->SetMapper(this->Mapper);
  }
  double Ms(double isovalue)
  {
    vtkRenderer* renderer = this->Of.views.Scene().Renderer();
    const PlanId volume = this->Of.scene.ShownVolume();
    this->Of.scene.SetVisible(volume, false);
    renderer->AddActor(this->Actor);
    this->Edges->SetValue(0, isovalue);
    const double ms = DrawnMs(this->Of.views.Scene());
    renderer->RemoveActor(this->Actor);
    this->Of.scene.SetVisible(volume, true);
    return ms;
  }

private:
  Planner& Of;
  vtkNew<vtkFlyingEdges3D> Edges;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

Json MeasureIsovalue(PlannerWindow& window, int size, int pairs)
{
  ShowPhantom(window, size);
  Planner& parts = window.Parts();
  SceneView& view = parts.views.Scene();
  MeshRival rival(parts);
  Json ours = Json::array(), theirs = Json::array();
  double squares = 0.0;
  for (int pair = -WarmUps; pair < pairs; ++pair)
  {
    const double isovalue = LowIso + (HighIso - LowIso) * (pair + WarmUps) / (pairs + WarmUps);
    const auto start = Clock::now();
    parts.scene.SetIsovalue(isovalue, true);
    WaitFrame(view);
    const double ms = MsSince(start);
    const QImage moving = view.grabFramebuffer();
    parts.scene.SetIsovalue(isovalue, false);
    WaitSettled(window);
    const double rms = RmsBetween(moving, view.grabFramebuffer());
    const double rivalMs = rival.Ms(isovalue);
    WaitSettled(window);
    if (pair < 0)
      continue;
    ours.push_back(ms);
    theirs.push_back(rivalMs);
    squares += rms * rms;
  }
  const double rms = std::sqrt(squares / pairs);
  return { { "size", size }, { "ours_ms", ours }, { "rival_ms", theirs }, { "rms_255", rms },
    { "psnr_db", rms > 0.0 ? 20.0 * std::log10(255.0 / rms) : 99.0 } };
}

Json MeasureIdle(PlannerWindow& window, double seconds)
{
  WaitSettled(window);
  const unsigned long long before = window.Parts().views.Scene().Frames();
  Spend(seconds);
  return { { "seconds", seconds }, { "frames", window.Parts().views.Scene().Frames() - before } };
}

/// Opens a saved plan and a new one in turn.
Json MeasureReopening(PlannerWindow& window, int times)
{
  Planner& parts = window.Parts();
  const std::filesystem::path place = parts.plan.Folder() / "measured.hasp";
  parts.plan.Do(SetCaseLabel{ "measured" });
  if (!parts.plan.SaveAs(place))
    throw std::runtime_error("the measured plan cannot be saved");
  const auto again = [&]
  {
    parts.plan.BeginNew();
    parts.plan.Open(place);
    WaitSettled(window);
  };
  for (int warm = 0; warm < times / 10; ++warm) // what is kept for the next time is there then
    again();
  const std::size_t before = ResidentBytes();
  for (int n = 0; n < times; ++n)
    again();
  return { { "times", times }, { "bytes_before", before }, { "bytes_after", ResidentBytes() } };
}
} // namespace

Json MeasurePlanner(PlannerWindow& window, bool quick, double startedS)
{
  Json measured;
  window.TrySample(Sample::Skull);
  WaitSettled(window);
  measured["first_ms"] = 1e3 * (NowS() - startedS);
  measured["idle"] = MeasureIdle(window, quick ? 1.0 : 5.0);
  measured["isovalue"] = Json::array({ MeasureIsovalue(window, 256, 9) });
  if (!quick)
    measured["isovalue"].push_back(MeasureIsovalue(window, 512, 9));
  measured["reopened"] = MeasureReopening(window, quick ? 100 : 1000);
  measured["drag"] = MeasureDrag(window, quick ? 2.0 : 5.0);
  return measured;
}

} // namespace hasp
