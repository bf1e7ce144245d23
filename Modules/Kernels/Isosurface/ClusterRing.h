#pragma once
#include "Isosurface/ClusterLayer.h"
#include "Isosurface/OccupancyClipmap.h"

#include <functional>

namespace hasp
{

/// Clusters in a circular buffer: a new one takes the place of the oldest (thesis 3.2.1). Two rings
/// turn together, of records and of the words of their corners, for clusters differ in length.
///
/// Fixed memory, taken when made. Reading: any thread; changes: one thread, nobody reading.
class ClusterRing
{
public:
  struct Record
  {
    BlockKey key;
    CellCluster cluster;          ///< firstWord: in the ring; firstCell is 0
    std::uint32_t words = 0;      ///< of its corners
    std::uint32_t lastSeen = 0;   ///< the owner's clock
    std::uint32_t lastWanted = 0; ///< the same; seen, and no coarser one would have done
    bool live = false;
  };
  /// Told the number of a live record that is about to be dropped.
  using Dropped = std::function<void(std::uint32_t)>;

  static constexpr std::size_t MostWords = 729; ///< of one cluster: floats, all corners

  ClusterRing() = default;
  /// Throws std::invalid_argument if there is no record, or words cannot hold one cluster.
  ClusterRing(std::size_t records, std::size_t words);

  std::size_t Capacity() const { return this->Records.size(); }
  std::size_t Live() const { return this->LiveCount; }
  std::size_t Bytes() const;
  const Record& operator[](std::uint32_t number) const { return this->Records[number]; }
  Record& operator[](std::uint32_t number) { return this->Records[number]; }
  const std::uint32_t* Words(const Record& record) const
  {
    return this->Corners.data() + record.cluster.firstWord;
  }
  /// Of the live records, oldest first.
  std::vector<std::uint32_t> Numbers() const;
  /// Is record `number` the cluster that `layer` holds, bit for bit?
  bool Holds(std::uint32_t number, const ClusterLayer& layer) const;
  /// Will it be dropped before half as many records, or words, as the ring can hold are added?
  bool Old(std::uint32_t number) const;

  /// Puts the one cluster of `layer` at the young end and gives its number. As many of the oldest
  /// are dropped as that takes.
  std::uint32_t Add(
    const BlockKey& key, const ClusterLayer& layer, std::uint32_t now, const Dropped& dropped);
  /// Its place is free once all older ones are gone.
  void Remove(std::uint32_t number);

private:
  void DropOldest(const Dropped& dropped);

  std::vector<Record> Records;
  std::vector<std::uint32_t> Corners;
  std::size_t Oldest = 0, Count = 0; ///< of records, dead ones included
  std::size_t NextWord = 0, LiveCount = 0;
};

} // namespace hasp
