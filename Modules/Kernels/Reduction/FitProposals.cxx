#include "Reduction/FitProposals.h"

#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <atomic>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>

namespace hasp
{

namespace
{
constexpr double PatchMm2 = 25.0; // faces err together over patches of 5 mm
constexpr int MostFine = 6;

void Check(const char* name, double value, double low, double high)
{
  if (!(value >= low && value <= high))
    throw std::invalid_argument("fit proposals: " + std::string(name) + " is " +
                                std::to_string(value) + ", must be in [" + std::to_string(low) +
                                ", " + std::to_string(high) + "]");
}

void CheckSettings(const ProposalSettings& s)
{
  CheckFitSettings(s.fit);
  Check("starts", s.starts, 1, 1e5);
  Check("startMm", s.startMm, 0.0, 100.0);
  Check("startDegrees", s.startDegrees, 0.0, 180.0);
  Check("most", s.most, 1, 20);
  Check("apartMm", s.apartMm, 1e-6, 100.0);
  Check("gapMm", s.gapMm, 0.0, 10.0);
  Check("spreadFactor", s.spreadFactor, 1e-3, 1e3);
}

/// Numbers of an engine that is the same on every machine, in [0,1).
class Shares
{
public:
  explicit Shares(std::uint64_t seed) : Engine(seed) {}
  double Next() { return double(this->Engine() >> 11) * 0x1p-53; }
  glm::dvec3 Direction()
  {
    const double z = 2.0 * this->Next() - 1.0, angle = 2.0 * M_PI * this->Next();
    const double side = std::sqrt(1.0 - z * z);
    return { side * std::cos(angle), side * std::sin(angle), z };
  }
  /// In a ball, evenly in volume.
  glm::dvec3 InBall(double radius)
  {
    const glm::dvec3 direction = this->Direction();
    return radius * std::cbrt(this->Next()) * direction;
  }

private:
  std::mt19937_64 Engine;
};

/// Middle of all surfaces, in the group's axes: what starts are turned about.
glm::dvec3 MiddleOf(std::span<const GroupBody> moved)
{
  glm::dvec3 middle(0.0);
  double area = 0.0;
  for (const GroupBody& body : moved)
  {
    middle += body.body->SurfaceArea() * body.bodyInGroup.Place(body.body->Centroid());
    area += body.body->SurfaceArea();
  }
  return middle / area;
}

std::vector<RigidPose> StartsAround(std::span<const GroupBody> moved, const RigidPose& coarse,
  const ProposalSettings& settings, std::uint64_t seed)
{
  std::vector<RigidPose> starts{ coarse };
  Shares shares(seed);
  const glm::dvec3 middle = coarse.Place(MiddleOf(moved));
  while (starts.size() < std::size_t(settings.starts))
  {
    const glm::dvec3 shift = shares.InBall(settings.startMm);
    const glm::dquat turn = TurnBy(shares.InBall(glm::radians(settings.startDegrees)));
    starts.push_back({ middle + shift + turn * (coarse.position - middle),
      glm::normalize(turn * coarse.orientation) });
  }
  return starts;
}

/// Calls fit(n) for each n on all cores; stops between two when progress says so.
void ForAll(
  std::size_t count, const ProgressFunction& progress, const std::function<void(std::size_t)>& fit)
{
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> done{ 0 };
  std::atomic<bool> stopped{ false };
  ParallelFor(0, std::int64_t(count), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end && !stopped; ++n)
      {
        fit(std::size_t(n));
        ++done;
        if (progress && std::this_thread::get_id() == caller &&
            !progress(double(done) / double(count)))
          stopped = true;
      }
    });
  if (stopped)
    throw Cancelled();
  ReportProgress(progress, 1.0);
}

/// Those that are apart, the least energy first.
std::vector<FitProposal> Distinct(
  std::span<const GroupBody> moved, std::vector<FitProposal> fits, double apartMm)
{
  std::stable_sort(fits.begin(), fits.end(),
    [](const FitProposal& a, const FitProposal& b)
    { return a.fit.sums.energy < b.fit.sums.energy; });
  std::vector<FitProposal> distinct;
  for (const FitProposal& one : fits)
  {
    const auto same = std::find_if(distinct.begin(), distinct.end(),
      [&](const FitProposal& other)
      { return RmsWay(moved, one.fit.groupInWorld, other.fit.groupInWorld) < apartMm; });
    if (same != distinct.end())
      same->found += one.found;
    else if (one.fit.touches)
      distinct.push_back(one);
  }
  return distinct;
}

