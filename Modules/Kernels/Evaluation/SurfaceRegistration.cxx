#include "Evaluation/SurfaceRegistration.h"

#include "Evaluation/AreaShares.h"
#include "Evaluation/LeastSquares.h"
#include "Evaluation/SymmetricEigen.h"
#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace hasp
{

namespace
{

constexpr double LeastCosine =
  0.3; // between normals that agree: the far side of a thin bone is not met
constexpr double TruncateMm = 10.0; // of what starts are told apart by
constexpr std::size_t CoarseSamples = 250, MiddleSamples = 1500;
constexpr std::size_t Refined = 3;

void Validate(const SurfaceRegistrationSettings& s)
{
  const auto refuse = [](const char* name, double value, const char* range)
  {
    throw std::invalid_argument(std::string("surface registration: ") + name + " is " +
                                std::to_string(value) + ", must be in " + range);
  };
  if (!(s.matchMm > 0.0 && s.matchMm <= 20.0))
    refuse("matchMm", s.matchMm, "(0, 20]");
  if (!(s.leastShare > 0.0 && s.leastShare <= 1.0))
    refuse("leastShare", s.leastShare, "(0, 1]");
  if (!(s.mostMedianMm > 0.0 && s.mostMedianMm <= 1e6))
    refuse("mostMedianMm", s.mostMedianMm, "(0, 1e6]");
  if (s.samples < 500 || s.samples > 100'000)
    refuse("samples", double(s.samples), "[500, 100000]");
}

/// Samples as far apart in their order as leaves so many.
std::vector<MeshSample> Thinned(const std::vector<MeshSample>& samples, std::size_t most)
{
  std::vector<MeshSample> thinned;
  const double step = std::max(1.0, double(samples.size()) / double(most));
  for (double n = 0.0; n < double(samples.size()); n += step)
    thinned.push_back(samples[std::size_t(n)]);
  return thinned;
}

/// Principal axes of a surface, as a turn from them to its place; right-handed.
glm::dmat3 PrincipalAxes(const MeasuredSurface& surface)
{
  std::array<std::array<double, 3>, 3> spread{};
  for (const MeshSample& sample : surface.Samples())
  {
    const glm::dvec3 off = sample.point - surface.Centroid();
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        spread[std::size_t(r)][std::size_t(c)] += sample.areaMm2 * off[r] * off[c];
  }
  const auto eigen = FindSymmetricEigen<3>(spread);
  glm::dmat3 axes;
  for (int n = 0; n < 2; ++n)
    for (int r = 0; r < 3; ++r)
      axes[n][r] = eigen.vectors[std::size_t(n)][std::size_t(r)];
  axes[2] = glm::cross(axes[0], axes[1]);
  return axes;
}

/// The 24 turns of a cube; the first is none.
std::vector<glm::dmat3> CubeTurns()
{
  std::vector<glm::dmat3> turns;
  const glm::dmat3 none(1.0);
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int signs = 0; x != y && signs < 4; ++signs)
      {
        const glm::dvec3 first = (signs & 1 ? -1.0 : 1.0) * none[x],
                         second = (signs & 2 ? -1.0 : 1.0) * none[y];
        turns.emplace_back(first, second, glm::cross(first, second));
      }
  return turns;
}

/// Poses scanToOther to begin with.
std::vector<RigidPose> Starts(const MeasuredSurface& part, const MeasuredSurface& whole)
{
  std::vector<RigidPose> starts{ RigidPose{} };
  const auto turned = [&](const glm::dmat3& turn) {
    starts.push_back({ whole.Centroid() - turn * part.Centroid(), glm::quat_cast(turn) });
  };
  for (const glm::dmat3& turn : CubeTurns())
    turned(turn);
  const glm::dmat3 from = glm::transpose(PrincipalAxes(part)), to = PrincipalAxes(whole);
  for (int signs = 0; signs < 4; ++signs)
  {
    const double a = signs & 1 ? -1.0 : 1.0, b = signs & 2 ? -1.0 : 1.0;
    turned(to * glm::dmat3(a, 0, 0, 0, b, 0, 0, 0, a * b) * from);
  }
  return starts;
}

/// A set of places of the part, laid on the other surface.
class Laying
{
public:
  Laying(std::vector<MeshSample> samples, const TriangleTree& onto)
    : Samples(std::move(samples)),
      Onto(onto)
  {
    for (const MeshSample& sample : this->Samples)
      this->Middle += sample.point / double(this->Samples.size());
    for (const MeshSample& sample : this->Samples)
      this->Radius = std::max(this->Radius, glm::distance(sample.point, this->Middle));
  }

  /// Until it moves by less than stillMm.
  RigidPose Settle(RigidPose scanToOther, int most, double stillMm) const
  {
    for (int n = 0; n < most; ++n)
      if (this->Step(scanToOther) < stillMm)
        break;
    return scanToOther;
  }
  /// Mean of squares, each at most TruncateMm^2.
  double Cost(const RigidPose& scanToOther) const
  {
    double sum = 0.0, area = 0.0;
    for (const MeshSample& sample : this->Samples)
    {
      const double off = this->Off(sample, scanToOther, TruncateMm);
      sum += sample.areaMm2 * off * off;
      area += sample.areaMm2;
    }
    return sum / area;
  }
  SurfaceRegistration Measure(const RigidPose& scanToOther, double matchMm) const
  {
    SurfaceRegistration found;
    found.otherToScan = scanToOther.Inverse();
    AreaShares shares;
    double matched = 0.0, square = 0.0;
    for (const MeshSample& sample : this->Samples)
    {
      const double off = this->Off(sample, scanToOther, 1e6);
      shares.Add(off, sample.areaMm2);
      if (off > matchMm)
        continue;
      matched += sample.areaMm2;
      square += sample.areaMm2 * off * off;
    }
    shares.Sort();
    found.medianMm = shares.Below(0.5);
    found.share = std::min(matched / shares.Area(), 1.0);
    found.rmsMm = matched > 0.0 ? std::sqrt(square / matched) : 0.0;
    return found;
  }
  /// How far a place of the part goes at most, from one pose to another.
  double Way(const RigidPose& from, const RigidPose& to) const
  {
    const double turn =
      glm::length(RotationVector(glm::conjugate(from.orientation) * to.orientation));
    return glm::distance(from.Place(this->Middle), to.Place(this->Middle)) + turn * this->Radius;
  }

private:
  /// From the other surface where the normals agree; else, and beyond it, `most`.
  double Off(const MeshSample& sample, const RigidPose& pose, double most) const
  {
    const auto near = this->Onto.Nearest(pose.Place(sample.point), most);
    return near && glm::dot(near->normal, pose.Turn(sample.normal)) > LeastCosine ? near->distanceMm
                                                                                  : most;
  }
  struct Match
  {
    glm::dvec3 at, normal;
    double off, distanceMm, area;
  };
  std::vector<Match> Matches(const RigidPose& pose) const
  {
    std::vector<Match> matches;
    matches.reserve(this->Samples.size());
    for (const MeshSample& sample : this->Samples)
    {
      const glm::dvec3 at = pose.Place(sample.point);
      const auto near = this->Onto.Nearest(at);
      if (near && glm::dot(near->normal, pose.Turn(sample.normal)) > LeastCosine)
        matches.push_back({ at, near->normal, glm::dot(near->normal, near->point - at),
          near->distanceMm, sample.areaMm2 });
    }
    return matches;
  }
  /// One step of Gauss and Newton; how far places went, mm.
  double Step(RigidPose& pose) const
  {
    const std::vector<Match> matches = this->Matches(pose);
    if (matches.size() < 10)
      return 0.0;
    std::vector<double> offs;
    for (const Match& m : matches)
      offs.push_back(m.distanceMm);
    std::nth_element(offs.begin(), offs.begin() + std::ptrdiff_t(offs.size() / 2), offs.end());
    const double widest = 3.0 * std::max(1.4826 * offs[offs.size() / 2], 1e-9);
    const glm::dvec3 middle = pose.Place(this->Middle);
    NormalEquations<6> equations;
    double area = 0.0;
    for (const Match& m : matches)
    {
      const double share = m.distanceMm / widest;
      if (share >= 1.0)
        continue;
      const double w = std::sqrt(m.area) * (1.0 - share * share); // Tukey's weight, its root
      // Turns count as the way of a place at Radius, so that all unknowns are mm.
      const glm::dvec3 turn = glm::cross(m.at - middle, m.normal) / this->Radius;
      equations.Add(
        { w * m.normal.x, w * m.normal.y, w * m.normal.z, w * turn.x, w * turn.y, w * turn.z },
        w * m.off);
      area += m.area;
    }
    for (std::size_t n = 0; n < 6; ++n) // what nothing holds, as a ball's turn, stays
    {
      std::array<double, 6> one{};
      one[n] = 1e-4 * std::sqrt(area);
      equations.Add(one, 0.0);
    }
    const auto found = equations.Solve();
    if (!found)
      return 0.0;
    const auto& x = *found;
    const glm::dvec3 shift(x[0], x[1], x[2]), turn = glm::dvec3(x[3], x[4], x[5]) / this->Radius;
    const glm::dquat by = TurnBy(turn);
    pose.orientation = glm::normalize(by * pose.orientation);
    pose.position = middle + by * (pose.position - middle) + shift;
    return glm::length(shift) + glm::length(turn) * this->Radius;
  }

  std::vector<MeshSample> Samples;
  const TriangleTree& Onto;
  glm::dvec3 Middle{ 0.0 };
  double Radius = 1e-6;
};

struct Candidate
{
  RigidPose scanToOther;
  double cost = 0.0;
};

/// Those that end at different places, the best first, at most `most`.
std::vector<Candidate> Best(std::vector<Candidate> all, const Laying& laying, std::size_t most)
{
  std::stable_sort(
    all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  std::vector<Candidate> best;
  for (const Candidate& candidate : all)
    if (best.size() < most && std::none_of(best.begin(), best.end(),
                                [&](const Candidate& b)
                                { return laying.Way(b.scanToOther, candidate.scanToOther) < 3.0; }))
      best.push_back(candidate);
  return best;
}

std::vector<Candidate> SettleAll(
  std::vector<Candidate> candidates, const Laying& laying, int most, double stillMm)
{
  ParallelFor(0, std::int64_t(candidates.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto n = std::size_t(first); n < std::size_t(last); ++n)
      {
        candidates[n].scanToOther = laying.Settle(candidates[n].scanToOther, most, stillMm);
        candidates[n].cost = laying.Cost(candidates[n].scanToOther);
      }
    });
  return candidates;
}

bool IsElsewhere(const RigidPose& a, const RigidPose& b, const glm::dvec3& middle)
{
  const double turn = glm::length(RotationVector(glm::conjugate(a.orientation) * b.orientation));
  return turn > glm::pi<double>() / 36.0 || glm::distance(a.Place(middle), b.Place(middle)) > 5.0;
}

} // namespace

SurfaceRegistration RegisterSurfaces(const MeasuredSurface& part, const MeasuredSurface& whole,
  const SurfaceRegistrationSettings& settings, const ProgressFunction& progress)
{
  Validate(settings);
  ReportProgress(progress, 0.0);
  const Laying coarse(Thinned(part.Samples(), CoarseSamples), whole.Tree());
  std::vector<Candidate> candidates;
  for (const RigidPose& start : Starts(part, whole))
    candidates.push_back({ start });
  candidates = Best(SettleAll(candidates, coarse, 30, 0.1), coarse, Refined);
  ReportProgress(progress, 0.5);
  const Laying middle(Thinned(part.Samples(), MiddleSamples), whole.Tree());
  candidates = Best(SettleAll(candidates, middle, 50, 1e-4), middle, Refined);
  ReportProgress(progress, 0.8);
  const Laying fine(Thinned(part.Samples(), settings.samples), whole.Tree());
  const Candidate& best = candidates.front();
  SurfaceRegistration found =
    fine.Measure(fine.Settle(best.scanToOther, 20, 1e-6), settings.matchMm);
  found.fits = found.share >= settings.leastShare && found.medianMm <= settings.mostMedianMm;
  // A hundredth of a millimetre is nothing to tell places apart by.
  for (const Candidate& other : candidates)
    if (IsElsewhere(best.scanToOther, other.scanToOther, part.Centroid()) &&
        other.cost <= 1.1 * best.cost + 1e-4)
      found.ambiguous = true;
  ReportProgress(progress, 1.0);
  return found;
}

} // namespace hasp
