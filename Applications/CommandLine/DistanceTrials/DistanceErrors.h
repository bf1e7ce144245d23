#pragma once
#include "Grid/GridGeometry.h"

#include <string>
#include <vector>

namespace hasp
{

/// Errors added up: voxels (`unitMm` of a mm), and where the largest is. No number is worse than
/// any. Any thread, one at a time.
class DistanceErrors
{
public:
  explicit DistanceErrors(double unitMm) : UnitMm(unitMm), Counts(Bins + 1, 0) {}

  void Add(double errorMm, const glm::dvec3& world, const std::string& shape);
  void Add(const DistanceErrors& other);

  std::size_t Count() const { return this->Total; }
  double Rms() const; ///< voxels, as all of these; NaN if there are none
  double P99() const; ///< of their sizes; right to 0.0005, at most 4
  double Most() const { return this->Largest; }
  double Bias() const; ///< their mean: positive where distances are too large
  /// "RMS 0.002 voxel (0.0008 mm), 99th percentile 0.006 (0.0024), most 0.01 (0.004) of SHAPE at
  /// (x, y, z) mm, bias 0.001"
  std::string Text() const;

private:
  static constexpr int Bins = 8000;
  static constexpr double BinVoxels = 0.0005;

  double UnitMm;
  std::vector<std::size_t> Counts;
  std::size_t Total = 0;
  double Squares = 0.0, Sum = 0.0, Largest = 0.0;
  glm::dvec3 Where{ 0.0 };
  std::string Shape;
};

/// Where in a field the error counts.
struct ErrorRange
{
  double leastVoxels = -3.0, mostVoxels = 3.0; ///< of true distance
  int borderVoxels = 0;                        ///< so many along the grid's sides do not count
};

/// distances   mm, of each voxel of the grid
/// truth       the same (TrueDistances)
void AddErrors(const std::vector<float>& distances, const std::vector<double>& truth,
  const GridGeometry& grid, const ErrorRange& range, const std::string& shape,
  DistanceErrors& errors);

/// What a surface value = offset would be off by, as Marching Cubes draws it: true distance less
/// offset wherever the field passes the offset between two neighbours, linear between them.
/// `distanceAt` in mm.
template <typename DistanceAt>
void AddOffsetErrors(const std::vector<float>& distances, const GridGeometry& grid, double offsetMm,
  const DistanceAt& distanceAt, const std::string& shape, DistanceErrors& errors)
{
  const glm::ivec3 n = grid.dims;
  const std::size_t steps[] = { 1, std::size_t(n.x), std::size_t(n.x) * n.y };
  for (int k = 0; k < n.z; ++k)
    for (int j = 0; j < n.y; ++j)
      for (int i = 0; i < n.x; ++i)
        for (int axis = 0; axis < 3; ++axis)
        {
          const glm::ivec3 index(i, j, k);
          if (index[axis] + 1 == n[axis])
            continue;
          const std::size_t voxel = (std::size_t(k) * n.y + j) * n.x + i;
          const double a = distances[voxel] - offsetMm;
          const double b = distances[voxel + steps[axis]] - offsetMm;
          if ((a < 0.0) == (b < 0.0))
            continue;
          glm::dvec3 place(index);
          place[axis] += a / (a - b);
          const glm::dvec3 world = grid.IndexToWorld(place);
          errors.Add(distanceAt(world) - offsetMm, world, shape);
        }
}

} // namespace hasp
