#include "Reduction/Assembly.h"

#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

void CheckUnits(std::span<const AssemblyUnit> units, const AssemblySettings& s)
{
  if (!(s.rounds >= 0 && s.rounds <= 100))
    throw std::invalid_argument(
      "assembly: rounds is " + std::to_string(s.rounds) + ", must be in [0, 100]");
  if (!(s.leastFacesMm2 >= 0.0))
    throw std::invalid_argument(
      "assembly: leastFacesMm2 is " + std::to_string(s.leastFacesMm2) + ", must be 0 or more");
  for (std::size_t n = 0; n < units.size(); ++n)
  {
    if (units[n].bodies.empty())
      throw std::invalid_argument("assembly: unit " + std::to_string(n) + " has no body");
    for (const std::size_t partner : units[n].partners)
      if (partner >= units.size() || partner == n)
        throw std::invalid_argument("assembly: partner " + std::to_string(partner) + " of unit " +
                                    std::to_string(n) + " must be another unit, below " +
                                    std::to_string(units.size()));
  }
}

double AreaOf(const AssemblyUnit& unit)
{
  double area = 0.0;
  for (const GroupBody& body : unit.bodies)
    area += body.body->SurfaceArea();
  return area;
}

/// What stands, and what comes next.
class Assembler
{
public:
  Assembler(std::span<const AssemblyUnit> units, const AssemblySettings& settings)
    : Units(units),
      Settings(settings),
      Done(units.size()),
      Coarse(units.size())
  {
    bool any = false;
    for (std::size_t n = 0; n < units.size(); ++n)
    {
      this->Done[n].groupInWorld = this->Done[n].fit.groupInWorld = units[n].groupInWorld;
      this->Done[n].placed = units[n].fixed;
      any = any || units[n].fixed;
    }
    if (!any && !units.empty())
    {
      const auto largest = std::max_element(units.begin(), units.end(),
        [](const AssemblyUnit& a, const AssemblyUnit& b) { return AreaOf(a) < AreaOf(b); });
      this->Done[std::size_t(largest - units.begin())].placed = true;
    }
  }

  /// Of those that stand, or of all but `unit`.
  FitScene SceneFor(std::size_t unit) const
  {
    FitScene scene;
    for (std::size_t n = 0; n < this->Units.size(); ++n)
      if (n != unit && this->Done[n].placed)
        this->AddTo(scene, n, unit);
    return scene;
  }

  /// The unit that goes most deeply with what stands; none if none goes at all.
  std::optional<std::size_t> Next()
  {
    std::vector<std::size_t> open;
    for (std::size_t n = 0; n < this->Units.size(); ++n)
      if (!this->Done[n].placed && !this->Refused(n) && !this->Coarse[n])
        open.push_back(n);
    ParallelFor(0, std::int64_t(open.size()), 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t n = begin; n < end; ++n)
          this->Coarse[open[n]] =
            FitCoarsely(this->Units[open[n]].bodies, this->Units[open[n]].groupInWorld,
              this->SceneFor(open[n]), this->Settings.proposals.fit);
      });
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < this->Units.size(); ++n)
      if (!this->Done[n].placed && !this->Refused(n) && this->Coarse[n] &&
          this->Coarse[n]->touches && this->Coarse[n]->sums.energy < least)
      {
        least = this->Coarse[n]->sums.energy;
        best = n;
      }
    return best;
  }

  void Place(std::size_t unit, int turn, std::uint64_t seed, const ProgressFunction& progress)
  {
    AssembledUnit& done = this->Done[unit];
    done.proposals = ProposeFits(this->Units[unit].bodies, this->Units[unit].groupInWorld,
      this->SceneFor(unit), this->Settings.proposals, seed + unit, progress);
    if (done.proposals.proposals.empty() ||
        done.proposals.proposals[0].fit.sums.facesMm2 < this->Settings.leastFacesMm2)
    {
      this->RefusedOnes.push_back(unit); // until something else stands
      return;
    }
    done.fit = done.proposals.proposals[0].fit;
    done.groupInWorld = done.fit.groupInWorld;
    done.placed = true;
    done.turn = turn;
    this->RefusedOnes.clear();
    for (std::size_t n = 0; n < this->Units.size(); ++n)
      if (this->MayMeet(unit, n))
        this->Coarse[n].reset();
  }

  /// All that were placed, each before all others; the last placed first.
  void Settle()
  {
    std::vector<std::size_t> order;
    for (std::size_t n = 0; n < this->Units.size(); ++n)
      if (this->Done[n].turn > 0)
        order.push_back(n);
    std::stable_sort(order.begin(), order.end(),
      [this](std::size_t a, std::size_t b) { return this->Done[a].turn > this->Done[b].turn; });
    for (const std::size_t n : order)
    {
      AssembledUnit& done = this->Done[n];
      done.fit =
        RefineFit(this->Units[n].bodies, done.fit, this->SceneFor(n), this->Settings.proposals.fit);
      done.groupInWorld = done.fit.groupInWorld;
    }
  }

  /// Spreads of all that were placed, together: a piece has part in the errors of what it stands
  /// on.
  std::vector<AssembledUnit> Finish()
  {
    std::vector<SpreadUnit> moved;
    std::vector<std::size_t> units;
    for (std::size_t n = 0; n < this->Units.size(); ++n)
      if (this->Done[n].turn > 0)
      {
        moved.push_back({ this->Units[n].bodies, this->Done[n].groupInWorld });
        units.push_back(n);
      }
    const ProposalSettings& s = this->Settings.proposals;
    const std::vector<FitSpread> spreads =
      MeasureSpreads(moved, this->Pairs(units), s.fit, s.gapMm, s.spreadFactor);
    for (std::size_t n = 0; n < units.size(); ++n)
    {
      AssembledUnit& done = this->Done[units[n]];
      // What other proposals add to the likeliest one's own spread.
      const double others =
        done.proposals.within95Mm - done.proposals.proposals[0].fit.spread.within95Mm;
      done.fit.spread = spreads[n];
      done.within95Mm = done.fit.spread.within95Mm + std::max(0.0, others);
    }
    return std::move(this->Done);
  }

