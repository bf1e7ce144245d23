#pragma once
#include "FragmentCrop.h"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace hasp
{

/// What is finished of a scan's fragments: where FragmentModels and the FragmentBakings that came
/// from it meet. A label has a version, which moves when its voxels change: what was made of an
/// older one is not taken.
///
/// Threads: any; nobody waits for more than a few pointers.
class FragmentTable
{
public:
  FragmentModel Find(std::uint16_t label) const;
  /// Those of `wants` that are not there.
  FragmentWants Missing(std::uint16_t label, const FragmentWants& wants) const;
  std::uint64_t Version(std::uint16_t label) const;
  /// Takes what is not there yet. False: the label is of another version, and nothing was taken.
  bool Put(std::uint16_t label, std::uint64_t version, BakedFragment baked);
  void Release(std::uint16_t label, const FragmentWants& what);
  /// Their voxels are others, within samples low to high alone.
  void Change(std::span<const std::uint16_t> labels, const glm::ivec3& low, const glm::ivec3& high);

  /// Cells, and whether their labels are those of the map. Where they are not, but were: the
  /// samples outside of which they still are.
  struct Cells
  {
    std::shared_ptr<const ClusteredCells> cells;
    bool labelled = false;
    glm::ivec3 low{ std::numeric_limits<int>::max() }, high{ std::numeric_limits<int>::min() };
  };
  Cells FindCells() const;
  /// Without labels; keeps those that there are.
  void PutCells(std::shared_ptr<const ClusteredCells> cells, double milliseconds);
  /// The same cells with labels.
  void PutLabelled(std::shared_ptr<const ClusteredCells> cells, double milliseconds);
  void ReleaseCells();

  /// Of the cells, and of all of these labels and those that anything is held of.
  void ListResources(std::span<const FragmentLabel> labels, ResourceList& list) const;

private:
  struct Entry
  {
    std::uint64_t version = 0;
    FragmentModel model;
    std::array<double, FragmentModelKinds> milliseconds{};
    std::array<const char*, FragmentModelKinds>
      why{}; ///< it is there or not; null: never asked for
  };
  static void Drop(Entry& entry, const FragmentWants& what, const char* why);
  static void List(std::uint16_t label, const Entry& entry, ResourceList& list);

  mutable std::mutex Guard;
  std::map<std::uint16_t, Entry> Entries;
  Cells Kept;
  double CellsMilliseconds = 0.0;
  const char* WhyCells = nullptr;
};

} // namespace hasp
