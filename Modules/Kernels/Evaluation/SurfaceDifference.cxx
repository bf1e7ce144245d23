#include "Evaluation/SurfaceDifference.h"

#include "Evaluation/AreaShares.h"
#include "Grid/FinitePose.h"
#include "Grid/ParallelFor.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

/// Parts of SampleMesh are at most as large as an equilateral triangle of this side, so that a
/// surface of this area has `least` of them.
double SpacingFor(double areaMm2, std::size_t least)
{
  return std::sqrt(areaMm2 / (0.25 * std::sqrt(3.0) * double(least)));
}

double AreaOf(const TriangleMesh& mesh)
{
  for (const glm::dvec3& point : mesh.points)
    if (!IsFinite(point))
      throw std::invalid_argument("mesh: a point is not finite; all must be");
  double area = 0.0;
  for (const glm::uvec3& t : mesh.triangles)
  {
    if (const std::uint32_t most = std::max({ t.x, t.y, t.z }); most >= mesh.points.size())
      throw std::invalid_argument("mesh: a triangle names point " + std::to_string(most) + " of " +
                                  std::to_string(mesh.points.size()));
    if (HeightOf(mesh, t) >= SliverMm)
      area += 0.5 * glm::length(glm::cross(
                      mesh.points[t.y] - mesh.points[t.x], mesh.points[t.z] - mesh.points[t.x]));
  }
  if (!(area > 0.0))
    throw std::invalid_argument(
      "mesh: it has no area to be measured; its triangles must be 0.001 mm high and more");
  return area;
}

std::vector<glm::dvec3> UsedPoints(const TriangleMesh& mesh)
{
  std::vector<bool> used(mesh.points.size());
  for (const glm::uvec3& t : mesh.triangles)
    used[t.x] = used[t.y] = used[t.z] = true;
  std::vector<glm::dvec3> points;
  for (std::size_t n = 0; n < used.size(); ++n)
    if (used[n])
      points.push_back(mesh.points[n]);
  return points;
}

struct Found
{
  double distanceMm = 0.0;
  glm::dvec3 to{ 0.0 };
};

/// Of the samples, then of the points, in b's place.
std::vector<Found> NearestOfAll(
  const MeasuredSurface& a, const MeasuredSurface& b, const RigidPose& aToB)
{
  const auto samples = std::int64_t(a.Samples().size());
  std::vector<Found> found(a.Samples().size() + a.Points().size());
  const auto place = [&](std::int64_t n)
  {
    return aToB.Place(
      n < samples ? a.Samples()[std::size_t(n)].point : a.Points()[std::size_t(n - samples)]);
  };
  ParallelFor(0, std::int64_t(found.size()), 512,
    [&](std::int64_t first, std::int64_t last)
    {
      double reach = std::numeric_limits<double>::infinity();
      glm::dvec3 before = place(first);
      for (std::int64_t n = first; n < last; ++n)
      {
        // No farther than from the one before, and the way from there; the slack is rounding's.
        const glm::dvec3 at = place(n);
        reach = 1e-6 + (1.0 + 1e-9) * (reach + glm::distance(at, before));
        auto near = b.Tree().Nearest(at, reach);
        if (!near)
          near = b.Tree().Nearest(at); // far from the origin rounding may be more
        found[std::size_t(n)] = { near->distanceMm, near->point };
        reach = near->distanceMm;
        before = at;
      }
    });
  return found;
}

