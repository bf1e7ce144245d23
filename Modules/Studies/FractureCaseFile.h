#pragma once
#include "Grid/GridGeometry.h"
#include "Grid/RigidPose.h"
#include "Segmentation/LabelMap.h"

#include <filesystem>
#include <string>
#include <vector>

/// The truth of a broken bone as a file: truth.json of a case's folder, format "fracture-case/1"
/// (Utilities/Docs/Formats.md). Beside it lie the volumes below, which who has IO/Medical reads and
/// writes. World = patient LPS, mm.
namespace hasp
{

/// What a case's folder holds; the last two may be missing.
struct FractureCaseFiles
{
  static constexpr const char* Truth = "truth.json";
  static constexpr const char* FracturedScan = "fractured_ct.mha";
  static constexpr const char* FracturedLabels = "fractured_labels.mha"; ///< of the broken bone
  static constexpr const char* IntactLabels = "intact_labels.mha";       ///< the same, unbroken
  static constexpr const char* IntactScan = "intact_ct.mha";
  static constexpr const char* Strokes = "strokes.json"; ///< one a fragment (SeedsFile.h)
};

/// A surface that bone broke along: a plane and heights on it.
struct FractureCaseSurface
{
  glm::dvec3 point{ 0.0 };
  glm::dvec3 normal{ 0.0, 0.0, 1.0 }; ///< unit; the fragment lies on its side if sign is 1
  double sign = 1.0;                  ///< 1 or -1
  std::uint64_t seed = 1;             ///< of the heights; below 2^53
  std::vector<glm::dvec2> bandsMm;    ///< wavelength, mm, and relative height, of the heights
  double rmsHeightMm = 0.0;
};

/// How a fragment came off: it lies behind all of the surfaces.
struct FractureCaseCut
{
  Label newLabel = 0, parent = 0;
  std::vector<FractureCaseSurface> surfaces;
};

/// A fragment that moved.
struct FractureCaseFragment
{
  Label label = 0;  ///< in both label maps
  std::string name; ///< UTF-8, at most 200 bytes
  /// x_fractured = displacement * x_anatomical; the truth of a reduction is its inverse.
  RigidPose anatomicalToFractured;
  std::uint64_t voxelsAnatomical = 0, voxelsFractured = 0;
  double volumeMm3 = 0.0;
  glm::dvec3 centroidAnatomicalMm{ 0.0 };
  double startMeanMm = 0.0, startMostMm = 0.0; ///< by how much its voxels moved
};

struct FractureCaseLandmark
{
  std::string name;
  Label label = 0; ///< whose bone it is on
  glm::dvec3 anatomicalMm{ 0.0 }, fracturedMm{ 0.0 };
};

/// What else was done to the scan. Cases from elsewhere do not say: `known` is false.
struct FractureCaseDamage
{
  bool known = false;
  double crackMm = 0.0, erodedMm = 0.0;
  std::uint32_t lostChips = 0;
  double chipMm = 0.0; ///< across
  double noiseHU = 0.0;
  glm::dvec3 blurMm{ 0.0 };
  bool coneBeam = false; ///< samples are grey values, and no HU
  std::uint64_t seed = 1;
};

struct FractureCaseTruth
{
  std::string name;
  /// Of the broken scan and both label maps. Files from elsewhere have axes along the patient's.
  GridGeometry geometry;
  std::vector<Label> fixed; ///< did not move
  std::vector<FractureCaseCut> cuts;
  std::vector<FractureCaseFragment> fragments;
  std::vector<FractureCaseLandmark> landmarks;
  FractureCaseDamage damage;
};

/// The pose that brings a label's bone back, fractured to anatomical; the identity for a fixed one.
/// Throws std::invalid_argument for a label that the case does not have.
RigidPose TrueReduction(const FractureCaseTruth& truth, Label label);

/// Throws std::invalid_argument, "fracture case: KEY …", unless labels are above 0 and each of a
/// fragment or fixed one is there once, poses are unit, numbers finite and the grid is one.
void ValidateFractureCase(const FractureCaseTruth& truth);

/// truth.json as text, and back: poses to the last digits (below 1e-9 mm), the rest bit by bit.
/// Reading is strict: no unknown key; a 4x4 must be a proper rotation within 1e-6 with a last row
/// 0 0 0 1 (a mirrored one is refused as such) and the reduction its inverse within 1e-4 mm on the
/// grid's corners. Needs HASP_ENABLE_JSON, as all below. Throws std::runtime_error (no JSON) or
/// std::invalid_argument (content), which hold no text of the file. Any thread. O(file).
std::string FormatFractureCase(const FractureCaseTruth& truth);
FractureCaseTruth ParseFractureCase(const std::string& text);

/// truth.json in a folder, which must be there: replaced whole or not at all; read up to 16 MiB.
/// Throws as above, and std::runtime_error of the disk.
void WriteFractureCase(const std::filesystem::path& folder, const FractureCaseTruth& truth);
FractureCaseTruth ReadFractureCase(const std::filesystem::path& folder);

} // namespace hasp
