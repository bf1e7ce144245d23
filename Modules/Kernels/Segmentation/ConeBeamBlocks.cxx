#include "Segmentation/ConeBeamBlocks.h"

namespace hasp
{

BlockGrid MakeBlocks(const GridGeometry& geometry, double edgeMm)
{
  constexpr std::size_t most = 32768;
  BlockGrid grid;
  grid.dims = geometry.dims;
  for (;; edgeMm *= 1.25)
  {
    for (int a = 0; a < 3; ++a)
    {
      const double wanted = std::round(edgeMm / geometry.spacing[a]);
      grid.voxels[a] = static_cast<int>(std::clamp(wanted, 1.0, double(geometry.dims[a])));
      grid.count[a] = (geometry.dims[a] + grid.voxels[a] - 1) / grid.voxels[a];
    }
    grid.edgeMm = geometry.spacing * glm::dvec3(grid.voxels);
    if (grid.Size() <= most)
      return grid;
  }
}

BlockField::BlockField(const BlockGrid& grid, std::vector<double> values)
  : Grid(grid),
    Values(std::move(values))
{
  for (int i = 0; i < grid.dims.x; ++i)
    this->Columns.push_back(this->Along(0, grid.Place(0, i)));
}

BlockField::Between BlockField::Along(int axis, double place) const
{
  if (this->Grid.count[axis] == 1)
    return { 0, 0.0 };
  const int below = std::clamp(static_cast<int>(std::floor(place)), 0, this->Grid.count[axis] - 2);
  return { below, place - below };
}

double BlockField::At(const glm::dvec3& place) const
{
  double sum = 0.0;
  const Between x = this->Along(0, place.x), y = this->Along(1, place.y),
                z = this->Along(2, place.z);
  for (int c = 0; c < 8; ++c)
  {
    const glm::ivec3 up(c & 1, c >> 1 & 1, c >> 2);
    const double weight = (up.x ? x.share : 1.0 - x.share) * (up.y ? y.share : 1.0 - y.share) *
                          (up.z ? z.share : 1.0 - z.share);
    if (weight != 0.0) // there is no other block along an axis of one
      sum += weight * this->Values[this->Grid.Offset(glm::ivec3(x.below, y.below, z.below) + up)];
  }
  return sum;
}

void BlockField::Row(int j, int k, std::vector<float>& row) const
{
  const Between y = this->Along(1, this->Grid.Place(1, j)),
                z = this->Along(2, this->Grid.Place(2, k));
  std::vector<double> line(this->Grid.count.x + 1);
  for (int up = 0; up < 4; ++up)
  {
    const int above = up & 1, behind = up >> 1;
    const double weight = (above ? y.share : 1.0 - y.share) * (behind ? z.share : 1.0 - z.share);
    if (weight == 0.0)
      continue;
    const double* values =
      &this->Values[this->Grid.Offset({ 0, y.below + above, z.below + behind })];
    for (int b = 0; b < this->Grid.count.x; ++b)
      line[b] += weight * values[b];
  }
  row.resize(this->Grid.dims.x);
  for (int i = 0; i < this->Grid.dims.x; ++i)
  {
    const Between& x = this->Columns[i];
    row[i] = static_cast<float>(line[x.below] + x.share * (line[x.below + 1] - line[x.below]));
  }
}

} // namespace hasp
