#pragma once
#include "Haptics/DistanceMap.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

namespace hasp
{

/// Bricks of a function's values, written sample by sample: for the tests of what reads them.
template <typename T>
class BakedMap
{
public:
  using View = DistanceMapView<T>;

  /// function(body axes, mm): signed distance, mm. The body's axes are the grid's world.
  template <typename Function>
  BakedMap(const GridGeometry& grid, double rangeMm, const Function& function)
  {
    this->Made.blocks = (grid.dims - 1 + View::Side - 1) / View::Side;
    this->Made.last = glm::vec3(grid.dims - 1);
    this->Made.rangeMm = static_cast<float>(rangeMm);
    this->Made.mmPerStep = std::is_same_v<T, float> ? 1.0F : static_cast<float>(rangeMm / 32767.0);
    const glm::dmat3 toIndex = glm::inverse(grid.IndexToWorldMatrix());
    this->Made.toIndex = glm::mat3(toIndex);
    this->Made.indexOfOrigin = glm::vec3(-(toIndex * grid.origin));
    this->Made.gradientToBody = glm::mat3(glm::transpose(toIndex));

    this->AddBrick([&](const glm::ivec3&) { return rangeMm; });
    this->AddBrick([&](const glm::ivec3&) { return -rangeMm; });
    const glm::ivec3& blocks = this->Made.blocks;
    for (int b = 0; b < blocks.x * blocks.y * blocks.z; ++b)
    {
      const glm::ivec3 low =
        View::Side * glm::ivec3(b % blocks.x, b / blocks.x % blocks.y, b / blocks.x / blocks.y);
      double least = rangeMm, most = -rangeMm;
      const std::int32_t brick = this->AddBrick(
        [&](const glm::ivec3& local)
        {
          const glm::dvec3 index(glm::min(low + local, grid.dims - 1));
          const double mm = function(grid.IndexToWorld(index));
          least = std::min(least, mm);
          most = std::max(most, mm);
          return mm;
        });
      const bool shared = least >= rangeMm || most <= -rangeMm;
      if (shared)
        this->Samples.resize(static_cast<std::size_t>(brick));
      this->FirstSample.push_back(!shared ? brick : least > 0.0 ? 0 : View::BrickSamples);
    }
    this->Made.samples = this->Samples.data();
    this->Made.firstSample = this->FirstSample.data();
  }

  const View& Get() const { return this->Made; }

private:
  template <typename Function>
  std::int32_t AddBrick(const Function& mmOf)
  {
    const std::int32_t first = static_cast<std::int32_t>(this->Samples.size());
    const double range = this->Made.rangeMm;
    for (int z = 0; z < View::Row; ++z)
      for (int y = 0; y < View::Row; ++y)
        for (int x = 0; x < View::Row; ++x)
        {
          const double mm = std::clamp<double>(mmOf(glm::ivec3(x, y, z)), -range, range);
          if constexpr (std::is_same_v<T, float>)
            this->Samples.push_back(static_cast<float>(mm));
          else
            this->Samples.push_back(static_cast<T>(std::lround(mm / range * 32767.0)));
        }
    this->Samples.push_back(T(0));
    return first;
  }

  View Made;
  std::vector<T> Samples;
  std::vector<std::int32_t> FirstSample;
};

} // namespace hasp
