#include "LabelBlocks.h"

#include "Grid/ParallelFor.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <iterator>
#include <set>

namespace hasp
{

namespace
{
constexpr int Side = 32; // samples along each axis of a block

/// Mixes all bits into all (the finalizer of Steele, Lea and Flood 2014, SplitMix).
std::uint64_t Mix(std::uint64_t value)
{
  value += 0x9E3779B97F4A7C15U;
  value = (value ^ value >> 30) * 0xBF58476D1CE4E5B9U;
  value = (value ^ value >> 27) * 0x94D049BB133111EBU;
  return value ^ value >> 31;
}

void Join(LabelExtent& extent, const glm::ivec3& low, const glm::ivec3& high, std::size_t voxels)
{
  extent.low = extent.voxels == 0 ? low : glm::min(extent.low, low);
  extent.high = extent.voxels == 0 ? high : glm::max(extent.high, high);
  extent.voxels += voxels;
}
} // namespace

LabelBlocks::LabelBlocks(const GridView<const std::uint16_t>& labels)
  : Counts((labels.geometry.dims + (Side - 1)) / Side),
    Blocks(std::size_t(Counts.x) * Counts.y * Counts.z)
{
  this->ReadAll(labels, glm::ivec3(0), this->Counts);
  this->AddUp();
}

std::vector<std::uint16_t> LabelBlocks::Update(
  const GridView<const std::uint16_t>& labels, const glm::ivec3& low, const glm::ivec3& high)
{
  const glm::ivec3 first = glm::max(low, 0), last = glm::min(high, labels.geometry.dims - 1);
  if (glm::any(glm::greaterThan(first, last)))
    return {};
  const glm::ivec3 from = first / Side, to = last / Side + 1;
  std::vector<Block> before;
  const auto forEach = [&](const auto& visit)
  {
    for (int k = from.z; k < to.z; ++k)
      for (int j = from.y; j < to.y; ++j)
        for (int i = from.x; i < to.x; ++i)
          visit(this->At({ i, j, k }));
  };
  forEach([&](Block& block) { before.push_back(std::move(block)); });
  this->ReadAll(labels, from, to);
  std::set<std::uint16_t> changed;
  std::size_t n = 0;
  forEach(
    [&](const Block& block)
    {
      const auto less = [](const InBlock& a, const InBlock& b)
      {
        return a.label != b.label
                 ? a.label < b.label
                 : std::pair(a.extent.voxels, a.places) < std::pair(b.extent.voxels, b.places);
      };
      std::vector<InBlock> other;
      std::set_symmetric_difference(block.begin(), block.end(), before[n].begin(), before[n].end(),
        std::back_inserter(other), less);
      for (const InBlock& in : other)
        changed.insert(in.label);
      ++n;
    });
  this->AddUp();
  return { changed.begin(), changed.end() };
}

void LabelBlocks::ReadAll(
  const GridView<const std::uint16_t>& labels, const glm::ivec3& from, const glm::ivec3& to)
{
  const glm::i64vec3 size(to - from);
  ParallelFor(0, size.x * size.y * size.z, 1,
    [&](std::int64_t n, std::int64_t)
    {
      const glm::ivec3 block =
        from + glm::ivec3(n % size.x, n / size.x % size.y, n / size.x / size.y);
      this->At(block) = Read(labels, block);
    });
}

LabelBlocks::Block LabelBlocks::Read(
  const GridView<const std::uint16_t>& labels, const glm::ivec3& block)
{
  const glm::ivec3 low = block * Side, end = glm::min(low + Side, labels.geometry.dims);
  Block found;
  const auto of = [&](std::uint16_t label) -> InBlock&
  {
    const auto at = std::find_if(
      found.begin(), found.end(), [&](const InBlock& in) { return in.label == label; });
    return at != found.end() ? *at : found.emplace_back(InBlock{ label, {}, 0 });
  };
  for (int k = low.z; k < end.z; ++k)
    for (int j = low.y; j < end.y; ++j)
    {
      const std::uint16_t* row = &labels(0, j, k);
      for (int i = low.x; i < end.x;)
      {
        const int begin = i;
        const std::uint16_t label = row[i];
        while (i < end.x && row[i] == label)
          ++i;
        if (label == 0)
          continue;
        InBlock& in = of(label);
        Join(in.extent, { begin, j, k }, { i - 1, j, k }, std::size_t(i - begin));
        // A run is where it begins and how long it is: other runs, other sums.
        in.places += Mix(Mix(labels.Offset(begin, j, k)) + std::uint64_t(i - begin));
      }
    }
  std::sort(found.begin(), found.end(),
    [](const InBlock& a, const InBlock& b) { return a.label < b.label; });
  return found;
}

void LabelBlocks::AddUp()
{
  this->Found.clear();
  for (const Block& block : this->Blocks)
    for (const InBlock& in : block)
      Join(this->Found[in.label], in.extent.low, in.extent.high, in.extent.voxels);
}

} // namespace hasp
