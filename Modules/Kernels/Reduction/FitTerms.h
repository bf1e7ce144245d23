#pragma once
#include "Grid/RigidPose.h"
#include "Haptics/Solve6.h"
#include "Reduction/FitBody.h"

#include <span>
#include <vector>

namespace hasp
{

/// What a fit pulls with, at one of its stages. A point of area A that looks at another surface at
/// the signed distance d, NEGATIVE INSIDE, with the other's outward normal g and its own n:
///
///   faces       0 < d < R:  energy -s A f R^2 / 6 (1 - (d/R)^2)^3     R captureMm, s attraction
///               d < 0:      energy  A p^2 / 2 ln(1 + (d/p)^2) - s A f R^2 / 6    p penetrationMm
///                           f 0 to 1 as -n . g goes from 0.2 to 0.6 (smooth step): only faces
///                           that look at each other attract
///
///   surfaces    for two smooth points a distance r <= reachMm apart, with normals n and m:
///   that go on  energy -w A t q^2 / 2 / (1 + (e/q)^2)                 q continuityMm
///               e = (x - y) . (n + m) / |n + m|,  t = 1 - (r / reachMm)^2
///
/// Contact is three times as stiff as attraction, and gives way where it is deep: faces
/// that lost bone (gaps) and faces that were blurred (edges) both pull too little rather than too
/// much. Faces attract as Snap-to-fit does (ContactForce.h; thesis, Paper I), in a narrower range
/// at the end. e is 0 for two places of a plane and of a circle (symmetric point-to-plane distance,
/// Rusinkiewicz 2019), so an outer surface that is bent as it goes on is not pulled off. This
/// second term is ours: no paper has it. It holds what faces alone do not, steps and turns about
/// small faces.
struct FitLaw
{
  double captureMm = 1.0;     ///< (0, the maps' range]
  double attraction = 0.3;    ///< > 0, as a share of contact's stiffness
  double penetrationMm = 0.5; ///< > 0
  double continuity = 1.5;    ///< w; 0: surfaces need not go on
  double continuityMm = 0.3;  ///< > 0
  double reachMm = 10.0;      ///< > 0
};

/// Sums over points, about the moved body's origin, in world axes. `matrix` is Gauss and Newton's:
/// sum of weight j j^T, j = [g; r x g]; positive semidefinite.
struct FitSums
{
  Symmetric6 matrix{};
  Vector6 pull{};            ///< against the energy's gradient: N-like, sum of -weight d j
  double energy = 0.0;       ///< mm^4
  double facesMm2 = 0.0;     ///< that look at each other, weighted as they attract
  double faceSquares = 0.0;  ///< sum of the same weights times d^2
  double deepestMm = 0.0;    ///< the least d; 0 without contact
  double contactMm2 = 0.0;   ///< with d < 0
  double continuedMm2 = 0.0; ///< of smooth surface that goes on
  double continuedSquares = 0.0;

  FitSums& operator+=(const FitSums& other) noexcept;
};

/// One residual as least squares see it: weight, its derivative by the pose, and its value.
struct FitResidual
{
  Vector6 slope;
  double weight, mm;
  glm::dvec3 place; ///< world
  bool face;        ///< else of a surface that goes on
};

/// What stands before moved bodies.
struct FitScene
{
  std::vector<PlacedBody> partners;  ///< whose faces attract
  std::vector<PlacedBody> obstacles; ///< which are touched, and no more
};

/// Moved bodies, a group that moves as one, before the standing ones, in both directions: their
/// points before standing distances, and standing points before theirs. Of each moved body `points`
/// at most, of standing ones as dense a level.
///
/// origin     world; torques are about it
/// residuals  null, or where all of them are appended
/// Any thread; no state. About 60 ns a point and body, 2 us a smooth point near another body.
FitSums SumFit(std::span<const PlacedBody> moved, const glm::dvec3& origin, const FitScene& scene,
  const FitLaw& law, std::size_t points, std::vector<FitResidual>* residuals = nullptr);

} // namespace hasp
