#pragma once
#include "Grid/AnalyticSolid.h"
#include "Grid/GridView.h"
#include "Grid/Phantom.h"
#include "Grid/Progress.h"
#include "Grid/RigidPose.h"
#include "Segmentation/LabelMap.h"
#include "Studies/RoughPlane.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// Broken bone with voxel truth: an intact scan is parted by rough surfaces, its pieces are moved
/// by known poses, and it is scanned again. World = patient LPS, mm.
namespace hasp
{

/// A bone that is there before anything breaks.
struct FractureBone
{
  std::string name;
  /// A place belongs to the bone whose solid is nearest (the lower number of equals). None is
  /// needed where there is one bone only.
  std::optional<AnalyticSolid> solid{};
};

/// What lies behind all faces, and in no piece before this one. What is left of a bone stays where
/// it is.
struct FracturePiece
{
  std::string name;
  std::size_t bone = 0;            ///< of which it is
  std::vector<FractureFace> faces; ///< at least one
  RigidPose moved{};               ///< intact world to broken world; the identity: not at all
};

/// Bone that is lost: what lies behind all faces. It is in no piece, and of no bone any more.
struct FractureChip
{
  std::size_t bone = 0;
  std::vector<FractureFace> faces; ///< at least one
};

struct FractureSettings
{
  std::vector<FractureBone> bones{ { "bone" } }; ///< at least one
  std::vector<FracturePiece> pieces;
  std::vector<FractureChip> chips; ///< taken out before there are pieces
  double crackMm = 0.3;            ///< between two faces before pieces are moved, [0, 10]
  double erodedMm = 0.0; ///< the most that each face lost besides; from place to place between
                         ///< nothing and that, [0, 10]
  double crackHU = 50.0; ///< what fills cracks: blood
  double boneHU = 226.0; ///< bone is this and more, > crackHU
  /// blurMm, sliceMm and edgeMm blur the faces, as they blurred the intact scan's surfaces; noise,
  /// grain, seed, cone beam and the end of the field come on top of all.
  PhantomSettings scanner{};
  glm::dvec3 axis{ 0.0 }; ///< a point of the scanner's axis, world mm: of cupping and of the field
  bool metal = false;     ///< the phantom's crowns streak; for scans of the phantom only
};

/// A scan and its truth, on one grid, x fastest.
struct FracturedScan
{
  GridGeometry geometry;
  std::vector<std::int16_t> samples; ///< HU; in cone beam grey values that are not
  /// 0: nothing; 2 + b: what is left of bone b; 2 + bones + p: piece p. A voxel has a label where
  /// the scan before its faults is bone (rounded value >= boneHU) and the field of view holds it;
  /// of the fragments that share it the one that gives most of its bone, so on unmoved pieces the
  /// one on whose side of the face its centre lies (where faces meet: if the blur is the same
  /// along all axes).
  std::vector<Label> truth;
  std::vector<std::string> names; ///< of labels 2, 3 ...
};

/// Breaks a scan. With e = max(HU - crackHU, 0), the bone that a place of the intact scan holds, a
/// voxel's value is b = min(HU, crackHU) there plus, for each fragment, e where the fragment
/// brought the voxel from, times the share that the scanner sees of the fragment's side of its
/// faces (a flat face's closed form, SurfaceStep, set back by half a crack and what was lost).
/// Shares that add up to more than 1 (pieces pressed into each other) are scaled to 1. So a crack
/// thinner than the blur is a dip and no gap, and unmoved bone away from cracks keeps its samples.
/// Bone that comes to softer tissue or air takes its place: of b the share min(E / (boneHU -
/// crackHU), 1) becomes crackHU, where E is the sum of what fragments bring.
///
/// intact   HU without faults
/// named    as many values as voxels: labels are given where it is not 0 (of what is moved: at the
///          nearest voxel it came from). Empty: everywhere.
///
/// Limits: moved pieces are interpolated trilinearly; where a face is curved or ends within the
/// blur the shares are of first order; the soft tissue stays where it was.
/// Throws std::invalid_argument with the field, its value and the legal range; Cancelled. All
/// cores, the same bytes with any number of threads. 4 bytes a voxel besides the intact scan;
/// costs a copy, and some us a voxel within some mm of faces and in moved pieces.
FracturedScan BreakScan(GridView<const std::int16_t> intact, const FractureSettings& settings,
  std::span<const std::uint8_t> named = {}, const ProgressFunction& progress = {});

/// The phantom of settings.scanner, scanned without faults on that grid. Throws as BreakPhantom.
std::vector<std::int16_t> IntactPhantom(const GridGeometry& geometry,
  const FractureSettings& settings, const ProgressFunction& progress = {});

/// The same, and broken.
FracturedScan BreakPhantom(const GridGeometry& geometry, const FractureSettings& settings,
  const ProgressFunction& progress = {});

} // namespace hasp
