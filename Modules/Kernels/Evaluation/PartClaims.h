#pragma once
#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace hasp
{

/// A saw slot: two flat walls that face each other, and nothing between them all through the part.
struct ClaimedSlot
{
  glm::dvec3 point{ 0.0 };            ///< middle of the slot, world mm
  glm::dvec3 normal{ 1.0, 0.0, 0.0 }; ///< of the saw plane; unit
  glm::dvec3 along{ 0.0, 1.0, 0.0 };  ///< in the saw plane, of its length; unit
  double widthMm = 1.0;               ///< (0, 20]
  double lengthMm = 20.0;             ///< (0, 500]
  double toleranceMm = 0.1;           ///< of width, flatness and place; (0, 10]
};

/// A round hole all through the part. A screw's head has room of its own at one end of its bore.
struct ClaimedHole
{
  glm::dvec3 point{ 0.0 };          ///< on the axis, world mm
  glm::dvec3 axis{ 0.0, 0.0, 1.0 }; ///< unit
  double diameterMm = 2.0;          ///< of the bore, (0, 50]
  double toleranceMm = 0.1;         ///< of diameter and place; (0, 10]
  double lowMm = -1000.0;           ///< the bore, along the axis from `point`: wider ends are
  double highMm = 1000.0;           ///< beyond; [-1000, 1000], low below high
  double clearMm = 1000.0;          ///< nor may anything be in the way so far beyond; [0, 1000]
  double roomMm = 0.0;              ///< diameter of the room beside the bore; [0, 50], 0: none
  std::string name = {};            ///< as its recipe names it: "screws[2]"; empty: "holes[n]"
};

/// What texts call the `number`-th of a part's claimed holes, from 0.
std::string NameOfHole(const ClaimedHole& hole, std::size_t number);

/// A shell that lies on bone: its inner wall `gapMm` off, its outer wall `thicknessMm` more.
struct ClaimedShell
{
  double gapMm = 0.3;                ///< [0, 10]
  double gapToleranceMm = 0.2;       ///< (0, 10]
  double leastGapShare = 0.95;       ///< of the inner wall that must be within it; [0, 1]
  double thicknessMm = 2.5;          ///< (0, 50]
  double thicknessToleranceMm = 0.4; ///< (0, 50]
  double besideMm3 = 0.0;            ///< of the part that is no shell: boxes, sleeves; [0, 1e7]
};

/// What a part promises, whoever made it: what a certificate holds it to. Plain values; world =
/// patient LPS, mm.
struct PartClaims
{
  double isovalue = 226.0;       ///< bone is value >= isovalue
  double ignoreBelowMm3 = 100.0; ///< pieces of "bone" smaller than this are none; [0, 1e6]
  std::optional<ClaimedShell> shell;
  std::vector<ClaimedSlot> slots;
  std::vector<ClaimedHole> holes;
  std::optional<glm::dvec3> withdrawal; ///< unit: the part lifts off along it, and goes on against
  std::size_t pieces = 1;
  /// No wall may be thinner, whatever else is claimed; [0, 50]. 0.6: what a resin printer makes of
  /// a wall that stands free (Formlabs' design guide).
  double leastWallMm = 0.6;
  /// Nor may a wall that no claimed slot or hole ends; [0, 50], 0: not claimed. What is perforated
  /// is thinner between its holes than it is thick.
  double leastUncutMm = 0.0;
};

/// Is more claimed than what every part is held to, a sound mesh of one piece and its least wall?
/// Without, a certificate does not say how the part fits.
bool ClaimFit(const PartClaims& claims);

/// Throws std::invalid_argument, with the claim, its value and the legal range, unless all numbers
/// are finite and in their ranges and directions unit within 1e-3 (a slot's two upright on each
/// other within that).
void ValidateClaims(const PartClaims& claims);

} // namespace hasp
