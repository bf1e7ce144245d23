#pragma once
#include "Blade.h"
#include "Grid/GridView.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace hasp
{

/// Where a sample lies, by its number; x fastest.
inline glm::ivec3 SamplePlace(const glm::ivec3& dims, std::size_t sample)
{
  return { sample % dims.x, sample / dims.x % dims.y, sample / dims.x / dims.y };
}

/// The first and the last sample of a grid in an upright box of the world, and one more on each
/// side; none if the first is beyond the last along an axis.
std::pair<glm::ivec3, glm::ivec3> SamplesIn(
  const GridGeometry& grid, const ImplicitSolid::Box& box);

/// Samples of bone that are connected through neighbours (26 of them), by a seed. Leaves those of
/// `mark` that are `from` as `to`, and tells each. O(samples of it).
void FloodSamples(const glm::ivec3& dims, std::vector<std::uint8_t>& mark, std::size_t seed,
  std::uint8_t from, std::uint8_t to, const std::function<void(std::size_t)>& tell = {});

/// Which fragment samples of a volume belong to, cut by cut: enough to say which bone a blade is
/// meant for. What fragments are at last is said by their meshes.
/// One thread.
class FragmentLabels
{
public:
  /// keep   one byte a sample; connected ones are islands, numbered from 1
  FragmentLabels(const GridGeometry& volume, std::span<const std::uint8_t> keep);

  /// Of the sample nearest to a place among the eight around it; 0 where none of them is bone.
  std::uint32_t At(const glm::dvec3& world) const;

  /// Takes away what a tool takes of a fragment, and gives what is no longer connected, other than
  /// through the tool, new numbers.
  void Part(std::uint32_t fragment, const CutTool& tool);

private:
  void Flood(std::uint32_t from, std::uint32_t to, std::size_t seed, const CutTool* tool);

  GridGeometry Grid; ///< of the box around what is kept
  std::vector<std::uint32_t> Labels;
  std::uint32_t Last = 0;
  glm::ivec3 NearLow{ 0 }, NearHigh{ 0 }; ///< samples whose ways a tool may block
  std::vector<std::size_t> Queue;
};

} // namespace hasp
