#include "Studies/ReductionCases.h"

#include "Grid/ProgressPart.h"
#include "Grid/Stopwatch.h"
#include "Studies/FractureCases.h"
#include "Studies/SeededShare.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
constexpr double BoneHU = 226.0;
constexpr double StepHU = 400.0; // of a threshold's soft step: its isosurface is what counts

FractureCase CaseOf(const ReductionCaseSettings& s)
{
  const FractureCaseSettings settings{ .spacingMm = s.spacingMm, .seed = s.seed };
  return s.bone == BrokenBone::Head ? BrokenHead(settings) : BrokenMandible(settings);
}

/// What a threshold makes of the scan, in the form of shares.
BoneShares ThresholdShares(const FracturedScan& scan)
{
  BoneShares made;
  for (std::size_t n = 0; n < scan.samples.size(); ++n)
  {
    made.shares.push_back(
      std::clamp(0.5F + float((scan.samples[n] - BoneHU) / StepHU), 0.0F, 1.0F));
    made.labels.push_back(scan.truth[n]);
  }
  return made;
}

BoneShares SharesOf(const FracturedScan& scan, bool halfLevels)
{
  if (!halfLevels)
    return ThresholdShares(scan);
  return ShareBone(GridView<const std::int16_t>{ scan.samples.data(), scan.geometry },
    GridView<const std::uint16_t>{ scan.truth.data(), scan.geometry });
}
} // namespace

FitScene ReductionCase::SceneWithout(std::size_t body) const
{
  FitScene scene;
  for (std::size_t n = 0; n < this->bodies.size(); ++n)
    if (n != body)
    {
      const auto& own = this->partners[body];
      (std::find(own.begin(), own.end(), n) != own.end() ? scene.partners : scene.obstacles)
        .push_back({ this->bodies[n].body, this->trueBodyInWorld[n] });
    }
  return scene;
}

RigidPose ReductionCase::StartOf(
  std::size_t body, double mm, double degrees, std::uint64_t seed) const
{
  return UniformStart(this->trueBodyInWorld[body], this->bodies[body].body->Centroid(), mm, degrees,
    seed + 7919 * body);
}

RigidPose UniformStart(const RigidPose& trueBodyInWorld, const glm::dvec3& middle, double mm,
  double degrees, std::uint64_t seed)
{
  const auto direction = [&](std::uint64_t n)
  {
    const double z = 2.0 * SeededShare(seed, n) - 1.0;
    const double angle = 2.0 * glm::pi<double>() * SeededShare(seed, n + 1);
    const double side = std::sqrt(1.0 - z * z);
    return glm::dvec3(side * std::cos(angle), side * std::sin(angle), z);
  };
  const glm::dvec3 center = trueBodyInWorld.Place(middle);
  const glm::dvec3 shift = mm * std::cbrt(SeededShare(seed, 2)) * direction(0);
  const glm::dquat turn = TurnBy(glm::radians(degrees * SeededShare(seed, 5)) * direction(3));
  return { center + shift + turn * (trueBodyInWorld.position - center),
    glm::normalize(turn * trueBodyInWorld.orientation) };
}

ReductionCase MakeReductionCase(
  const ReductionCaseSettings& settings, const ProgressFunction& progress)
{
  const FractureCase broken = CaseOf(settings);
  const std::vector<std::int16_t> intact =
    IntactPhantom(broken.geometry, broken.settings, PartOf(progress, 0.0, 0.1));
  FractureCaseChoices damage = settings.damage;
  damage.seed = settings.seed;
  const MadeFractureCase scanned =
    MakeFractureCase(GridView<const std::int16_t>{ intact.data(), broken.geometry },
      broken.settings, {}, damage, PartOf(progress, 0.1, 0.4));
  const Stopwatch time;
  const BoneShares shares = SharesOf(scanned.fractured, settings.halfLevels);
  ReductionCase made;
  made.name = broken.name;
  const std::vector<std::string>& names = scanned.fractured.names;
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    const Label label = Label(n + 2);
    const double from = 0.4 + 0.6 * double(n) / double(names.size());
    made.names.push_back(names[n]);
    made.bodies.push_back(BakeFitBody(scanned.fractured.geometry, shares, label, settings.bake,
      PartOf(progress, from, from + 0.6 / double(names.size()))));
    made.trueBodyInWorld.push_back(
      TrueReduction(scanned.truth, label) * RigidPose{ made.bodies.back().origin });
    const auto& fixed = scanned.truth.fixed;
    made.fixed.push_back(std::find(fixed.begin(), fixed.end(), label) != fixed.end());
  }
  // Labels 2 and 3 are what is left of cranium and mandible.
  const std::size_t own = settings.bone == BrokenBone::Head ? 0 : 1;
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    made.partners.emplace_back();
    for (std::size_t k = 0; k < names.size(); ++k)
      if (k != n && (k == own || k >= 2))
        made.partners[n].push_back(k);
  }
  made.bakedMs = time.Milliseconds();
  return made;
}

} // namespace hasp
