#include "ReductionTrials.h"
#include "Report.h"
#include "ReportRegistry.h"
#include "ScratchFolder.h"

#include "Planning/PlanFile.h"
#include "Studies/SeededDice.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hasp
{
namespace
{

constexpr int Poses = 100;
constexpr double ReachMm = 200.0; ///< of a head

PlanPose AnyPose(SeededDice& dice)
{
  const glm::dvec3 shift = dice.Direction() * dice.In(0.0, 100.0);
  const RigidPose pose{ shift, TurnBy(dice.Direction() * dice.In(0.0, 3.1)) };
  return { pose.position, glm::normalize(pose.orientation) };
}

/// Plan, scan, segmentation and fragments that were posed one after the other.
PlanDocument PosedDocument(std::uint64_t seed)
{
  PlanDocument document;
  PlanHistory& history = document.history;
  history.Do(AddObject<PlanVolume>{ { history.NewId(), "", std::string(64, 'a') } });
  PlanSegmentation segmentation;
  segmentation.id = history.NewId();
  segmentation.volume = history.Current().volumes.back().id;
  history.Do(AddObject<PlanSegmentation>{ segmentation });
  SeededDice dice(seed);
  for (int n = 0; n < Poses; ++n)
  {
    PlanFragment fragment;
    fragment.id = history.NewId();
    fragment.source = LabelSource{ segmentation.id, std::uint32_t(1 + n) };
    history.Do(AddObject<PlanFragment>{ fragment });
    history.Do(PoseFragments{ { { fragment.id, AnyPose(dice) } } });
  }
  return document;
}

/// The most that a place of the head is moved by between both.
double MostMm(const PlanPose& a, const PlanPose& b)
{
  double most = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 place =
      ReachMm * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    most = std::max(most, glm::length(a.Place(place) - b.Place(place)));
  }
  return most;
}

} // namespace

void TryPosesInPlans(ReportContext& context)
{
  const PlanDocument written = PosedDocument(context.settings.seed);
  const ScratchFolder scratch;
  const auto folder = scratch.Path() / "plan.hasp";
  SavePlan(folder, written);
  const PlanDocument read = LoadPlan(folder);
  const auto &before = written.history.Current().fragments,
             &after = read.history.Current().fragments;
  double most = before.size() == after.size() ? 0.0 : HUGE_VAL;
  for (std::size_t n = 0; n < before.size() && n < after.size(); ++n)
    most = std::max(most, MostMm(before[n].scanToPlanned, after[n].scanToPlanned));
  context.report.stability.push_back({ "reduction.plan",
    std::to_string(Poses) + " poses written into a plan's folder and read again, 350 mm around",
    most <= 1e-6, std::isfinite(most) ? most : 1e9, 1e-6, "mm, largest" });
}

} // namespace hasp
