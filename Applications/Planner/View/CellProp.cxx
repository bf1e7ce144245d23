#include "View/CellProp.h"

#include "Isosurface/ClusteredCells.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspPickedCell.h"

#include "vtkImageData.h"

#include <glm/common.hpp>

#include <bit>
#include <limits>

namespace hasp
{
namespace
{

/// First and last of the bits of a row of eight.
glm::ivec2 RangeOf(unsigned bits)
{
  return { std::countr_zero(bits), 31 - std::countl_zero(bits) };
}

/// First and last active cell of a cluster along each axis, of the volume's.
void Widen(const CellCluster& cluster, glm::ivec3& low, glm::ivec3& high)
{
  std::uint64_t all = 0;
  unsigned slices = 0, rows = 0, columns = 0;
  for (int z = 0; z < 8; ++z)
  {
    all |= cluster.active[z];
    slices |= unsigned(cluster.active[z] != 0) << z;
  }
  for (int y = 0; y < 8; ++y)
  {
    const unsigned row = all >> (y << 3) & 0xFF;
    columns |= row;
    rows |= unsigned(row != 0) << y;
  }
  if (all == 0)
    return;
  const glm::ivec2 x = RangeOf(columns), y = RangeOf(rows), z = RangeOf(slices);
  low = glm::min(low, cluster.Origin() + glm::ivec3(x[0], y[0], z[0]));
  high = glm::max(high, cluster.Origin() + glm::ivec3(x[1], y[1], z[1]));
}

} // namespace

bool BoundsOfCells(const ClusteredCells& cells, double bounds[6])
{
  glm::ivec3 low(std::numeric_limits<int>::max()), high(std::numeric_limits<int>::min());
  for (const CellCluster& cluster : cells.clusters)
    Widen(cluster, low, high);
  if (low.x > high.x)
    return false;
  glm::dvec3 least(std::numeric_limits<double>::infinity()), most = -least;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 at(corner & 1 ? high.x + 1 : low.x, corner & 2 ? high.y + 1 : low.y,
      corner & 4 ? high.z + 1 : low.z);
    const glm::dvec3 world = cells.geometry.IndexToWorld(glm::dvec3(at));
    least = glm::min(least, world);
    most = glm::max(most, world);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = least[axis];
    bounds[2 * axis + 1] = most[axis];
  }
  return true;
}

CellProp::CellProp(SceneView& view, vtkImageData* image, double isovalue)
  : SceneActor(view),
    Cells(vtkSmartPointer<vtkHaspClusteredCellMapper>::New())
{
  this->Cells->SetInputData(image);
  this->Cells->SetIsoValue(isovalue);
  this->Cells->ScalarVisibilityOff();
  this->SetMapper(this->Cells);
}

vtkHaspClusteredCellMapper* CellProp::Mapper() const
{
  return this->Cells;
}

vtkImageData* CellProp::Image() const
{
  return this->Cells->GetImage();
}

std::optional<SceneActor::DataHit> CellProp::First(
  const glm::dvec3& from, const glm::dvec3& to) const
{
  vtkNew<vtkHaspPickedCell> picked;
  if (!this->Cells->UpdateCells() || !this->Cells->PickFirstCell(&from.x, &to.x, picked))
    return std::nullopt;
  const double* normal = picked->GetNormal();
  return DataHit{ picked->GetT(), { normal[0], normal[1], normal[2] } };
}

bool CellProp::DataBounds(double bounds[6]) const
{
  return this->Cells->UpdateCells() && BoundsOfCells(this->Cells->GetCells(), bounds);
}

void CellProp::ListResources(ResourceList& list) const
{
  this->Cells->ListResources(list);
}

} // namespace hasp
