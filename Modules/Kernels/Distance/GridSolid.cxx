#include "Distance/GridSolid.h"

#include "Distance/SolidShapes.h"
#include "Grid/ParallelFor.h"
#include "Grid/Trilinear.h"
#include "SolidChecks.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hasp
{

namespace
{
using Sample = ImplicitSolid::Sample;
using Box = ImplicitSolid::Box;

constexpr double SteepestMmPerMm = 3.0;
// Of most cells on the surface. Distances have 1, up to the square root of 3 in stairs, less where
// a wall is thinner than a cell, more with noise (TestGridSolid).
constexpr double LeastUsualSlope = 0.5, MostUsualSlope = 2.0;

/// How much the trilinear polynomials of cells change, mm a mm.
struct Slopes
{
  double most = 0.0; ///< infinite where a value is not finite
  std::size_t onSurface = 0, flat = 0,
              steep = 0; ///< cells of both signs, and those of unusual slope

  void Add(const Slopes& other)
  {
    this->most = std::max(this->most, other.most);
    this->onSurface += other.onSurface;
    this->flat += other.flat;
    this->steep += other.steep;
  }
};

/// The four samples of a row of cells at one x, and how much they differ along y and z.
struct Column
{
  double value[4], y, z, least, most;

  Column(const std::array<const float*, 4>& row, int i)
    : value{ row[0][i], row[1][i], row[2][i], row[3][i] },
      y(std::max(std::abs(value[1] - value[0]), std::abs(value[3] - value[2]))),
      z(std::max(std::abs(value[2] - value[0]), std::abs(value[3] - value[1]))),
      least(std::min(std::min(value[0], value[1]), std::min(value[2], value[3]))),
      most(std::max(std::max(value[0], value[1]), std::max(value[2], value[3])))
  {
  }
  double Sum() const { return value[0] + value[1] + value[2] + value[3]; }
};

/// Of a row of cells, at most: each component of a gradient is a mean of four edges'. `row`: its
/// samples at (y, z) = (0, 0), (1, 0), (0, 1), (1, 1).
Slopes SlopesOf(const std::array<const float*, 4>& row, int cells, const glm::dvec3& spacing)
{
  Slopes slopes;
  Column from(row, 0);
  double mostSquared = 0.0, sum = from.Sum();
  for (int i = 1; i <= cells; ++i)
  {
    const Column to(row, i);
    double x = 0.0;
    for (int n = 0; n < 4; ++n)
      x = std::max(x, std::abs(to.value[n] - from.value[n]));
    const glm::dvec3 slope =
      glm::dvec3(x, std::max(from.y, to.y), std::max(from.z, to.z)) / spacing;
    const double squared = glm::dot(slope, slope);
    mostSquared = std::max(mostSquared, squared);
    if (std::min(from.least, to.least) < 0.0 && std::max(from.most, to.most) >= 0.0)
    {
      ++slopes.onSurface;
      slopes.flat += squared < LeastUsualSlope * LeastUsualSlope;
      slopes.steep += squared > MostUsualSlope * MostUsualSlope;
    }
    sum += to.Sum();
    from = to;
  }
  slopes.most =
    std::isfinite(sum) ? std::sqrt(mostSquared) : std::numeric_limits<double>::infinity();
  return slopes;
}

Slopes SlopesOf(const GridView<const float>& grid)
{
  const glm::ivec3 cells = grid.geometry.Cells();
  std::vector<Slopes> layers(cells.z);
  ParallelFor(0, std::int64_t(layers.size()), 4,
    [&](std::int64_t first, std::int64_t last)
    {
      for (int k = int(first); k < last; ++k)
        for (int j = 0; j < cells.y; ++j)
          layers[k].Add(SlopesOf(
            { &grid(0, j, k), &grid(0, j + 1, k), &grid(0, j, k + 1), &grid(0, j + 1, k + 1) },
            cells.x, grid.geometry.spacing));
    });
  Slopes all;
  for (const Slopes& layer : layers)
    all.Add(layer);
  return all;
}

/// What has the slopes of no distances. Throws std::invalid_argument.
void RequireDistances(const Slopes& slopes)
{
  if (!(slopes.most <= SteepestMmPerMm))
    throw std::invalid_argument("grid solid: the values change by " + SolidNumber(slopes.most) +
                                " mm a mm; at most 3, and finite: give signed distances in mm");
  for (const bool flat : { true, false })
    if (2 * (flat ? slopes.flat : slopes.steep) > slopes.onSurface)
      throw std::invalid_argument(
        std::string("grid solid: most cells on the surface change by ") +
        (flat ? "less than 0.5" : "more than 2") +
        " mm a mm, distances by 1: give signed distances, in mm, not grey values or voxels");
}

class GridSolid : public ImplicitSolid
{
public:
  GridSolid(std::shared_ptr<const std::vector<float>> distance, const GridGeometry& geometry,
    SolidPointer border, double steepness)
    : Distance(std::move(distance)),
      Grid{ this->Distance->data(), geometry },
      Last(geometry.Cells()),
      ToIndex(glm::inverse(geometry.IndexToWorldMatrix())),
      Border(std::move(border)),
      Steep(std::max(1.0, steepness))
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    const auto [cell, local] = this->Locate(this->ToIndex * (x - this->Grid.geometry.origin));
    return Joined(TrilinearValue(CellCorners(this->Grid, cell), local), this->Border->At(x));
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    const Sample border = this->Border->SampleAt(x), nearest = this->Nearest(x);
    if (nearest.value < std::min(border.value, 0.0) - SolidTieMm)
      return this->OfBorder(border);
    Sample joined = Continued(nearest, border);
    joined.value = Joined(nearest.value, border.value);
    return joined;
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    if (face > 0)
      return this->OfBorder(this->Border->FaceAt(face - 1, x));
    return Continued(this->Nearest(x), this->Border->SampleAt(x));
  }
  std::uint32_t Faces() const noexcept override { return 1 + this->Border->Faces(); }
  Box Bounds() const noexcept override { return this->Border->Bounds(); }
  double Steepness() const noexcept override { return this->Steep; }

private:
  /// Of the value at the nearest place of the grid, and the distance to the grid's box. Beyond it
  /// the way to the solid, which lies in the box, is no shorter than by Pythagoras' theorem: the
  /// box is convex.
  static double Joined(double nearest, double border) noexcept
  {
    return border > 0.0 && nearest > 0.0 ? std::hypot(nearest, border) : std::max(nearest, border);
  }
  /// Face 0: the same without the border's faces. Beyond the border, where that is nearer than the
  /// isosurface, by the sum, so that it goes on without a jump.
  static Sample Continued(const Sample& nearest, const Sample& border) noexcept
  {
    if (!(border.value > 0.0))
      return nearest;
    if (nearest.value < -SolidTieMm)
      return { nearest.value + border.value, nearest.gradient + border.gradient, 0 };
    const double inGrid = std::max(nearest.value, 0.0), all = std::hypot(inGrid, border.value);
    return { all, (inGrid * nearest.gradient + border.value * border.gradient) / all, 0 };
  }
  /// At the nearest place of the grid; the gradient along the border where that lies on it.
  Sample Nearest(const glm::dvec3& x) const noexcept
  {
    const glm::dvec3 index = this->ToIndex * (x - this->Grid.geometry.origin);
    const auto [cell, local] = this->Locate(index);
    const auto corners = CellCorners(this->Grid, cell);
    glm::dvec3 perStep = TrilinearGradient(corners, local);
    for (int a = 0; a < 3; ++a)
      if (index[a] < 0.0 || index[a] > this->Last[a])
        perStep[a] = 0.0;
    return { TrilinearValue(corners, local), perStep * this->ToIndex, 0 };
  }
  /// The nearest place of the grid; of what is not a number its first cell.
  CellPosition Locate(const glm::dvec3& index) const noexcept
  {
    CellPosition found{};
    for (int a = 0; a < 3; ++a)
    {
      const double at = index[a] > 0.0 ? std::min(index[a], this->Last[a]) : 0.0;
      found.cell[a] = std::min(static_cast<int>(at), static_cast<int>(this->Last[a]) - 1);
      found.local[a] = at - found.cell[a];
    }
    return found;
  }
  Sample OfBorder(Sample s) const noexcept
  {
    ++s.face;
    return s;
  }

  std::shared_ptr<const std::vector<float>> Distance;
  GridView<const float> Grid;
  glm::dvec3 Last; ///< index of the last sample
  glm::dmat3 ToIndex;
  SolidPointer Border;
  double Steep;
};
} // namespace

SolidPointer MakeGridSolid(
  std::shared_ptr<const std::vector<float>> distance, const GridGeometry& geometry)
{
  geometry.Validate();
  const glm::ivec3 d = geometry.dims;
  if (std::min({ d.x, d.y, d.z }) < 2)
    throw std::invalid_argument("grid solid: " + std::to_string(d.x) + " x " + std::to_string(d.y) +
                                " x " + std::to_string(d.z) +
                                " samples; each axis needs two at least");
  if (!distance || distance->size() != geometry.Size())
    throw std::invalid_argument("grid solid: " + std::to_string(distance ? distance->size() : 0) +
                                " values for a grid of " + std::to_string(geometry.Size()) +
                                " samples; give one each");
  const Slopes slopes = SlopesOf({ distance->data(), geometry });
  RequireDistances(slopes);
  const glm::dvec3 half = 0.5 * glm::dvec3(geometry.Cells());
  SolidPointer border =
    MakeBox(geometry.IndexToWorld(half), geometry.direction, half * geometry.spacing);
  return std::make_shared<GridSolid>(std::move(distance), geometry, std::move(border), slopes.most);
}

} // namespace hasp