/// Sums of one or of both surfaces.
class Summing
{
public:
  void Add(const MeasuredSurface& a, const std::vector<Found>& found, const RigidPose& aToWorld,
    const RigidPose& bToWorld)
  {
    const std::vector<MeshSample>& samples = a.Samples();
    double mean = 0.0, square = 0.0; // apart, so that two surfaces may be added either way round
    for (std::size_t n = 0; n < found.size(); ++n)
    {
      const double d = found[n].distanceMm;
      if (n < samples.size())
      {
        const double area = samples[n].areaMm2;
        this->Shares.Add(d, area);
        mean += area * d;
        square += area * d * d;
      }
      if (d < this->Most || (d == this->Most && this->Any))
        continue;
      this->Any = true;
      this->Most = d;
      this->Made.maxAt =
        aToWorld.Place(n < samples.size() ? samples[n].point : a.Points()[n - samples.size()]);
      this->Made.maxTo = bToWorld.Place(found[n].to);
    }
    this->Mean += mean;
    this->Square += square;
    this->Made.areaMm2 += a.AreaMm2();
    this->Made.samples += samples.size();
    this->Made.spacingMm = std::max(this->Made.spacingMm, a.SpacingMm());
  }
  DirectedDifference Result()
  {
    this->Shares.Sort();
    DirectedDifference made = this->Made;
    made.maxMm = this->Most;
    // Means of equal figures are not to differ from them by a rounding.
    made.meanMm = std::min(this->Mean / made.areaMm2, this->Most);
    made.rmsMm = std::clamp(std::sqrt(this->Square / made.areaMm2), made.meanMm, this->Most);
    made.p50Mm = this->Shares.Below(0.50);
    made.p95Mm = this->Shares.Below(0.95);
    made.p99Mm = this->Shares.Below(0.99);
    return made;
  }

private:
  AreaShares Shares;
  DirectedDifference Made;
  double Mean = 0.0, Square = 0.0, Most = 0.0;
  bool Any = false;
};

} // namespace

RigidPose CheckedPose(const RigidPose& pose, const char* name)
{
  const double length = glm::length(pose.orientation);
  if (!IsFinite(pose) || !(std::abs(length - 1.0) <= 1e-6))
    throw std::invalid_argument(std::string(name) + ": its orientation has length " +
                                std::to_string(length) +
                                ", must be 1 within 1e-6, and its position finite");
  return { pose.position, glm::normalize(pose.orientation) };
}

MeasuredSurface::MeasuredSurface(const TriangleMesh& mesh, std::size_t leastSamples)
  : Triangles(mesh)
{
  if (leastSamples < 100 || leastSamples > 200'000)
    throw std::invalid_argument("measured surface: leastSamples is " +
                                std::to_string(leastSamples) + ", must be in [100, 200000]");
  this->Area = AreaOf(mesh);
  this->Spacing = SpacingFor(this->Area, leastSamples);
  this->Places = SampleMesh(mesh, this->Spacing);
  this->Corners = UsedPoints(mesh);
  for (const MeshSample& sample : this->Places)
    this->Middle += sample.areaMm2 * sample.point;
  this->Middle /= this->Area;
}

SurfaceDifference MeasureSurfaceDifference(const MeasuredSurface& a, const RigidPose& aPose,
  const MeasuredSurface& b, const RigidPose& bPose)
{
  const RigidPose aToWorld = CheckedPose(aPose, "aToWorld"),
                  bToWorld = CheckedPose(bPose, "bToWorld");
  const auto ab = NearestOfAll(a, b, bToWorld.Inverse() * aToWorld);
  const auto ba = NearestOfAll(b, a, aToWorld.Inverse() * bToWorld);
  SurfaceDifference difference;
  Summing first, second, both;
  first.Add(a, ab, aToWorld, bToWorld);
  second.Add(b, ba, bToWorld, aToWorld);
  both.Add(a, ab, aToWorld, bToWorld);
  both.Add(b, ba, bToWorld, aToWorld);
  difference.aToB = first.Result();
  difference.bToA = second.Result();
  difference.both = both.Result();
  return difference;
}

DirectedDifference MeasureDistances(const MeasuredSurface& from, const RigidPose& fromPose,
  const MeasuredSurface& to, const RigidPose& toPose)
{
  const RigidPose fromToWorld = CheckedPose(fromPose, "fromToWorld"),
                  toToWorld = CheckedPose(toPose, "toToWorld");
  Summing sum;
  sum.Add(from, NearestOfAll(from, to, toToWorld.Inverse() * fromToWorld), fromToWorld, toToWorld);
  return sum.Result();
}

SurfaceDifference MeasureSurfaceDifference(const MeasuredSurface& a, const MeasuredSurface& b)
{
  return MeasureSurfaceDifference(a, {}, b, {});
}

} // namespace hasp
