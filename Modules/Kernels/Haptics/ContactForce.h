#pragma once
#include "Grid/RigidPose.h"
#include "Haptics/ContactPoints.h"
#include "Haptics/DistanceMap.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hasp
{

/// What is summed over points. Each is a kernel of its own: what is not asked for is not computed.
enum class ContactTerms
{
  Force,  ///< along the points' normals: force and torque (McNeely, Puterbaugh and Troy 1999)
  Matrix, ///< along the map's gradient, with the 6x6 stiffness that the coupling solves with
  Snap    ///< the same, and Snap-to-fit's attraction
};

/// Penalty contact with stiffness per area, and Snap-to-fit (thesis 2.3.3; Paper I, whose law is
/// not published: this is ours). For a point of area A at signed distance d with gradient g, |g|
/// about 1:
///
///   contact     d < 0:      force -k A d g               energy k A d^2 / 2 (without hardening)
///   attraction  0 < d < R:  force -s a A (d / R) (1 - (d/R)^2)^2 f g
///
/// with f = max(0, -n . g)^2, n the point's outward normal: only faces that look at each other
/// attract. 0 at contact and at R, largest, 0.286 s a A f, at d = R / sqrt 5.
///
/// Contact may harden with depth, so that a small area bears as much as a large one before it is
/// in by H: pressure and its slope, which goes into the matrix, are
///
///   -d < H:  k (1 + c u^4) (-d)  and  k (1 + 5 c u^4),  u = -d / H
///   deeper:  on with the slope at H
///
/// A function of the depth alone, convex, its slope continuous: it has a potential, and Newton's
/// steps towards balance overshoot once at most.
struct ContactSettings
{
  float stiffness = 0.05F; ///< k, N/mm per mm^2; >= 0
  float hardening = 0.0F;  ///< c; >= 0. Pressure at H is 1 + c times what it would be without
  float hardMm = 1.0F;     ///< H; > 0
  float attraction = 0.0F; ///< a, N per mm^2; >= 0
  float captureMm = 3.0F;  ///< R, in (0, the map's range]
  float fade = 1.0F;       ///< s, in [0, 1]: faded in and out by the step
};

/// A shell before a map. Torques are about the shell body's origin; all in the MAP body's axes.
struct ContactPlacement
{
  RigidPose shellInMap; ///< of the shell's body, in the map's body axes (mm)
};

/// Sums over points. Forces act on the SHELL's body. Doubles, summed from a float a lane and group.
struct ContactSums
{
  Wrench contact;
  Wrench attraction;
  /// Sum of k A j j^T (the slope for k if contact hardens), j = [g; r x g], upper triangle row by
  /// row: 21 numbers. Positive semidefinite. Attraction is not in it: its stiffness is negative
  /// near the rim.
  std::array<double, 21> matrix{};
  double contactArea = 0.0;   ///< mm^2
  double attractedArea = 0.0; ///< mm^2 with f > 0 within R
  double deepestMm = 0.0;     ///< the least distance felt: negative inside, 0 without contact
  double energy = 0.0;        ///< N mm: contact's
  std::uint32_t contacts = 0; ///< points

  ContactSums& operator+=(const ContactSums& other) noexcept;
};

/// Adds what `points` feel of `map` to `sums`. On the border of the grid nothing is felt, as beyond
/// it; nor is anything if the placement is not finite.
///
/// Against float distances int16, q = range / 32767 a step, is off by
///   force   at most k (q/2 sum A |g| + q |1/s| sum A |d|), s the spacings; without the last term
///           along the points' normals (Force). Torque: times the farthest point.
///   energy  at most k q/2 sum A |d|
/// and by terms in q^2; with hardening k is its slope. That is q / (2 d) + q |1/s| of the force at
/// a mean depth d: 1e-3 for a contact in one cell, a quarter voxel deep in a map of the default
/// range. Cells round independently, and the more a contact covers the less is left: 1e-4 from some
/// dozens on. Float adds the last digit of the index, 1e-5 of a voxel at 256 samples.
///
/// HAPTIC: takes no memory, no lock, and does not throw. Settings must be in their ranges. A call
/// costs 0.1 us (Matrix 0.2 us) besides its points: give it all runs of a level at once.
using ContactFunction = void (*)(ContactRuns points, const ContactPlacement& placement,
  const DistanceMapView<std::int16_t>& map, const ContactSettings& settings,
  ContactSums& sums) noexcept;

/// One instruction set's kernels.
struct ContactKernels
{
  const char* name = ""; ///< "scalar", "SSE4", "AVX2", "AVX3", ...
  std::array<ContactFunction, 3> byTerms{};
  ContactFunction operator[](ContactTerms terms) const noexcept
  {
    return this->byTerms[static_cast<std::size_t>(terms)];
  }
};

/// One point after the other: what the others are held against. A second one of float distances.
ContactKernels ScalarContactKernels() noexcept;
void ContactForceReference(ContactTerms terms, ContactRuns points,
  const ContactPlacement& placement, const DistanceMapView<float>& map,
  const ContactSettings& settings, ContactSums& sums) noexcept;

/// All that this processor runs, the scalar one first. Without HASP_ENABLE_HIGHWAY that one alone.
std::vector<ContactKernels> AllContactKernels();
/// The fastest here, by a timing of 5 ms on the first call: gathers can be slow (facts of the
/// processor's microcode, not of its name). WORKER.
const ContactKernels& FastestContactKernels();

} // namespace hasp
