#pragma once
#include "Isosurface/ClusterRing.h"
#include "Isosurface/RaySampler.h"

#include <memory>
#include <optional>
#include <span>

namespace hasp
{

struct RayCacheSettings
{
  std::size_t clusters = 32'768; ///< records of the ring, >= 1
  std::size_t words = 4U << 20;  ///< of their corners; CT takes some 80 a cluster
  double pixelsACell = 0.5;      ///< the finest level whose cells are no smaller is taken; > 0
  int upkeepShare = 16;          ///< a frame checks one record in so many; >= 1
};

/// The part of an isosurface that viewers see, found by a few rays a frame and kept in clusters of
/// active cells (RayCaching: thesis 3.2.1, Paper V).
///
/// Where a ray meets the surface, the block of 8^3 cells around the hit is put into a circular
/// buffer with its samples, unless the occupancy clipmap says it is there. What is in the buffer
/// is drawn as any clustered cells are, with the exact root in each cell. Nothing is built for an
/// isovalue: a new one makes the clusters that are there anew, and rays find the rest.
///
/// Levels of detail: cells of level l are 2^l samples long, and no place is held, or drawn, at two
/// levels. Where a hit wants finer cells than there are, because the viewer has come near or
/// because it went through the gap that is left where levels meet, the coarse block gives way to
/// all finer ones of its place at once. Where a hit wants coarser cells, the finer that are there
/// do, and what is missing beside them is added as fine; only while the ring has no room for all
/// that is seen do those that no hit has wanted so fine in the last 64 calls give way to the coarse
/// block.
///
/// The windows of the clipmap follow one eye: the first that is sampled, until it has not been for
/// 64 calls; then the next. So several eyes cannot pull them to and fro; where the others look from
/// elsewhere in a volume of more than 512 cells an axis, they see coarser cells.
///
/// Deviations from the paper: rays are cast on the CPU and skip blocks without surface; a brick is
/// a cluster of 8^3 cells of which the active ones have samples; the clipmap holds numbers of
/// records, not bits. Sizes of bricks, tiles and buffer are not published.
///
/// Grid and blocks must outlive the cache. Fixed memory: Bytes(), and what Cells() gives.
/// Threads: one; the work uses all cores inside the calls.
class RayCache
{
public:
  struct Frame
  {
    std::int64_t rays = 0;    ///< cast
    std::int64_t hits = 0;    ///< that met the surface
    std::int64_t known = 0;   ///< of these, what the cache held when they met it
    std::int64_t added = 0;   ///< clusters
    std::int64_t dropped = 0; ///< of these, what was dropped to make room in the last 64 calls
    std::int64_t checked = 0; ///< clusters, by upkeep

    /// Will more frames of this view complete the picture? Not if nothing is added, or if half of
    /// that or more had to be dropped lately: then the cache cannot hold all that is seen, and
    /// only changes what is missing.
    bool Refining() const { return this->added > 2 * this->dropped; }
  };

  /// Throws std::invalid_argument if the blocks are of another grid, the isovalue is not finite or
  /// a setting is out of range.
  RayCache(const AnyGridView& grid, const MinMaxBlocks& blocks, double isovalue,
    const RayCacheSettings& settings = {});

  /// All clusters anew; those without surface at the new isovalue go. About 1 us a cluster. Throws
  /// std::invalid_argument if it is not finite.
  void SetIsovalue(double isovalue);
  /// After samples [low, high] have changed and the blocks have been updated: the clusters that
  /// hold one of them anew.
  void MarkModified(const glm::ivec3& low, const glm::ivec3& high);

  /// A frame's rays: see RaySampler::Sample, which throws. Adds what they find and checks a share
  /// of the clusters against the volume.
  Frame Sample(std::span<const SampledEye> eyes, std::span<const PictureView> predicted, int count);

  int Levels() const { return this->Map.Levels(); }
  /// The clusters of a level, as cells of a volume that has each 2^l-th sample. The same pointer as
  /// long as nothing has changed.
  std::shared_ptr<const ClusteredCells> Cells(int level);

  std::size_t Live() const { return this->Ring.Live(); }
  /// Of buffer and clipmap; fixed.
  std::size_t Bytes() const { return this->Ring.Bytes() + this->Map.Bytes(); }

private:
  static constexpr std::uint32_t Lately = 64; ///< calls of Sample
  /// A block that is to be added.
  struct Missing
  {
    BlockKey key;
    glm::ivec3 cell;      ///< of the volume, where a ray met it
    bool met;             ///< or it only takes its part of a coarse block's place
    std::uint32_t wanted; ///< when a hit last wanted it so fine
  };
  bool Note(const SampledHit& hit, std::vector<Missing>& missing);
  int WantedLevel(const SampledHit& hit) const;
  int LevelAt(const glm::ivec3& cell) const;
  std::uint32_t FinerWanted(const BlockKey& key) const;
  bool KeepsFiner(const BlockKey& key) const;
  void TakeApart(const BlockKey& key, std::vector<Missing>& missing) const;
  void Add(std::vector<Missing> missing, Frame& frame);
  void Follow(std::span<const SampledEye> eyes);
  std::int64_t CheckShare();
  void Renew(const std::vector<std::uint32_t>& numbers);
  ClusterRing::Record& Insert(const BlockKey& key, const ClusterLayer& layer, std::uint32_t seen);
  void Remove(std::uint32_t number);
  ClusteredCells Gather(int level) const;

  AnyGridView Grid;
  const MinMaxBlocks* Blocks;
  RayCacheSettings Settings;
  double Isovalue;
  OccupancyClipmap Map;
  ClusterRing Ring;
  RaySampler Sampler;
  std::uint32_t Now = 0;     ///< counts calls of Sample
  std::optional<int> Leader; ///< the eye that windows follow
  std::uint32_t LeaderSeen = 0;
  std::uint32_t FullUntil = 0; ///< the ring has dropped clusters to make room lately
  std::uint32_t Cursor = 0;    ///< the record that is checked next
  std::vector<std::shared_ptr<const ClusteredCells>> Gathered; ///< a level; null after a change
};

} // namespace hasp
