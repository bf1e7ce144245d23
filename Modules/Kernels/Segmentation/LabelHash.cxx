#include "Segmentation/LabelHash.h"

#include "Grid/ParallelFor.h"

#include <vector>

namespace hasp
{
namespace
{

/// One step of FNV-1a with words of 64 bits; the shift brings high bits down, as bytes would.
std::uint64_t Mixed(std::uint64_t hash, std::uint64_t word)
{
  hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
  return hash ^ (hash >> 32);
}

std::uint64_t Finished(std::uint64_t hash)
{
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9U;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebU;
  return hash ^ (hash >> 31);
}

std::uint64_t HashPiece(const Label* labels, std::int64_t count)
{
  auto hash = static_cast<std::uint64_t>(count);
  std::int64_t n = 0;
  for (; n + 4 <= count; n += 4)
    hash = Mixed(hash, labels[n] | std::uint64_t(labels[n + 1]) << 16 |
                         std::uint64_t(labels[n + 2]) << 32 | std::uint64_t(labels[n + 3]) << 48);
  for (; n < count; ++n)
    hash = Mixed(hash, labels[n]);
  return Finished(hash);
}

} // namespace

std::uint64_t HashLabels(GridView<const Label> labels)
{
  constexpr std::int64_t grain = 1 << 16;
  const auto voxels = static_cast<std::int64_t>(labels.geometry.Size());
  std::vector<std::uint64_t> pieces(static_cast<std::size_t>((voxels + grain - 1) / grain));
  ParallelFor(0, voxels, grain,
    [&](std::int64_t first, std::int64_t last)
    {
      pieces[static_cast<std::size_t>(first / grain)] =
        HashPiece(labels.data + first, last - first);
    });
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis)
    hash = Mixed(hash, static_cast<std::uint64_t>(labels.geometry.dims[axis]));
  for (const std::uint64_t piece : pieces)
    hash = Mixed(hash, piece);
  return Finished(hash);
}

} // namespace hasp