/// How far the surface moves, rms, if the group is shifted and turned by all that it may be off.
double FarthestStart(std::span<const GroupBody> moved, const ProposalSettings& settings)
{
  const glm::dvec3 middle = MiddleOf(moved);
  double turned = 0.0, area = 0.0;
  for (const GroupBody& body : moved)
  {
    const glm::dvec3 arm = body.bodyInGroup.Place(body.body->Centroid()) - middle;
    const glm::dmat3& spread = body.body->Spread();
    const double squares = glm::dot(arm, arm) + spread[0][0] + spread[1][1] + spread[2][2];
    turned += body.body->SurfaceArea() * squares;
    area += body.body->SurfaceArea();
  }
  return settings.startMm + glm::radians(settings.startDegrees) * std::sqrt(turned / area);
}

/// Shares by energies and by ways from the coarse pose; the likeliest first.
void ShareOut(std::vector<FitProposal>& proposals, double farthestMm)
{
  const FitSums& best = proposals.front().fit.sums; // of the least energy
  const double patches = std::max(1.0, best.facesMm2 / PatchMm2);
  const double noise = std::max(1e-12, std::abs(best.energy) / std::sqrt(patches));
  double sum = 0.0;
  for (FitProposal& p : proposals)
  {
    const double way = p.startMm / std::max(farthestMm, 1e-3);
    p.share = std::exp(-(p.fit.sums.energy - best.energy) / noise - 0.5 * way * way);
    sum += p.share;
  }
  for (FitProposal& p : proposals)
    p.share = sum > 0.0 ? p.share / sum : 1.0 / double(proposals.size());
  std::stable_sort(proposals.begin(), proposals.end(),
    [](const FitProposal& a, const FitProposal& b) { return a.share > b.share; });
}

/// The least radius around the first within which 95 % of all lies: each proposal lies within its
/// own spread of where it is.
double MixedSpread(std::span<const GroupBody> moved, const std::vector<FitProposal>& proposals)
{
  double within = proposals.front().fit.spread.within95Mm, share = 0.0;
  std::vector<std::pair<double, double>> reaches; // mm from the first, share
  for (const FitProposal& p : proposals)
    reaches.push_back({ RmsWay(moved, proposals.front().fit.groupInWorld, p.fit.groupInWorld) +
                          p.fit.spread.within95Mm,
      p.share });
  std::sort(reaches.begin(), reaches.end());
  for (const auto& [mm, one] : reaches)
  {
    within = std::max(within, mm);
    share += one;
    if (share >= 0.95)
      break;
  }
  return within;
}
} // namespace

FitProposals ProposeFits(std::span<const GroupBody> moved, const RigidPose& coarse,
  const FitScene& scene, const ProposalSettings& settings, std::uint64_t seed,
  const ProgressFunction& progress)
{
  CheckSettings(settings);
  FitCoarsely(moved, coarse, {}, settings.fit); // throws what all of them would
  const std::vector<RigidPose> starts = StartsAround(moved, coarse, settings, seed);
  std::vector<FitProposal> fits(starts.size());
  ForAll(starts.size(), PartOf(progress, 0.0, 0.5),
    [&](std::size_t n)
    {
      // Every other one looks less far: small fragments are else drawn to what is no face of
      // theirs.
      FitSettings fit = settings.fit;
      if (n % 2 == 1)
        fit.captureMm = std::max(0.5, 0.5 * fit.captureMm);
      fits[n].fit = FitCoarsely(moved, starts[n], scene, fit);
      fits[n].found = 1;
    });
  std::vector<FitProposal> best = Distinct(moved, std::move(fits), settings.apartMm);
  best.resize(std::min(best.size(), std::size_t(std::max(settings.most, MostFine))));
  ForAll(best.size(), PartOf(progress, 0.5, 1.0),
    [&](std::size_t n)
    {
      best[n].fit = RefineFit(moved, best[n].fit, scene, settings.fit);
      MeasureSpread(moved, scene, settings.fit, best[n].fit, settings.gapMm, settings.spreadFactor);
    });
  FitProposals made{ Distinct(moved, std::move(best), settings.apartMm) };
  if (made.proposals.empty())
    return made;
  for (FitProposal& p : made.proposals)
    p.startMm = RmsWay(moved, coarse, p.fit.groupInWorld);
  ShareOut(made.proposals, FarthestStart(moved, settings));
  made.proposals.resize(std::min(made.proposals.size(), std::size_t(settings.most)));
  made.within95Mm = MixedSpread(moved, made.proposals);
  made.undecided =
    made.proposals.size() > 1 && made.proposals[0].share < 2.0 * made.proposals[1].share;
  return made;
}

} // namespace hasp
