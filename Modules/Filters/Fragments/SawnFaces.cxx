#include "SawnFaces.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace hasp
{

namespace
{

/// A sawn box on a grid.
class BoxOnGrid
{
public:
  BoxOnGrid(const SawnBox& box, const GridGeometry& grid) : Box(box), Grid(grid)
  {
    const glm::dvec3 steps = glm::transpose(grid.IndexToWorldMatrix()) * box.axes[2];
    this->Reach = std::abs(steps.x) + std::abs(steps.y) + std::abs(steps.z);
  }
  /// How far a cell reaches across the faces, mm: the distances of its corners differ by no more.
  double CellReach() const { return this->Reach; }
  glm::dvec3 Local(const glm::ivec3& at) const
  {
    return glm::transpose(this->Box.axes) *
           (this->Grid.IndexToWorld(glm::dvec3(at)) - this->Box.middle);
  }
  /// mm, NEGATIVE INSIDE.
  double Distance(const glm::dvec3& local) const
  {
    const glm::dvec3 beyond = glm::abs(local) - this->Box.half;
    return glm::length(glm::max(beyond, 0.0)) +
           std::min(std::max({ beyond.x, beyond.y, beyond.z }), 0.0);
  }
  /// The first and the last sample of the grid that may be within the reach of the box.
  std::pair<glm::ivec3, glm::ivec3> Samples() const
  {
    glm::dvec3 low(1e9), high(-1e9);
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      const glm::dvec3 index = this->Grid.WorldToIndex(
        this->Box.middle + this->Box.axes * (signs * (this->Box.half + this->Reach)));
      low = glm::min(low, index);
      high = glm::max(high, index);
    }
    return { glm::max(glm::ivec3(glm::floor(glm::clamp(low, -1.0, 1e6))), 0),
      glm::min(glm::ivec3(glm::ceil(glm::clamp(high, -2.0, 1e6))), this->Grid.dims - 1) };
  }

private:
  const SawnBox& Box;
  const GridGeometry& Grid;
  double Reach = 0.0;
};

/// The grey values and labels of a scan that is cut by a box.
template <typename T>
class SawnScan
{
public:
  SawnScan(const GridView<const T>& grey, const GridView<const std::uint16_t>& labels,
    const SawnImage& where)
    : Grey(grey),
      Labels(labels),
      Where(where),
      Box(where.box, grey.geometry)
  {
  }
  const BoxOnGrid& OnGrid() const { return this->Box; }
  bool IsOwn(const glm::ivec3& at) const
  {
    return this->Labels(at.x, at.y, at.z) == this->Where.label;
  }

  /// Of a sample of the label beside the box: the contrast to be faced with there, which is the
  /// most that the label has around; 0 unless there is bone beside it that has another label or
  /// none, in the box or beyond it.
  double ContrastBesideLoss(const glm::ivec3& at, double across) const
  {
    bool loss = false;
    double contrast = 0.0;
    this->EachNeighbour(at,
      [&](const glm::ivec3& other, double value)
      {
        const double there = this->Box.Local(other).z;
        if (this->IsOwn(other))
          contrast = std::max(contrast, value);
        else
          loss =
            loss || std::abs(there) <= this->Where.box.half.z || (there > 0.0) != (across > 0.0);
      });
    return loss ? contrast : 0.0;
  }
  /// Of bone that has another label or none: how far it lies behind the face that the label ends at
  /// beside it, mm, and that contrast. Infinity: it lies behind none.
  std::pair<double, double> BehindFace(const glm::ivec3& at, double across) const
  {
    const double half = this->Where.box.half.z;
    double least = std::numeric_limits<double>::infinity(), contrast = 0.0;
    this->EachNeighbour(at,
      [&](const glm::ivec3& other, double value)
      {
        const double there = this->Box.Local(other).z;
        const double behind = there > 0.0 ? half - across : half + across;
        if (!this->IsOwn(other) || std::abs(there) < half || behind < 0.0)
          return;
        least = std::min(least, behind);
        contrast = std::max(contrast, value);
      });
    return { least, contrast };
  }

private:
  /// Those of 26, and itself, that are bone, with how much: value - isovalue.
  template <typename Visit>
  void EachNeighbour(const glm::ivec3& at, const Visit& visit) const
  {
    const glm::ivec3 low = glm::max(at - 1, 0);
    const glm::ivec3 high = glm::min(at + 1, this->Grey.geometry.dims - 1);
    for (int k = low.z; k <= high.z; ++k)
      for (int j = low.y; j <= high.y; ++j)
        for (int i = low.x; i <= high.x; ++i)
          if (const double bone = double(this->Grey(i, j, k)) - this->Where.isovalue; bone >= 0.0)
            visit(glm::ivec3(i, j, k), bone);
  }

  const GridView<const T>& Grey;
  const GridView<const std::uint16_t>& Labels;
  const SawnImage& Where;
  BoxOnGrid Box;
};

} // namespace

template <typename Sample, typename T>
void FlattenFaces(const GridView<Sample>& image, const GridView<const T>& grey,
  const GridView<const std::uint16_t>& labels, const SawnImage& where)
{
  const SawnScan scan(grey, labels, where);
  const BoxOnGrid& box = scan.OnGrid();
  const GreySide<Sample> side(where.isovalue);
  const double reach = box.CellReach();
  auto [first, last] = box.Samples();
  first = glm::max(first, where.first);
  last = glm::min(last, where.first + image.geometry.dims - 1);
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i)
      {
        const auto value = Sample(grey(i, j, k));
        const glm::dvec3 local = box.Local({ i, j, k });
        const double distance = box.Distance(local);
        if (distance >= reach || !side.IsInside(double(value)))
          continue;
        Sample& is = image(i - where.first.x, j - where.first.y, k - where.first.z);
        if (scan.IsOwn({ i, j, k }))
        {
          const double contrast =
            distance >= 0.0 ? scan.ContrastBesideLoss({ i, j, k }, local.z) : 0.0;
          if (contrast > 0.0)
            is = std::min(is, side.Inside(value, distance / reach * contrast));
        }
        else if (const auto [behind, contrast] = scan.BehindFace({ i, j, k }, local.z);
                 behind < reach)
          is = std::max(is, side.Below(where.isovalue - behind / reach * contrast));
      }
}

template void FlattenFaces(const GridView<std::int16_t>&, const GridView<const std::int16_t>&,
  const GridView<const std::uint16_t>&, const SawnImage&);
template void FlattenFaces(const GridView<std::int16_t>&, const GridView<const std::uint8_t>&,
  const GridView<const std::uint16_t>&, const SawnImage&);
template void FlattenFaces(const GridView<float>&, const GridView<const std::uint16_t>&,
  const GridView<const std::uint16_t>&, const SawnImage&);
template void FlattenFaces(const GridView<float>&, const GridView<const float>&,
  const GridView<const std::uint16_t>&, const SawnImage&);

} // namespace hasp
