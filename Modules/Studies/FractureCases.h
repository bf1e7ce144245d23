#pragma once
#include "Studies/SyntheticFracture.h"

#include <cstdint>
#include <string>
#include <vector>

/// Broken bones with known truth, ready to be segmented. World = patient LPS, mm.
namespace hasp
{

/// A phantom to be broken: BreakPhantom(geometry, settings).
struct FractureCase
{
  std::string name; ///< "broken head", ...
  GridGeometry geometry;
  FractureSettings settings;
};

struct FractureCaseSettings
{
  double spacingMm = 0.6; ///< of cubic voxels, [0.2, 2]
  double crackMm = 0.3;   ///< as FractureSettings
  double erodedMm = 0.0;  ///< as FractureSettings
  bool moved = false;     ///< pieces are shifted by some 0.5 mm and turned by some 0.5 degrees
  bool coneBeam = false;  ///< simulated cone beam: cupping, more noise, metal where there are
                          ///< molars, a field that ends within the head. Values are not HU.
  std::uint64_t seed = 1; ///< of faces, moves and noise
};

/// Cranium in five (maxilla with its teeth, left zygoma, left parietal and frontal pieces that
/// touch each other, the rest) and the mandible: labels 2 the cranium's rest, 3 mandible, 4
/// maxilla, 5 zygoma, 6 parietal, 7 frontal. Throws std::invalid_argument if spacingMm is out of
/// range.
FractureCase BrokenHead(const FractureCaseSettings& settings = {});

/// The lower face: 2 cranium and upper teeth as far as they are in the scan, 3 chin with the left
/// body, 4 right condyle, 5 right body and ramus, 6 left ramus. No face goes through a tooth: one
/// is where 46 is missing.
FractureCase BrokenMandible(const FractureCaseSettings& settings = {});

/// Cuts for a real scan of a skull (in HU, LPS): left parietal, occipital and right temporal
/// pieces, placed by shares of the box around what is named. BreakScan(scan, PlantedCuts(…),
/// named).
///
/// scan    of the skull
/// named   one value a voxel, not 0 where the skull is; LargestBone gives it
FractureSettings PlantedCuts(GridView<const std::int16_t> scan, std::span<const std::uint8_t> named,
  const FractureCaseSettings& settings = {});

/// 1 in the largest piece of what is boneHU and more (faces touch), else 0. O(voxels).
std::vector<std::uint8_t> LargestBone(GridView<const std::int16_t> scan, double boneHU);

/// For stress: a ball of bone in `fragments` pieces, cells around random places, with rough faces
/// between them; labels 2 ... fragments + 1. fragments in [2, 200].
FracturedScan ShatteredBall(int fragments, double radiusMm, double spacingMm, std::uint64_t seed);

/// For stress: a block of bone, label 2, with a fragment of 2 x 2 x 2 voxels, label 3, that a layer
/// of darker bone holds; the rest of the grid is soft tissue. Spacing may differ per axis.
FracturedScan TinyFragment(const glm::dvec3& spacing);

} // namespace hasp
