#pragma once
#include "Grid/GridView.h"
#include "Grid/MinMaxBlocks.h"
#include "Grid/Progress.h"
#include "Grid/ResourceUse.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace hasp
{

/// What the haptic step reads of a distance map, in its inner loop. T: std::int16_t, the working
/// layout, or float, the reference.
///
/// Samples lie in bricks of 8x8x8 cells, one for each block that the band around the surface
/// reaches, with the samples on their far faces too (the apron): 9x9x9, x fastest, so that a cell's
/// eight samples are all in one brick. Blocks without a brick share one that is wholly outside
/// (+range) or one that is wholly inside (-range).
template <typename T>
struct DistanceMapView
{
  static constexpr int Side = 8;       ///< cells a block and axis
  static constexpr int Row = Side + 1; ///< samples from a row of a brick to the next
  static constexpr int Slice = Row * Row;
  static constexpr int BrickSamples =
    Slice * Row + 1; ///< an int16 pair at the last one may be read

  const T* samples = nullptr;
  const std::int32_t* firstSample = nullptr; ///< of each block's brick; blocks x fastest
  glm::ivec3 blocks{ 0 };
  glm::vec3 last{ 0.0F }; ///< index coordinates of the last sample; beyond [0, last]: +range
  float mmPerStep = 0.0F; ///< distance in mm = sample * mmPerStep
  float rangeMm = 0.0F;   ///< distances are clamped to +-range
  const MinMaxBlocks::Range* unclamped = nullptr; ///< of each block, mm: for the coarse phase
  /// Index coordinates of a point of the body's own axes (mm); and a gradient per index step in mm
  /// per mm along the body's own axes.
  glm::mat3 toIndex{ 1.0F };
  glm::vec3 indexOfOrigin{ 0.0F };
  glm::mat3 gradientToBody{ 1.0F };
  /// On any way outside of the body the distance falls by no more than this times its length, mm
  /// per mm: measured, about 1 for a good transform. What the coarse phase may conclude from a
  /// distance.
  float steepest = 1.0F;
};

struct DistanceMapSettings
{
  /// Distances are kept within +-range and clamped outside: as deep as a body may ever be pressed
  /// in, and as far as Snap-to-fit reaches. 0: sixteen of the smallest spacings, or the largest one
  /// where that is more.
  double rangeMm = 0.0;
  /// Of the body's own axes, world, as the grid lies: the same as of the body's PointShell.
  glm::dvec3 origin{ 0.0 };
  bool reference = false; ///< keep the distances in float, too, for Reference
};

/// The signed distance to a body's surface, for contact: mm, NEGATIVE INSIDE. Made from a transform
/// of Kernels/Distance; immutable.
///
/// int16 at range/32767 a step: with the default range a step is 1/2048 of the smallest spacing.
/// Deviation from the thesis, whose maps are whole volumes of 16 bit: bricks, because whole maps of
/// 256^3 fall out of the cache.
/// Threads: any, once made. Memory: 1460 B a brick and 12 B a block; 2920 B more a brick with the
/// reference.
class DistanceMap
{
public:
  /// Reads `distances` on all threads; keeps nothing of it. Distances that are infinite are
  /// clamped; NaN counts as +range. Throws std::invalid_argument on an invalid geometry, fewer than
  /// 2 samples on an axis, a range that is not finite, negative, or under half the largest spacing,
  /// or an origin that is not finite; std::runtime_error if there are more than 1.4 million bricks;
  /// Cancelled. O(samples).
  explicit DistanceMap(const GridView<const float>& distances,
    const DistanceMapSettings& settings = {}, const ProgressFunction& progress = {});
  ~DistanceMap();
  DistanceMap(const DistanceMap&) = delete;
  DistanceMap& operator=(const DistanceMap&) = delete;

  DistanceMapView<std::int16_t> View() const noexcept;
  /// The same bricks in float, not rounded; for tests and reports. Throws std::runtime_error unless
  /// the settings asked for it.
  DistanceMapView<float> Reference() const;

  const GridGeometry& Geometry() const noexcept;
  double RangeMm() const noexcept;
  double SmallestSpacing() const noexcept; ///< mm: penetration is held under half of it
  /// Distance and its gradient (mm per mm, world axes) at a world point, from the int16 bricks; the
  /// scalar reference of every kernel here. +range and 0 outside of the grid, and for NaN.
  struct Sample
  {
    double mm;
    glm::dvec3 gradient;
  };
  Sample At(const glm::dvec3& world) const noexcept;
  void ListResources(ResourceList& list) const;

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

} // namespace hasp
