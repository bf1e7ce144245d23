#include "Distance/DistanceBounds.h"

#include "Grid/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>

namespace hasp
{
namespace
{

constexpr float Slack = 0.01F; // of a spacing: what transforms are off by anyway

class Bounds
{
public:
  Bounds(const GridGeometry& geometry, std::vector<float>& distance)
    : Dims(geometry.dims),
      Step(geometry.spacing),
      Stride{ 1, geometry.dims.x, std::int64_t(geometry.dims.x) * geometry.dims.y },
      Distance(distance)
  {
  }

  void ByCrossings(std::span<const float> values)
  {
    this->OverRows(
      [&](std::int64_t row, int y, int z)
      {
        for (int x = 0; x < this->Dims.x; ++x)
        {
          const std::int64_t v = row + x;
          float most = std::abs(this->Distance[v]);
          const float value = values[v] - 0.5F;
          this->OverNeighbours({ x, y, z },
            [&](std::int64_t step, float spacing)
            {
              const float other = values[v + step] - 0.5F;
              if ((other >= 0.0F) != (value >= 0.0F))
                most = std::min(most, spacing * value / (value - other));
            });
          this->Distance[v] = value >= 0.0F ? -most : most;
        }
      });
  }

  /// Until no two neighbours differ by more than they can. It ends: distances only come nearer, and
  /// those that none changed around, as where a step is less than what floats tell, stay.
  void ByNeighbours(float least)
  {
    std::vector<std::int64_t> wrong = this->FindSteep();
    std::erase_if(wrong, [&](std::int64_t v) { return !this->MayMove(v, least); });
    std::vector<float> bounded;
    while (!wrong.empty())
    {
      bounded.resize(wrong.size());
      ParallelFor(0, std::int64_t(wrong.size()), 256,
        [&](std::int64_t first, std::int64_t last)
        {
          for (std::int64_t n = first; n < last; ++n)
            bounded[n] = this->Bounded(wrong[n], least);
        });
      std::vector<std::int64_t> next;
      for (std::size_t n = 0; n < wrong.size(); ++n)
      {
        const std::int64_t v = wrong[n];
        if (bounded[n] == this->Distance[v])
          continue;
        this->Distance[v] = bounded[n];
        next.push_back(v);
        this->OverNeighbours(
          this->PlaceOf(v), [&](std::int64_t step, float) { next.push_back(v + step); });
      }
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      std::erase_if(
        next, [&](std::int64_t v) { return !this->Steep(v) || !this->MayMove(v, least); });
      wrong = std::move(next);
    }
  }

private:
  template <typename Work>
  void OverRows(const Work& work) const
  {
    ParallelFor(0, std::int64_t(this->Dims.y) * this->Dims.z, 16,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t row = first; row < last; ++row)
          work(row * this->Dims.x, int(row % this->Dims.y), int(row / this->Dims.y));
      });
  }

  /// work(step to the neighbour's index, spacing).
  template <typename Work>
  void OverNeighbours(const glm::ivec3& place, const Work& work) const
  {
    for (int a = 0; a < 3; ++a)
    {
      if (place[a] > 0)
        work(-this->Stride[a], this->Step[a]);
      if (place[a] + 1 < this->Dims[a])
        work(this->Stride[a], this->Step[a]);
    }
  }

  glm::ivec3 PlaceOf(std::int64_t v) const
  {
    return { v % this->Dims.x, v / this->Dims.x % this->Dims.y, v / this->Stride[2] };
  }

  bool MayMove(std::int64_t v, float least) const { return std::abs(this->Distance[v]) > least; }

  bool Steep(std::int64_t v) const
  {
    bool steep = false;
    this->OverNeighbours(this->PlaceOf(v),
      [&](std::int64_t step, float spacing)
      {
        steep = steep ||
                std::abs(this->Distance[v + step] - this->Distance[v]) > (1.0F + Slack) * spacing;
      });
    return steep;
  }

  /// On its own side, one step more than a neighbour on the same side; across the surface both give
  /// way in proportion.
  float Bounded(std::int64_t v, float least) const
  {
    const float was = this->Distance[v];
    float most = std::abs(was);
    this->OverNeighbours(this->PlaceOf(v),
      [&](std::int64_t step, float spacing)
      {
        const float other = this->Distance[v + step];
        if ((other < 0.0F) == (was < 0.0F))
          most = std::min(most, std::abs(other) + spacing);
        else if (const float apart = std::abs(other) + std::abs(was); apart > spacing)
          most = std::min(most, std::abs(was) * spacing / apart);
      });
    return std::copysign(std::max(most, least), was);
  }

  /// Voxels that differ too much from a neighbour, in raster order.
  std::vector<std::int64_t> FindSteep() const
  {
    std::vector<std::int64_t> found;
    std::mutex mutex;
    this->OverRows(
      [&](std::int64_t row, int y, int z)
      {
        std::vector<std::int64_t> here;
        if (this->SteepRow(row, y, z))
          for (std::int64_t v = row; v < row + this->Dims.x; ++v)
            if (this->Steep(v))
              here.push_back(v);
        if (here.empty())
          return;
        const std::scoped_lock lock(mutex);
        found.insert(found.end(), here.begin(), here.end());
      });
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Does any voxel of a row? A loop that compilers turn into vectors.
  bool SteepRow(std::int64_t row, int y, int z) const
  {
    const float* here = &this->Distance[row];
    const int n = this->Dims.x;
    int steep = 0;
    const auto compare = [&](const float* other, int count, float spacing)
    {
      const float most = (1.0F + Slack) * spacing;
      for (int x = 0; x < count; ++x)
        steep |= std::abs(other[x] - here[x]) > most;
    };
    compare(here + 1, n - 1, this->Step.x);
    for (const int side : { -1, 1 })
    {
      if (y + side >= 0 && y + side < this->Dims.y)
        compare(here + side * this->Stride[1], n, this->Step.y);
      if (z + side >= 0 && z + side < this->Dims.z)
        compare(here + side * this->Stride[2], n, this->Step.z);
    }
    return steep != 0;
  }

  glm::ivec3 Dims;
  glm::vec3 Step;
  std::int64_t Stride[3];
  std::vector<float>& Distance;
};

} // namespace

void BoundByCrossings(
  const GridGeometry& geometry, std::span<const float> values, std::vector<float>& distance)
{
  Bounds(geometry, distance).ByCrossings(values);
}

void BoundByNeighbours(const GridGeometry& geometry, float least, std::vector<float>& distance)
{
  Bounds(geometry, distance).ByNeighbours(least);
}

} // namespace hasp