private:
  bool Attracts(std::size_t other, std::size_t unit) const
  {
    const std::vector<std::size_t>& partners = this->Units[unit].partners;
    return partners.empty() || std::find(partners.begin(), partners.end(), other) != partners.end();
  }

  void AddTo(FitScene& scene, std::size_t added, std::size_t unit) const
  {
    const bool attracts = this->Attracts(added, unit);
    for (const GroupBody& body : this->Units[added].bodies)
      (attracts ? scene.partners : scene.obstacles)
        .push_back({ body.body, this->Done[added].groupInWorld * body.bodyInGroup });
  }

  /// Of `moved` units with each other and with what stands.
  std::vector<SpreadPair> Pairs(const std::vector<std::size_t>& moved) const
  {
    std::vector<SpreadPair> pairs;
    for (std::size_t n = 0; n < moved.size(); ++n)
      for (std::size_t other = 0; other < this->Units.size(); ++other)
      {
        const auto at = std::find(moved.begin(), moved.end(), other);
        if (!this->Done[other].placed || at <= moved.begin() + std::ptrdiff_t(n))
          continue; // each pair once
        SpreadPair pair{ n, {}, {} };
        if (at != moved.end())
          pair.other = std::size_t(at - moved.begin());
        this->AddTo(pair.scene, other, moved[n]);
        pairs.push_back(std::move(pair));
      }
    return pairs;
  }

  bool Refused(std::size_t unit) const
  {
    return std::find(this->RefusedOnes.begin(), this->RefusedOnes.end(), unit) !=
           this->RefusedOnes.end();
  }

  bool MayMeet(std::size_t stands, std::size_t other) const
  {
    for (const GroupBody& a : this->Units[stands].bodies)
      for (const GroupBody& b : this->Units[other].bodies)
      {
        const glm::dvec3 between = this->Done[stands].groupInWorld.Place(a.bodyInGroup.position) -
                                   this->Done[other].groupInWorld.Place(b.bodyInGroup.position);
        const double reach = this->Settings.proposals.fit.law.reachMm;
        if (glm::length(between) <= a.body->RadiusMm() + b.body->RadiusMm() + reach +
                                      this->Settings.proposals.fit.captureMm)
          return true;
      }
    return false;
  }

  std::span<const AssemblyUnit> Units;
  const AssemblySettings& Settings;
  std::vector<AssembledUnit> Done;
  std::vector<std::optional<FractureFit>> Coarse; ///< before what stands; none: not asked yet
  std::vector<std::size_t> RefusedOnes;
};
} // namespace

std::vector<AssembledUnit> Assemble(std::span<const AssemblyUnit> units,
  const AssemblySettings& settings, std::uint64_t seed, const ProgressFunction& progress)
{
  CheckUnits(units, settings);
  CheckFitSettings(settings.proposals.fit);
  Assembler assembler(units, settings);
  const double steps = double(units.size() + settings.rounds + 1);
  int turn = 0;
  double done = 0.0;
  while (const std::optional<std::size_t> next = assembler.Next())
  {
    // A refused one may be asked again: progress never goes back, and never over the end.
    const double from = std::min(done, double(units.size()) - 1.0);
    assembler.Place(
      *next, ++turn, seed, PartOf(progress, from / steps, std::min(1.0, (from + 1.0) / steps)));
    done += 1.0;
  }
  for (int round = 0; round < settings.rounds; ++round)
  {
    ReportProgress(progress, double(units.size() + round) / steps);
    assembler.Settle();
  }
  std::vector<AssembledUnit> assembled = assembler.Finish();
  ReportProgress(progress, 1.0);
  return assembled;
}

} // namespace hasp
