#include "Haptics/BlockSurface.h"
#include "Haptics/CellTriangles.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace hasp
{
namespace
{

constexpr int Side = BlockSamples::Side, Row = BlockSamples::Row;

/// Calls visit(view): std::visit may throw.
template <typename Visit>
void OfGrid(const AnyGridView& grid, const Visit& visit) noexcept
{
  const auto maybe = [&](const auto* view)
  {
    if (view != nullptr)
      visit(*view);
  };
  maybe(std::get_if<GridView<const std::int16_t>>(&grid));
  maybe(std::get_if<GridView<const std::uint16_t>>(&grid));
  maybe(std::get_if<GridView<const std::uint8_t>>(&grid));
  maybe(std::get_if<GridView<const float>>(&grid));
}

/// The first of `count` numbers that is more than `wanted`, the last if none is: numbers ascend.
/// Without branches, which would be guessed wrong half of the time.
int FirstAbove(const float* numbers, int count, float wanted) noexcept
{
  const float* first = numbers;
  for (; count > 1; count -= count / 2)
    first += first[count / 2 - 1] <= wanted ? count / 2 : 0;
  return static_cast<int>(first - numbers);
}

} // namespace

void BlockSurface::Prefetch(const AnyGridView& grid, const glm::ivec3& block) noexcept
{
  const auto prefetch = [&]<typename T>(const GridView<const T>& view)
  {
    const glm::ivec3 first = block * Side, end = glm::min(first + Row, view.geometry.dims);
    for (int k = first.z; k < end.z; ++k)
      for (int j = first.y; j < end.y; ++j)
      {
        __builtin_prefetch(&view(first.x, j, k));
        __builtin_prefetch(&view(end.x - 1, j, k)); // the next line, maybe
      }
  };
  OfGrid(grid, prefetch);
}

void BlockSurface::Read(const AnyGridView& grid, const glm::ivec3& block) noexcept
{
  this->CellsKnown = false;
  this->CellCount = 0;
  const glm::ivec3 first = block * Side;
  const auto read = [&]<typename T>(const GridView<const T>& view)
  {
    this->Block.spacing = view.geometry.spacing;
    this->Block.samples = glm::min(first + Row, view.geometry.dims) - first;
    float none = 0.0F; // 0 times what is not finite is not a number
    for (int k = 0; k < this->Block.samples.z; ++k)
      for (int j = 0; j < this->Block.samples.y; ++j)
      {
        const T* from = &view(first.x, first.y + j, first.z + k);
        float* to = &this->Block.values[BlockSamples::IndexOf(0, j, k)];
        for (int i = 0; i < this->Block.samples.x; ++i)
          none += 0.0F * (to[i] = static_cast<float>(from[i]));
      }
    this->Finite = none == 0.0F;
  };
  OfGrid(grid, read);
}

void BlockSurface::SetIsovalue(double isovalue, double outward) noexcept
{
  this->Block.isovalue = static_cast<float>(isovalue); // as the samples are compared with it
  this->Block.outward = static_cast<float>(outward);
  this->CellsKnown = false;
  this->CellCount = 0;
}

/// One bit a sample: is it inside?
std::uint32_t BlockSurface::InsideInRow(int j, int k) const noexcept
{
  const float* row = &this->Block.values[BlockSamples::IndexOf(0, j, k)];
  const float isovalue = this->Block.isovalue;
  std::uint32_t bits = 0;
  if (this->Block.outward > 0.0F)
    for (int i = 0; i < Row; ++i) // those past the grid's end are asked by no cell
      bits |= (row[i] <= isovalue ? 1U : 0U) << i;
  else
    for (int i = 0; i < Row; ++i)
      bits |= (row[i] >= isovalue ? 1U : 0U) << i;
  return bits;
}

void BlockSurface::FindCells(const BlockKernels& kernels) noexcept
{
  this->CellsKnown = true;
  this->CellCount = 0;
  const glm::ivec3& samples = this->Block.samples;
  std::array<std::array<std::uint32_t, Row>, Row> inside{};
  for (int k = 0; k < samples.z; ++k)
    for (int j = 0; j < samples.y; ++j)
      inside[k][j] = this->InsideInRow(j, k);
  const std::uint32_t all = (1U << (samples.x - 1)) - 1U;
  const auto isFinite = [&](int number)
  {
    const auto corners = this->Block.CornersOf(BlockSamples::CellOf(number));
    return std::all_of(
      corners.begin(), corners.end(), [](double value) { return std::isfinite(value); });
  };
  for (int k = 0; k + 1 < samples.z; ++k)
    for (int j = 0; j + 1 < samples.y; ++j)
    {
      const std::uint32_t a = inside[k][j], b = inside[k][j + 1], c = inside[k + 1][j],
                          d = inside[k + 1][j + 1];
      const std::uint32_t any = a | b | c | d, each = a & b & c & d;
      std::uint32_t crossed = (any | any >> 1) & ~(each & each >> 1) & all;
      for (; crossed != 0; crossed &= crossed - 1)
      {
        const int number = (k * Side + j) * Side + std::countr_zero(crossed);
        if (this->Finite || isFinite(number))
          this->Cells[this->CellCount++] = static_cast<std::uint16_t>(number);
      }
    }
  kernels.areas(this->Block, this->Cells.data(), this->CellCount, this->Ends.data());
  float sum = 0.0F;
  for (int n = 0; n < this->CellCount; ++n)
    this->Ends[n] = sum += this->Ends[n];
}

std::uint32_t BlockSurface::Draw(
  const BlockKernels& kernels, const Shares& shares, BlockPlaces& places) const noexcept
{
  std::uint16_t cells[BlockPlaces::Count];
  float left[BlockPlaces::Count];
  std::uint8_t tetrahedra[BlockPlaces::Count];
  for (int n = 0; n < BlockPlaces::Count; ++n)
  {
    const auto wanted = static_cast<float>(shares.area[n] * this->Area());
    const int c = FirstAbove(this->Ends.data(), this->CellCount, wanted);
    cells[n] = this->Cells[c];
    left[n] = wanted - (c == 0 ? 0.0F : this->Ends[c - 1]);
  }
  kernels.pick(this->Block, cells, left, tetrahedra);
  const glm::dvec3 spacing = this->Block.spacing;
  for (int n = 0; n < BlockPlaces::Count; ++n)
  {
    const glm::ivec3 cell = BlockSamples::CellOf(cells[n]);
    double rest = left[n];
    CellTriangle chosen{};
    InTetrahedron(this->Block.CornersOf(cell), CellTetrahedra[tetrahedra[n]],
      [&](const CellTriangle& t)
      {
        chosen = t;
        rest -= AreaOf(t, spacing);
        return rest < 0.0;
      });
    const glm::dvec3 index = glm::dvec3(cell) + PointIn(chosen, shares.u[n], shares.v[n]);
    for (int axis = 0; axis < 3; ++axis)
      places.index[axis][n] = static_cast<float>(index[axis]);
  }
  return kernels.project(this->Block, places);
}

} // namespace hasp
