#pragma once
#include "Grid/AnalyticVolumes.h"

#include <cstdint>
#include <vector>

namespace hasp
{

/// A head-like CT with closed-form truth: what stands in for a real scan where none is at hand.
///
/// Skin, skull and brain are ellipsoids around `center` (axes along L, P, S); the orbits are
/// spheres of soft tissue, the nose is an air cavity, and a skew rounded box through the right
/// frontal bone is the defect. The vault is closed above and cut off below by a plane, as scans
/// are.
struct PhantomSettings
{
  glm::dvec3 center{ 0.0 }; ///< world mm, patient LPS
  glm::dvec3 skinRadii{ 76.0, 96.0,
    92.0 };                   ///< mm, half width (L), half length (P), half height (S)
  double scalpMm = 6.0;       ///< skin to outer table, > 0
  double skullMm = 7.0;       ///< outer to inner table, > 0
  double skullBaseMm = -70.0; ///< no bone below center + this along S
  bool defect = true;         ///< the hole in the right frontal bone
  double edgeMm = 1.0;    ///< width of the soft step at each surface, as of a scanner's blur, > 0
  double noiseHU = 0.0;   ///< standard deviation of added noise, >= 0
  std::uint64_t seed = 1; ///< of the noise; the same seed gives the same samples
  double airHU = -1000.0; ///< outside and in the nose
  double softHU = 40.0;   ///< skin, brain, orbits, defect
  double boneHU = 1000.0; ///< the 226 HU surface lies within edgeMm of the bone's surface
};

/// Bone as an analytic field: mm, > 0 inside bone, 0 on its surface. It is a bound of the distance
/// (never larger in size), so FirstSurface may step by it. Throws std::invalid_argument on bad
/// settings, with the value and the legal range.
AnalyticVolume PhantomBone(const PhantomSettings& settings);

/// Where the defect is, so that a guide's landmarks can be put around it.
struct PhantomDefect
{
  glm::dvec3 center;  ///< on the outer table, world mm; right (x < center), anterior, superior
  glm::dvec3 outward; ///< unit normal of the outer table there
  glm::dvec3 along;   ///< unit, the long way of the hole in the tangent plane
  glm::dvec3 across;  ///< unit, the short way: outward x along
  double lengthMm;    ///< along, edge to edge
  double widthMm;     ///< across, edge to edge
};
PhantomDefect DefectOf(const PhantomSettings& settings);

/// A point on the outer table at most 1e-9 mm off: where the ray from `center` along `direction`
/// (any length > 0) leaves the skull as it would be without the defect.
glm::dvec3 PhantomOuterTable(const PhantomSettings& settings, const glm::dvec3& direction);

/// The phantom as CT samples on any grid, HU rounded to integers. O(samples), all threads, the same
/// samples with any number of them. Throws std::invalid_argument on bad settings or geometry.
std::vector<std::int16_t> SamplePhantom(
  const GridGeometry& geometry, const PhantomSettings& settings = {});

/// An upright grid of the given spacing (mm, > 0) that holds the whole head with 4 mm of air.
GridGeometry PhantomGrid(const glm::dvec3& spacing, const PhantomSettings& settings = {});

} // namespace hasp
