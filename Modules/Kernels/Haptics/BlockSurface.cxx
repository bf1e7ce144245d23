#include "Haptics/BlockSurface.h"
#include "Grid/Trilinear.h"
#include "Haptics/CellTriangles.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace hasp
{

void BlockSurface::Read(const AnyGridView& grid, const glm::ivec3& block) noexcept
{
  this->CellsKnown = false;
  this->CellCount = 0;
  const glm::ivec3 first = block * Side;
  const auto read = [&]<typename T>(const GridView<const T>* view)
  {
    if (view == nullptr)
      return;
    this->Spacing = view->geometry.spacing;
    this->Samples = glm::min(first + Row, view->geometry.dims) - first;
    for (int k = 0; k < this->Samples.z; ++k)
      for (int j = 0; j < this->Samples.y; ++j)
        for (int i = 0; i < this->Samples.x; ++i)
          this->Values[SampleIndex(i, j, k)] =
            static_cast<float>((*view)(first.x + i, first.y + j, first.z + k));
  };
  read(std::get_if<GridView<const std::int16_t>>(&grid)); // std::visit may throw
  read(std::get_if<GridView<const std::uint16_t>>(&grid));
  read(std::get_if<GridView<const std::uint8_t>>(&grid));
  read(std::get_if<GridView<const float>>(&grid));
}

void BlockSurface::SetIsovalue(double isovalue, double outward) noexcept
{
  this->Isovalue = static_cast<float>(isovalue); // as the samples are compared with it
  this->Outward = outward;
  this->CellsKnown = false;
  this->CellCount = 0;
}

std::array<double, 8> BlockSurface::CornersOf(const glm::ivec3& cell) const noexcept
{
  const float* p = &this->Values[SampleIndex(cell.x, cell.y, cell.z)];
  const float* above = p + SampleIndex(0, 0, 1);
  std::array<double, 8> corners{ p[0], p[1], p[Row], p[Row + 1], above[0], above[1], above[Row],
    above[Row + 1] };
  for (double& corner : corners)
    corner = this->Outward * (corner - this->Isovalue);
  return corners;
}

/// One bit a sample: is it inside?
std::uint32_t BlockSurface::InsideInRow(int j, int k) const noexcept
{
  const float* row = &this->Values[SampleIndex(0, j, k)];
  const auto isovalue = static_cast<float>(this->Isovalue);
  std::uint32_t bits = 0;
  for (int i = 0; i < this->Samples.x; ++i)
    bits |= (this->Outward > 0.0 ? row[i] <= isovalue : row[i] >= isovalue) ? 1U << i : 0U;
  return bits;
}

void BlockSurface::FindCells() noexcept
{
  this->CellsKnown = true;
  this->CellCount = 0;
  std::array<std::array<std::uint32_t, Row>, Row> inside{};
  for (int k = 0; k < this->Samples.z; ++k)
    for (int j = 0; j < this->Samples.y; ++j)
      inside[k][j] = this->InsideInRow(j, k);
  const std::uint32_t all = (1U << (this->Samples.x - 1)) - 1U;
  float sum = 0.0F;
  for (int k = 0; k + 1 < this->Samples.z; ++k)
    for (int j = 0; j + 1 < this->Samples.y; ++j)
    {
      const std::uint32_t a = inside[k][j], b = inside[k][j + 1], c = inside[k + 1][j],
                          d = inside[k + 1][j + 1];
      const std::uint32_t any = a | b | c | d, each = a & b & c & d;
      std::uint32_t crossed = (any | any >> 1) & ~(each & each >> 1) & all;
      for (; crossed != 0; crossed &= crossed - 1)
      {
        const int i = std::countr_zero(crossed);
        const std::array<double, 8> corners = this->CornersOf({ i, j, k });
        if (!std::all_of(
              corners.begin(), corners.end(), [](double value) { return std::isfinite(value); }))
          continue;
        InCell(corners,
          [&](const CellTriangle& t)
          {
            sum += static_cast<float>(AreaOf(t, this->Spacing));
            return false;
          });
        this->Cells[this->CellCount] = static_cast<std::uint16_t>((k * Side + j) * Side + i);
        this->Ends[this->CellCount++] = sum;
      }
    }
}

bool BlockSurface::Draw(double share, double u, double v, Place& place) const noexcept
{
  if (!(this->Area() > 0.0))
    return false;
  const auto wanted = static_cast<float>(share * this->Area());
  const auto end = this->Ends.begin() + this->CellCount;
  const auto n = std::min<std::ptrdiff_t>(
    std::upper_bound(this->Ends.begin(), end, wanted) - this->Ends.begin(), this->CellCount - 1);
  const int c = this->Cells[n];
  const glm::ivec3 cell{ c % Side, c / Side % Side, c / (Side * Side) };
  double left = wanted - (n == 0 ? 0.0F : this->Ends[n - 1]);
  CellTriangle chosen{};
  InCell(this->CornersOf(cell),
    [&](const CellTriangle& t)
    {
      chosen = t;
      left -= AreaOf(t, this->Spacing);
      return left < 0.0;
    });
  place.index = glm::dvec3(cell) + PointIn(chosen, u, v);
  return this->Project(place);
}

bool BlockSurface::Project(Place& place) const noexcept
{
  const double voxel = std::min({ this->Spacing.x, this->Spacing.y, this->Spacing.z });
  const glm::dvec3 last = this->Samples - 1;
  for (int step = 0; step < 5; ++step)
  {
    const glm::ivec3 cell = glm::min(glm::ivec3(place.index), this->Samples - 2);
    const glm::dvec3 t = place.index - glm::dvec3(cell);
    const std::array<double, 8> corners = this->CornersOf(cell);
    const glm::dvec3 slope = TrilinearGradient(corners, t) / this->Spacing;
    const double squared = glm::dot(slope, slope);
    if (!(squared > 0.0 && std::isfinite(squared)))
      return false;
    const double length = std::sqrt(squared);
    const double off = TrilinearValue(corners, t) / length;
    const double move = std::clamp(off, -0.5 * voxel, 0.5 * voxel);
    place.normal = slope / length;
    place.index =
      glm::clamp(place.index - move * place.normal / this->Spacing, glm::dvec3(0.0), last);
    if (std::abs(off) < 0.02 * voxel) // the last step squared what it was off by
      return true;
  }
  return false;
}

} // namespace hasp
