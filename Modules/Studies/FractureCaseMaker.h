#pragma once
#include "Studies/FractureCaseFile.h"
#include "Studies/SyntheticFracture.h"

/// Broken bones as cases of FractureCaseFile.h: pieces far from their place, lost chips, eroded
/// faces, a scanner of any voxel. World = patient LPS, mm.
namespace hasp
{

struct FractureCaseChoices
{
  /// Of each piece: how far its centroid goes, [0, 60], away from the bone's middle and up to 35
  /// degrees beside that; how far it turns about it, about any axis, [0, 180].
  double shiftMm = 3.0, turnDegrees = 5.0;
  /// As FractureSettings. What breaks loses no bone; a saw does, and edges that have worn.
  double crackMm = 0.0, erodedMm = 0.0;
  std::uint32_t lostChips = 0; ///< [0, 20], at edges of fractures; of any piece's faces
  double chipMm = 4.0;         ///< across, (0, 15]
  glm::dvec3 spacingMm{ 0.0 }; ///< of the voxels of all files; 0: the scan's
  glm::dvec3 blurMm{ 0.0 };    ///< besides what the scan has, [0, 10]
  double noiseHU = 0.0;        ///< standard deviation, at the end, >= 0
  bool coneBeam = false;       ///< cupping and another scale: values that are no HU
  std::uint64_t seed = 1;      ///< of moves, chips, noise
};

struct MadeFractureCase
{
  FractureCaseTruth truth;
  /// Both on truth.geometry, their labels the same. The intact one has other noise.
  FracturedScan fractured, intact;
};

/// Breaks a scan in `pieces`, whose poses, cracks and chips are replaced by what the choices say.
/// Bones are the fixed labels, 2 and on; pieces follow. scanner.blurMm of `pieces` is how sharp
/// faces are; of its noise and cone beam nothing counts.
///
/// intact, named   as BreakScan
///
/// Limit: nothing keeps moved pieces out of each other or of the rest.
/// Throws std::invalid_argument with value and range; std::runtime_error for a piece of fewer than
/// 50 voxels and for a case without any; Cancelled. Twice BreakScan, 8 bytes a voxel besides.
MadeFractureCase MakeFractureCase(GridView<const std::int16_t> intact, FractureSettings pieces,
  std::span<const std::uint8_t> named, const FractureCaseChoices& choices,
  const ProgressFunction& progress = {});

/// Pieces of any bone: patches of it around `count` places far apart, with rough faces, no larger
/// than 0.15 of the box around what is named nor than 60 mm. For MakeFractureCase. Throws
/// std::invalid_argument unless count is in [1, 20] and something is named.
FractureSettings ScatteredPieces(
  const GridGeometry& geometry, std::span<const std::uint8_t> named, int count, std::uint64_t seed);

} // namespace hasp
