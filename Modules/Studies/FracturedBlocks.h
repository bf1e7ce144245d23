#pragma once
#include "Haptics/HapticScene.h"
#include "Reduction/FractureFit.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace hasp
{

struct FracturedBlockSettings
{
  int pieces = 2;                        ///< 2, or 3: the upper one is broken once more
  glm::dvec3 sideMm{ 30.0, 20.0, 24.0 }; ///< of the whole block, each in [10, 100]
  double roughMm = 0.7;                  ///< heights of a face, root mean square, [0, 2]
  double shortestMm = 2.0;               ///< of a face's waves, >= 3 spacings
  double longestMm = 12.0;               ///< of them, >= shortestMm
  double lostMm = 0.0;    ///< the most that the moved piece's faces lost, place by place, [0, 2]
  double spacingMm = 0.5; ///< of the grids, [0.2, 2]
  int points = 16'384;    ///< of a shell, at most
  int coarsest = 64;      ///< of its level 0; each has four times as many as the one before
  std::uint64_t seed = 1; ///< of the faces
  /// What does not go together, of 2 pieces: the standing one reaches so much farther to all sides
  /// but its face, [0, 20] mm; the moved one is its own mirror image, in x.
  double widerMm = 0.0;
  bool mirrored = false;
};

/// A piece of a broken block.
struct BlockPiece
{
  std::shared_ptr<const DistanceMap> map;
  std::shared_ptr<const PointShell> shell;
  PlacedBody whole; ///< of both, where the block was whole: the truth
};

/// The fractured blocks of the thesis (3.3, Fig. 3.17), whose shapes are not published; these are
/// ours. A block about the world's origin, broken across z by a rough plane through its middle;
/// with three pieces its upper half once more, across x. Both sides of a break are the same surface
/// in closed form (RoughPlane), so that at the truth faces touch all over and nothing overlaps.
///
/// Waves of shortestMm are finer than the coarse levels' points: 256 of them stand 3 mm apart here,
/// 16'384 a third of one.
struct FracturedBlocks
{
  std::vector<BlockPiece> pieces; ///< the last one is to be moved
  glm::dvec3 push{ 0, 0, -1 };    ///< unit, world: the way by which it goes into its place

  const BlockPiece& Moved() const { return this->pieces.back(); }
  std::vector<GroupBody> MovedGroup() const { return { { this->Moved().whole.body, {} } }; }
  FitScene SceneOfOthers() const; ///< the standing pieces, all of them partners
  /// The moved piece as a tool before the others, for a HapticStep of its own.
  std::unique_ptr<HapticScene> TouchScene() const;
};

/// Distances are the larger of the box's and the faces', in closed form on a grid: exact in sign,
/// in size to first order before a face; farther off than a voxel they fall no more steeply than
/// distances do (BoundByNeighbours). Throws std::invalid_argument with the value and its legal
/// range. Deterministic. WORKER; all cores; about 1 s a piece.
FracturedBlocks MakeFracturedBlocks(const FracturedBlockSettings& settings = {});

} // namespace hasp
