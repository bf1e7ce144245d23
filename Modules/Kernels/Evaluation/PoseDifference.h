#pragma once
#include "Evaluation/MeshSamples.h"
#include "Grid/RigidPose.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace hasp
{

/// A place of a fragment, in the fragment's own place (before any pose), and what it stands for.
struct WeightedPoint
{
  glm::dvec3 point{ 0.0 }; ///< mm
  double weight = 1.0;     ///< > 0: an area, or 1 for a landmark
};

/// Places of a mesh by their areas.
std::vector<WeightedPoint> WeightedPoints(std::span<const MeshSample> samples);

/// How far points went, mm, >= 0; shares are of weight.
struct Displacement
{
  double meanMm = 0.0, rmsMm = 0.0, p95Mm = 0.0, maxMm = 0.0;
  std::size_t points = 0;
};

/// How far two poses of one fragment are from each other.
struct PoseDifference
{
  double rotationDegrees = 0.0; ///< angle of R1^T R2, [0, 180]; exact near 0 (RotationVector)
  double translationMm = 0.0;   ///< of the points' weighted middle
  Displacement tre;             ///< target registration error: |first p - second p|
};

/// Symmetric in its poses. Throws std::invalid_argument on poses as CheckedPose does, without
/// points, on a point that is not finite, and a weight that is not finite and above 0. Any thread;
/// O(points log points), one core.
PoseDifference ComparePoses(
  const RigidPose& first, const RigidPose& second, std::span<const WeightedPoint> points);

/// One fragment of two plans.
struct PosedPoints
{
  RigidPose first, second;
  std::span<const WeightedPoint> points;
};

/// The rigid motion secondToFirst of all fragments at once that brings them nearest to where the
/// first plan has them: the least weighted sum of |first p - secondToFirst second p|^2. Never a
/// mirror image. What remains after it (ComparePoses of first and secondToFirst * second) is how
/// far the fragments differ from each other, wherever the whole stands.
///
/// Method: the unit quaternion is the eigenvector of Horn's 4x4 matrix (Horn 1987), the same motion
/// as Kabsch's (1976). Points on a line leave the turn about it free: one that fits is taken.
/// Throws as ComparePoses. Any thread; O(points), one core.
RigidPose BestAlignment(std::span<const PosedPoints> fragments);

/// The same of places that belong to each other, one by one, secondToFirst. Throws
/// std::invalid_argument if there are none, not as many of both, or one is not finite.
RigidPose BestAlignment(std::span<const glm::dvec3> first, std::span<const glm::dvec3> second);

} // namespace hasp
