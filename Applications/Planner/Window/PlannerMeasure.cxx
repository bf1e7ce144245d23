#include "Window/PlannerMeasure.h"

#include "Window/MeasureDrag.h"
#include "Window/MeasureIsovalue.h"
#include "Window/MeasureScenes.h"
#include "Window/MeasureWindow.h"
#include "Window/PlannerWindow.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace hasp
{
namespace
{
using Json = nlohmann::ordered_json;
constexpr int Pairs = 9, MemorySamples = 20, WarmUps = 50;

Json MeasureFirst(PlannerWindow& window)
{
  window.TrySample(Sample::Skull);
  WaitSettled(window);
  FinishDrawing(window.Parts().views.Scene());
  return { { "ms", 1e3 * SinceStartS() },
    { "sample", SampleFile().empty() ? "a phantom" : "a real CT" } };
}

unsigned long long FramesOfAll(const PlannerWindow& window)
{
  unsigned long long frames = 0;
  for (const FrameView* view : window.findChildren<FrameView*>())
    frames += view->Frames();
  return frames;
}

Json MeasureIdle(PlannerWindow& window, double seconds)
{
  WaitSettled(window);
  const unsigned long long before = FramesOfAll(window);
  Spend(seconds);
  return { { "seconds", seconds }, { "frames", FramesOfAll(window) - before } };
}

/// Opens a saved plan and a new one in turn.
Json MeasureReopening(PlannerWindow& window, int times)
{
  ShowSmallCase(window);
  Planner& parts = window.Parts();
  const std::filesystem::path place = parts.plan.Folder() / "measured.hasp";
  if (!parts.plan.SaveAs(place))
    throw std::runtime_error("the measured plan cannot be saved");
  const PlanId ball = parts.plan.Now().fragments.back().id;
  const auto again = [&]
  {
    parts.plan.BeginNew();
    WaitSettled(window);
    parts.plan.Open(place);
    WaitSettled(window);
    if (!parts.scene.ShownImage() || !parts.scene.PropOf(ball))
      throw std::runtime_error("the plan that is opened again is not shown");
  };
  for (int warm = 0; warm < WarmUps; ++warm) // what is kept for the next time is there then
    again();
  Json bytes = Json::array();
  for (int n = 0; n < times; ++n)
  {
    if (n % std::max(1, times / MemorySamples) == 0)
      bytes.push_back(ResidentBytes());
    again();
  }
  bytes.push_back(ResidentBytes());
  return { { "times", times }, { "bytes", bytes } };
}
} // namespace

Json MeasurePlanner(PlannerWindow& window, bool quick)
{
  Json measured;
  measured["first"] = MeasureFirst(window);
  measured["idle"] = MeasureIdle(window, quick ? 1.0 : 5.0);
  measured["reopened"] = MeasureReopening(window, quick ? 100 : 1000); // before heaps have holes
  measured["isovalue"] = Json::array({ MeasureIsovalue(window, 256, Pairs) });
  if (!quick)
    measured["isovalue"].push_back(MeasureIsovalue(window, 512, Pairs));
  measured["drag"] = MeasureDrag(window, quick ? 2.0 : 5.0);
  return measured;
}

} // namespace hasp
