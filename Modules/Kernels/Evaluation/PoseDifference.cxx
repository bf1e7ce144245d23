#include "Evaluation/PoseDifference.h"

#include "Evaluation/AreaShares.h"
#include "Evaluation/SurfaceDifference.h"
#include "Evaluation/SymmetricEigen.h"
#include "Grid/FinitePose.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{

void CheckPoints(std::span<const WeightedPoint> points)
{
  if (points.empty())
    throw std::invalid_argument("pose difference: there are no points; one at least is needed");
  for (const WeightedPoint& p : points)
    if (!IsFinite(p.point) || !(p.weight > 0.0) || !std::isfinite(p.weight))
      throw std::invalid_argument("pose difference: a point of weight " + std::to_string(p.weight) +
                                  "; points must be finite, weights finite and above 0");
}

/// Horn's matrix of sum w first second^T, both about their middles.
std::array<std::array<double, 4>, 4> HornMatrix(const glm::dmat3& s)
{
  // s[column][row] is the sum of second[row] * first[column], as Horn's S_row,column.
  const double xx = s[0][0], xy = s[1][0], xz = s[2][0], yx = s[0][1], yy = s[1][1], yz = s[2][1],
               zx = s[0][2], zy = s[1][2], zz = s[2][2];
  return { { { xx + yy + zz, yz - zy, zx - xz, xy - yx },
    { yz - zy, xx - yy - zz, xy + yx, zx + xz }, { zx - xz, xy + yx, yy - xx - zz, yz + zy },
    { xy - yx, zx + xz, yz + zy, zz - xx - yy } } };
}

} // namespace

std::vector<WeightedPoint> WeightedPoints(std::span<const MeshSample> samples)
{
  std::vector<WeightedPoint> points;
  points.reserve(samples.size());
  for (const MeshSample& sample : samples)
    points.push_back({ sample.point, sample.areaMm2 });
  return points;
}

PoseDifference ComparePoses(
  const RigidPose& first, const RigidPose& second, std::span<const WeightedPoint> points)
{
  CheckPoints(points);
  const RigidPose a = CheckedPose(first, "first"), b = CheckedPose(second, "second");
  PoseDifference difference;
  difference.rotationDegrees =
    glm::degrees(glm::length(RotationVector(glm::conjugate(a.orientation) * b.orientation)));
  AreaShares shares;
  glm::dvec3 middle(0.0);
  double weight = 0.0, mean = 0.0, square = 0.0;
  for (const WeightedPoint& p : points)
  {
    const double d = glm::distance(a.Place(p.point), b.Place(p.point));
    shares.Add(d, p.weight);
    middle += p.weight * p.point;
    weight += p.weight;
    mean += p.weight * d;
    square += p.weight * d * d;
  }
  shares.Sort();
  middle /= weight;
  difference.translationMm = glm::distance(a.Place(middle), b.Place(middle));
  Displacement& tre = difference.tre;
  tre.maxMm = shares.Most();
  tre.meanMm = std::min(mean / weight, tre.maxMm); // not more by a rounding
  tre.rmsMm = std::clamp(std::sqrt(square / weight), tre.meanMm, tre.maxMm);
  tre.p95Mm = shares.Below(0.95);
  tre.points = points.size();
  return difference;
}

namespace
{

struct Pair
{
  glm::dvec3 first, second;
  double weight;
};

RigidPose Align(const std::vector<Pair>& pairs)
{
  glm::dvec3 firstMiddle(0.0), secondMiddle(0.0);
  double weight = 0.0;
  for (const Pair& p : pairs)
  {
    firstMiddle += p.weight * p.first;
    secondMiddle += p.weight * p.second;
    weight += p.weight;
  }
  firstMiddle /= weight;
  secondMiddle /= weight;
  glm::dmat3 s(0.0);
  for (const Pair& p : pairs)
    s += glm::outerProduct(p.weight * (p.second - secondMiddle), p.first - firstMiddle);
  const auto q = FindSymmetricEigen<4>(HornMatrix(s)).vectors[0];
  RigidPose aligned;
  aligned.orientation = glm::normalize(glm::dquat(q[0], q[1], q[2], q[3]));
  aligned.position = firstMiddle - aligned.orientation * secondMiddle;
  return aligned;
}

} // namespace

RigidPose BestAlignment(std::span<const PosedPoints> fragments)
{
  if (fragments.empty())
    CheckPoints({});
  std::vector<Pair> pairs;
  for (const PosedPoints& f : fragments)
  {
    CheckPoints(f.points);
    const RigidPose first = CheckedPose(f.first, "first"), second = CheckedPose(f.second, "second");
    for (const WeightedPoint& p : f.points)
      pairs.push_back({ first.Place(p.point), second.Place(p.point), p.weight });
  }
  return Align(pairs);
}

RigidPose BestAlignment(std::span<const glm::dvec3> first, std::span<const glm::dvec3> second)
{
  if (first.empty() || first.size() != second.size())
    throw std::invalid_argument("best alignment: " + std::to_string(first.size()) + " places and " +
                                std::to_string(second.size()) +
                                "; as many of both are needed, one at least");
  std::vector<Pair> pairs;
  for (std::size_t n = 0; n < first.size(); ++n)
  {
    if (!IsFinite(first[n]) || !IsFinite(second[n]))
      throw std::invalid_argument("best alignment: a place is not finite; all must be");
    pairs.push_back({ first[n], second[n], 1.0 });
  }
  return Align(pairs);
}

} // namespace hasp
