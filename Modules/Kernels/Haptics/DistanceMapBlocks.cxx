#include "Haptics/DistanceMapBlocks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <utility>

namespace hasp
{

namespace
{

constexpr int Side = MinMaxBlocks::Side, Row = Side + 1, MostSamples = Row * Row * Row;

/// One block's samples, as many as there are.
class BlockSamples
{
public:
  BlockSamples(const Counted& counted, const glm::ivec3& block)
  {
    const glm::ivec3 first = block * Side;
    this->Count = glm::min(first + Side, counted.Grid.geometry.dims - 1) - first + 1;
    this->ForEach([&](const glm::ivec3& p, float& value)
      { value = counted(first.x + p.x, first.y + p.y, first.z + p.z); });
  }
  template <typename Visit>
  void ForEach(const Visit& visit)
  {
    for (int k = 0; k < this->Count.z; ++k)
      for (int j = 0; j < this->Count.y; ++j)
        for (int i = 0; i < this->Count.x; ++i)
          visit(glm::ivec3(i, j, k), this->At({ i, j, k }));
  }
  float& At(const glm::ivec3& p)
  {
    const int n = (p.z * Row + p.y) * Row + p.x;
    return this->Values[n];
  }
  /// The samples before and after p along an axis; p itself where there is none.
  std::pair<float, float> Beside(glm::ivec3 p, int axis)
  {
    const int here = p[axis];
    p[axis] = std::max(here - 1, 0);
    const float before = this->At(p);
    p[axis] = std::min(here + 1, this->Count[axis] - 1);
    return { before, this->At(p) };
  }
  /// Each sample becomes the largest in the cells that share it.
  void Widen()
  {
    for (int a = 0; a < 3; ++a)
    {
      BlockSamples from = *this;
      this->ForEach(
        [&](const glm::ivec3& p, float& value)
        {
          const auto [before, after] = from.Beside(p, a);
          value = std::max({ value, before, after });
        });
    }
  }

private:
  glm::ivec3 Count;
  std::array<float, MostSamples> Values{};
};

} // namespace

Counted::Counted(const GridView<const float>& distances, float range)
  : Grid(distances),
    Range(range)
{
  const GridGeometry& g = distances.geometry;
  this->Far = std::max(range, static_cast<float>(glm::length(g.spacing * glm::dvec3(g.dims))));
}

/// A cell's interpolated gradient is longest at one of its corners, for along each axis two of its
/// parts are linear and the third does not change; there it is made of the differences to three
/// neighbours. So looking from each sample to each axis' steeper side finds the longest of all.
BlockFacts FactsOf(const Counted& counted, const glm::ivec3& block)
{
  BlockSamples samples(counted, block);
  const float first = samples.At({ 0, 0, 0 });
  BlockFacts facts{ { first, first }, 0.0F };
  samples.ForEach(
    [&](const glm::ivec3&, float value)
    {
      facts.range.min = std::min(facts.range.min, value);
      facts.range.max = std::max(facts.range.max, value);
    });
  if (facts.range.max <= 0.0F)
    return facts;
  BlockSamples largest = samples;
  if (facts.range.min <= 0.0F)
    largest.Widen();
  const glm::vec3 perMm = 1.0F / glm::vec3(counted.Grid.geometry.spacing);
  samples.ForEach(
    [&](const glm::ivec3& p, float value)
    {
      if (largest.At(p) <= 0.0F)
        return;
      float squared = 0.0F;
      for (int a = 0; a < 3; ++a)
      {
        const auto [before, after] = samples.Beside(p, a);
        const float slope = std::max(std::abs(value - before), std::abs(after - value)) * perMm[a];
        squared += slope * slope;
      }
      facts.slopeSquared = std::max(facts.slopeSquared, squared);
    });
  return facts;
}

} // namespace hasp
