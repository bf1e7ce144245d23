#include "Grid/MinMaxBlocks.h"
#include "Grid/ParallelFor.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace hasp
{

namespace
{

constexpr float Infinity = std::numeric_limits<float>::infinity();

/// Smallest and largest sample of each column of a bundle of rows; the loop runs along x, so that
/// the compiler can use whole vectors.
template <typename T>
class ColumnRanges
{
public:
  explicit ColumnRanges(int columns) : Min(columns), Max(columns) {}

  void Clear()
  {
    constexpr bool isFloat = std::is_same_v<T, float>;
    std::fill(
      this->Min.begin(), this->Min.end(), isFloat ? T(Infinity) : std::numeric_limits<T>::max());
    std::fill(this->Max.begin(), this->Max.end(),
      isFloat ? T(-Infinity) : std::numeric_limits<T>::lowest());
  }
  void Add(const T* row)
  {
    const std::size_t count = this->Min.size();
    T *min = this->Min.data(), *max = this->Max.data();
    for (std::size_t i = 0; i < count; ++i)
    {
      min[i] = row[i] < min[i] ? row[i] : min[i]; // false for NaN
      max[i] = row[i] > max[i] ? row[i] : max[i];
    }
  }
  std::pair<float, float> Over(int first, int last) const
  {
    T min = this->Min[first], max = this->Max[first];
    for (int i = first + 1; i <= last; ++i)
    {
      min = this->Min[i] < min ? this->Min[i] : min;
      max = this->Max[i] > max ? this->Max[i] : max;
    }
    return { static_cast<float>(min), static_cast<float>(max) };
  }

private:
  std::vector<T> Min, Max;
};

} // namespace

MinMaxBlocks::MinMaxBlocks(const AnyGridView& grid)
{
  const GridGeometry& geometry = GeometryOf(grid);
  geometry.Validate();
  this->BlockCount = (geometry.Cells() + Side - 1) / Side;
  const glm::ivec3 n = this->BlockCount;
  this->Ranges.resize(static_cast<std::size_t>(n.x) * n.y * n.z);
  this->ReadAll(grid, glm::ivec3(0), n);
}

void MinMaxBlocks::ReadAll(const AnyGridView& grid, const glm::ivec3& from, const glm::ivec3& to)
{
  ParallelFor(from.z, to.z, 1,
    [&](std::int64_t z, std::int64_t) {
      this->Read(grid, { from.x, from.y, int(z) }, { to.x, to.y, int(z) + 1 });
    });
}

void MinMaxBlocks::Update(const AnyGridView& grid, const glm::ivec3& low, const glm::ivec3& high)
{
  if (this->BlockCount != (GeometryOf(grid).Cells() + Side - 1) / Side)
    throw std::invalid_argument("MinMaxBlocks: they are of a grid of another size");
  const auto touched = this->Touched(low, high);
  if (touched.first != touched.second)
    this->ReadAll(grid, touched.first, touched.second);
}

std::pair<glm::ivec3, glm::ivec3> MinMaxBlocks::Touched(
  const glm::ivec3& low, const glm::ivec3& high) const
{
  const glm::ivec3 from = (glm::max(low, 1) - 1) / Side; // sample 8 is the last of block 0, too
  const glm::ivec3 to = glm::min(glm::max(high, -Side) / Side + 1, this->BlockCount);
  const bool none = glm::any(glm::greaterThanEqual(from, to));
  return none ? std::pair(from, from) : std::pair(from, to);
}

void MinMaxBlocks::Read(const AnyGridView& grid, const glm::ivec3& from, const glm::ivec3& to)
{
  const auto read = [&]<typename T>(const GridView<const T>& view)
  {
    const glm::ivec3 dims = view.geometry.dims;
    const int firstColumn = from.x * Side, lastColumn = std::min(to.x * Side, dims.x - 1);
    ColumnRanges<T> columns(lastColumn - firstColumn + 1);
    for (int z = from.z; z < to.z; ++z)
      for (int y = from.y; y < to.y; ++y)
      {
        columns.Clear();
        for (int k = z * Side; k <= std::min(z * Side + Side, dims.z - 1); ++k)
          for (int j = y * Side; j <= std::min(y * Side + Side, dims.y - 1); ++j)
            columns.Add(&view(firstColumn, j, k));
        for (int x = from.x; x < to.x; ++x)
        {
          const int first = (x - from.x) * Side;
          const auto [min, max] =
            columns.Over(first, std::min(first + Side, lastColumn - firstColumn));
          this->Ranges[this->Index({ x, y, z })] = { min, max };
        }
      }
  };
  std::visit(read, grid);
}

float MinMaxBlocks::Min() const
{
  float min = Infinity;
  for (const Range& range : this->Ranges)
    min = std::min(min, range.min);
  return min;
}

float MinMaxBlocks::Max() const
{
  float max = -Infinity;
  for (const Range& range : this->Ranges)
    max = std::max(max, range.max);
  return max;
}

} // namespace hasp
