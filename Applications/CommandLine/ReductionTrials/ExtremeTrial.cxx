#include "ReductionTrials.h"
#include "Report.h"
#include "ReportRegistry.h"

#include "Grid/FinitePose.h"
#include "Reduction/Assembly.h"
#include "Studies/FracturedBlocks.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hasp
{
namespace
{

constexpr double HalfAsDeep = 0.5; // energy, of the right piece's: no longer the same fit
constexpr double PlacedMm = 0.5;

/// It passes if the figure is no larger than the limit; what is no number does not.
void AddCase(ReportContext& context, const std::string& id, const std::string& text, double figure,
  double limit, const std::string& unit)
{
  context.report.stability.push_back(
    { "reduction." + id, text, figure <= limit, figure, limit, unit });
}

RigidPose Off(
  const RigidPose& from, const glm::dvec3& shift, const glm::dvec3& axis, double degrees)
{
  return { from.position + shift,
    TurnBy(glm::normalize(axis) * glm::radians(degrees)) * from.orientation };
}

FracturedBlocks Blocks(const ReportContext& context, FracturedBlockSettings settings)
{
  settings.points = 4096;
  settings.seed = 300 + context.settings.seed;
  return MakeFracturedBlocks(settings);
}

double StandardMm(const FitSpread& spread, std::size_t axis)
{
  return std::sqrt(spread.covariance[UpperIndex(axis, axis)]);
}

/// Predicted: it stays where it was put, and nobody says that it must be there.
void TrySmoothFaces(ReportContext& context, const FracturedBlocks& rough)
{
  const FracturedBlocks smooth = Blocks(context, { .roughMm = 0.0, .widerMm = 12.0 });
  const RigidPose& truth = smooth.Moved().whole.bodyInWorld;
  const auto moved = smooth.MovedGroup();
  const FitScene scene = smooth.SceneOfOthers();
  FractureFit fit = FitFracture(moved, Off(truth, { 4, -3, 1 }, { 0, 0, 1 }, 10.0), scene);
  MeasureSpread(moved, scene, {}, fit);
  AddCase(context, "smooth.along",
    "a smooth face on a wider one: stated loose along it, held across",
    StandardMm(fit.spread, 2) / std::min(StandardMm(fit.spread, 0), StandardMm(fit.spread, 1)), 0.1,
    "standard deviation across / along");
  AddCase(context, "smooth.interval",
    "the same, slid by 5 mm and 10 degrees: within what is stated at 95 %",
    RmsWay(moved, truth, fit.groupInWorld) / fit.spread.within95Mm, 1.0, "way / interval");
  const auto held = rough.MovedGroup();
  FractureFit right = FitFracture(held, rough.Moved().whole.bodyInWorld, rough.SceneOfOthers());
  MeasureSpread(held, rough.SceneOfOthers(), {}, right);
  AddCase(context, "rough.interval", "a rough face: held in all directions",
    right.spread.within95Mm, 1.0, "mm, interval at 95 %");
  // A corner on the same smooth face, 40 degrees aslant; nothing attracts.
  const FitScene touched{ {}, scene.partners };
  FractureFit corner = FitFracture(moved, Off(truth, { 0, 0, 13.5 }, { 1, 1, 0 }, 40.0), touched);
  MeasureSpread(moved, touched, {}, corner);
  AddCase(context, "point", "one point of contact holds nothing: stated 4 mm and more",
    4.0 / corner.spread.within95Mm, 1.0, "4 mm / interval at 95 %");
}

/// Predicted: what does not belong is no fit.
void TryWrongPieces(ReportContext& context, const FracturedBlocks& rough)
{
  const auto energyOf =
    [](const PlacedBody& moved, const RigidPose& start, const FitScene& scene, std::uint64_t seed)
  {
    const FitProposals found =
      ProposeFits(std::array{ GroupBody{ moved.body, {} } }, start, scene, {}, seed);
    return found.proposals.empty() ? 0.0 : found.proposals[0].fit.sums.energy;
  };
  const std::uint64_t seed = context.settings.seed;
  const PlacedBody& whole = rough.Moved().whole;
  const FracturedBlocks mirrored = Blocks(context, { .roughMm = 1.0, .mirrored = true });
  AddCase(context, "mirrored", "a mirrored piece fits less than half as well as the right one",
    energyOf(
      mirrored.Moved().whole, mirrored.Moved().whole.bodyInWorld, mirrored.SceneOfOthers(), seed) /
      energyOf(whole, whole.bodyInWorld, rough.SceneOfOthers(), seed),
    HalfAsDeep, "energy / the right piece's");
  const FracturedBlocks three = Blocks(context, { .pieces = 3, .roughMm = 1.0 });
  const PlacedBody &lower = three.pieces[0].whole, &left = three.pieces[1].whole,
                   &right = three.pieces[2].whole;
  const FitScene on{ { lower }, {} };
  const double belong =
    energyOf(left, left.bodyInWorld, on, seed) + energyOf(right, right.bodyInWorld, on, seed);
  const double swapped =
    energyOf(left, right.bodyInWorld, on, seed) + energyOf(right, left.bodyInWorld, on, seed);
  AddCase(context, "swapped", "two pieces in each other's place fit less than half as well",
    swapped / belong, HalfAsDeep, "energy / in their own places");
}

/// 0 if a piece that starts there comes to its place, or it is said that it did not: it is not
/// placed, or left deep in another.
double Misled(const FracturedBlocks& blocks, const RigidPose& start, std::uint64_t seed)
{
  const std::vector<AssemblyUnit> units{ { { { blocks.pieces[0].whole.body, {} } },
                                           blocks.pieces[0].whole.bodyInWorld, true, {} },
    { blocks.MovedGroup(), start, false, {} } };
  const AssembledUnit made = Assemble(units, {}, seed)[1];
  if (!IsFinite(made.groupInWorld) || !std::isfinite(made.within95Mm))
    return 1.0;
  const double off =
    RmsWay(blocks.MovedGroup(), blocks.Moved().whole.bodyInWorld, made.groupInWorld);
  const bool said = !made.placed || made.fit.sums.deepestMm < -1.0;
  return off <= PlacedMm || said ? 0.0 : 1.0;
}

void TryBadStarts(ReportContext& context, const FracturedBlocks& rough)
{
  const std::uint64_t seed = context.settings.seed;
  const FracturedBlocks wider = Blocks(context, { .roughMm = 1.0, .widerMm = 12.0 });
  AddCase(context, "inside", "a piece that starts wholly inside of another: comes out or is told",
    Misled(wider, Off(wider.Moved().whole.bodyInWorld, { 0, 0, -18 }, { 1, 0, 0 }, 0.0), seed), 0.0,
    "placed wrongly and not told");
  const RigidPose& truth = rough.Moved().whole.bodyInWorld;
  const auto moved = rough.MovedGroup();
  const FitScene scene = rough.SceneOfOthers();
  const double right = FitFracture(moved, truth, scene).sums.energy;
  double worst = -HUGE_VAL;
  for (const glm::dvec3 shift :
    { glm::dvec3(40, 0, 0), glm::dvec3(0, 40, 0), glm::dvec3(25, 20, -24) })
    for (const glm::dvec3 axis : { glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 1) })
    {
      const FractureFit fit = FitFracture(moved, Off(truth, shift, axis, 90.0), scene);
      const double share = IsFinite(fit.groupInWorld) && std::isfinite(fit.sums.energy)
                             ? fit.sums.energy / right
                             : HUGE_VAL;
      worst = std::max(worst, share);
    }
  AddCase(context, "far", "40 mm and 90 degrees off, nine ways: finite, and not half as deep",
    std::isfinite(worst) ? worst : 1e9, HalfAsDeep, "energy / the right fit's, largest");
}

} // namespace

void TryReductionExtremes(ReportContext& context)
{
  context.progress(0.0, "stability: fits");
  const FracturedBlocks rough = Blocks(context, { .roughMm = 1.0 });
  TrySmoothFaces(context, rough);
  context.progress(0.4, "");
  TryWrongPieces(context, rough);
  context.progress(0.7, "");
  TryBadStarts(context, rough);
  context.progress(0.9, "");
  TryPosesInPlans(context);
}

} // namespace hasp
