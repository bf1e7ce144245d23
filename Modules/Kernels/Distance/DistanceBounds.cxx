#include "Distance/DistanceBounds.h"

#include "Grid/ParallelFor.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>

namespace hasp
{
namespace
{

constexpr float Slack = 0.01F;    // of a spacing: what transforms are off by anyway
constexpr float MostFall = 1.03F; // what neighbours tell of a slope is off by more than distances

class Bounds
{
public:
  Bounds(const GridGeometry& geometry, std::vector<float>& distance)
    : Dims(geometry.dims),
      Step(geometry.spacing),
      PerStep(1.0F / Step),
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
    while (!wrong.empty())
    {
      std::vector<std::int64_t> next =
        this->Move(wrong, [&](std::int64_t v) { return this->Bounded(v, least); });
      std::erase_if(
        next, [&](std::int64_t v) { return !this->Steep(v) || !this->MayMove(v, least); });
      wrong = std::move(next);
    }
  }

  /// Of voxels from `near` to `far` that fall too steeply, then of those around any that moved. All
  /// of a round see what was before it: the order does not matter.
  bool ByNearVoxels(float near, float far)
  {
    std::vector<std::int64_t> wrong = this->Find([&](std::int64_t row, int y, int z)
      { return this->FallingRow(row, y, z, near, far); },
      [&](std::int64_t v) { return this->Falling(v, near); });
    bool moved = false;
    while (!wrong.empty())
    {
      std::vector<std::int64_t> next =
        this->Move(wrong, [&](std::int64_t v) { return this->FromNearVoxels(v, near); });
      moved = moved || !next.empty();
      std::erase_if(next, [&](std::int64_t v) { return !this->Falling(v, near); });
      wrong = std::move(next);
    }
    return moved;
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

  /// Gives each of `wrong` its bound, all at once; those that moved and their neighbours, sorted.
  template <typename Bound>
  std::vector<std::int64_t> Move(const std::vector<std::int64_t>& wrong, const Bound& bound)
  {
    std::vector<float> bounded(wrong.size());
    ParallelFor(0, std::int64_t(wrong.size()), 64,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
          bounded[n] = bound(wrong[n]);
      });
    std::vector<std::int64_t> around;
    for (std::size_t n = 0; n < wrong.size(); ++n)
    {
      const std::int64_t v = wrong[n];
      if (bounded[n] == this->Distance[v])
        continue;
      this->Distance[v] = bounded[n];
      around.push_back(v);
      this->OverNeighbours(
        this->PlaceOf(v), [&](std::int64_t step, float) { around.push_back(v + step); });
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
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

  /// Does a distance fall too steeply towards the surface? By how much each axis' nearer neighbour
  /// is lower: just 1 in all, squared and added, above planes.
  static bool TooSteep(
    float here, const glm::vec3& before, const glm::vec3& after, const glm::vec3& perStep)
  {
    const float side = std::copysign(1.0F, here), away = std::abs(here);
    const auto squared = [&](float one, float other, float per)
    {
      const float fall = std::max(0.0F, away - std::min(side * one, side * other)) * per;
      return fall * fall;
    };
    return squared(before.x, after.x, perStep.x) + squared(before.y, after.y, perStep.y) +
             squared(before.z, after.z, perStep.z) >
           MostFall * MostFall;
  }

  bool Falling(std::int64_t v, float near) const
  {
    const float here = this->Distance[v];
    if (std::abs(here) <= near)
      return false;
    const glm::ivec3 place = this->PlaceOf(v);
    glm::vec3 before(here), after(here);
    for (int a = 0; a < 3; ++a)
    {
      if (place[a] > 0)
        before[a] = this->Distance[v - this->Stride[a]];
      if (place[a] + 1 < this->Dims[a])
        after[a] = this->Distance[v + this->Stride[a]];
    }
    return TooSteep(here, before, after, this->PerStep);
  }

  /// Any from `near` to `far` in a row? Stretches of the row that have none are passed over.
  bool FallingRow(std::int64_t row, int y, int z, float near, float far) const
  {
    constexpr int Stretch = 16;
    const float* here = &this->Distance[row];
    const float* const up = y + 1 < this->Dims.y ? here + this->Stride[1] : here;
    const float* const down = y > 0 ? here - this->Stride[1] : here;
    const float* const next = z + 1 < this->Dims.z ? here + this->Stride[2] : here;
    const float* const last = z > 0 ? here - this->Stride[2] : here;
    const glm::vec3 perStep = this->PerStep;
    const int n = this->Dims.x;
    int falling = this->Falling(row, near) || this->Falling(row + n - 1, near);
    for (int first = 1; first + 1 < n && !falling; first += Stretch)
    {
      const int end = std::min(first + Stretch, n - 1);
      int some = 0;
      for (int x = first; x < end; ++x)
        some |= (std::abs(here[x]) > near) & (std::abs(here[x]) < far);
      for (int x = first; x < end && some; ++x)
        falling |= (std::abs(here[x]) > near) & TooSteep(here[x], { here[x - 1], down[x], last[x] },
                                                  { here[x + 1], up[x], next[x] }, perStep);
    }
    return falling != 0;
  }

  /// No farther than any voxel on this side within `near` of the surface, and on from there.
  float FromNearVoxels(std::int64_t v, float near) const
  {
    const float here = this->Distance[v], side = std::copysign(1.0F, here);
    float least = std::abs(here);
    const glm::ivec3 place = this->PlaceOf(v), reach(glm::vec3(least) * this->PerStep);
    const glm::ivec3 low = glm::max(place - reach, 0),
                     high = glm::min(place + reach, this->Dims - 1);
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y)
      {
        const float dy = float(y - place.y) * this->Step.y, dz = float(z - place.z) * this->Step.z;
        const float aside = dy * dy + dz * dz;
        if (aside >= least * least)
          continue;
        const float* row = &this->Distance[z * this->Stride[2] + y * this->Stride[1]];
        for (int x = low.x; x <= high.x; ++x)
        {
          const float other = side * row[x], dx = float(x - place.x) * this->Step.x;
          const float left = least - other, squared = dx * dx + aside;
          if (other >= 0.0F && other <= near && squared < left * left) // roots are dear
            least = std::min(least, other + std::sqrt(squared));
        }
      }
    return side * least;
  }

  /// Voxels that differ too much from a neighbour, in raster order.
  std::vector<std::int64_t> FindSteep() const
  {
    return this->Find([&](std::int64_t row, int y, int z) { return this->SteepRow(row, y, z); },
      [&](std::int64_t v) { return this->Steep(v); });
  }

  /// Voxels that are wrong, of rows that have any, in raster order.
  template <typename AnyWrong, typename Wrong>
  std::vector<std::int64_t> Find(const AnyWrong& any, const Wrong& wrong) const
  {
    std::vector<std::int64_t> found;
    std::mutex mutex;
    this->OverRows(
      [&](std::int64_t row, int y, int z)
      {
        std::vector<std::int64_t> here;
        if (any(row, y, z))
          for (std::int64_t v = row; v < row + this->Dims.x; ++v)
            if (wrong(v))
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
  glm::vec3 Step, PerStep;
  std::int64_t Stride[3];
  std::vector<float>& Distance;
};

} // namespace

void BoundByCrossings(
  const GridGeometry& geometry, std::span<const float> values, std::vector<float>& distance)
{
  Bounds(geometry, distance).ByCrossings(values);
}

bool BoundByNearVoxels(
  const GridGeometry& geometry, float near, float far, std::vector<float>& distance)
{
  return Bounds(geometry, distance).ByNearVoxels(near, far);
}

void BoundByNeighbours(const GridGeometry& geometry, float least, std::vector<float>& distance)
{
  Bounds(geometry, distance).ByNeighbours(least);
}

} // namespace hasp
