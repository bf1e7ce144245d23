// Picks of vtkHaspClusteredCellMapper.
#include "ClusteredCellAttributes.h"

#include "Isosurface/CellHits.h"
#include "vtkHaspPickedCell.h"
#include "vtkHaspVolumeView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkScalarsToColors.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

/// The line, in index coordinates of the cells, as a label's pose has it.
struct PosedLine
{
  glm::dmat4 dataToCells{ 1.0 };
  glm::dvec3 from, to;
  PosedLine(const hasp::GridGeometry& geometry, const std::optional<glm::dmat4>& pose,
    const double start[3], const double end[3])
  {
    if (pose)
      this->dataToCells = glm::inverse(*pose);
    const auto place = [&](const double p[3])
    {
      return geometry.WorldToIndex(
        glm::dvec3(this->dataToCells * glm::dvec4(p[0], p[1], p[2], 1.0)));
    };
    this->from = place(start);
    this->to = place(end);
  }
};

/// The array at a point of the cell: the component, or the length, that the lookup table looks at.
double Interpolate(vtkDataArray* array, vtkScalarsToColors* table, int component,
  const glm::ivec3& dims, const glm::ivec3& cell, const glm::dvec3& in)
{
  const int components = array->GetNumberOfComponents();
  std::vector<double> sum(components, 0.0), tuple(components);
  for (int c = 0; c < 8; ++c)
  {
    const glm::ivec3 step(c & 1, c >> 1 & 1, c >> 2), at = cell + step;
    const glm::dvec3 share = glm::mix(1.0 - in, in, glm::dvec3(step));
    array->GetTuple((vtkIdType{ at.z } * dims.y + at.y) * dims.x + at.x, tuple.data());
    for (int n = 0; n < components; ++n)
      sum[n] += share.x * share.y * share.z * tuple[n];
  }
  if (components == 1)
    return sum[0];
  if (component < 0 && table) // none was chosen in the mapper
    component = table->GetVectorComponent();
  if (!table || table->GetVectorMode() != vtkScalarsToColors::MAGNITUDE)
    return sum[std::clamp(component, 0, components - 1)];
  double squares = 0.0;
  for (const double value : sum)
    squares += value * value;
  return std::sqrt(squares);
}

} // namespace

void vtkHaspClusteredCellMapper::Tell(const hasp::LineHit& hit, vtkHaspPickedCell* result) const
{
  const hasp::ClusteredCells& cells = this->GetCells();
  const hasp::CellLabel* label = this->LabelOfCell(hit.cell);
  const glm::dmat4 pose = label && label->pose ? *label->pose : glm::dmat4(1.0);
  const glm::ivec3 cell = cells.Cell(hit.cell);
  result->CellId = static_cast<vtkIdType>(hit.cell);
  result->T = hit.t;
  result->Label = cells.labels.empty() ? 0 : cells.labels[hit.cell];
  result->Value = cells.isovalue;
  if (auto* array = vtkDataArray::SafeDownCast(this->Attribute->ColorArray))
    result->Value = Interpolate(array, this->LookupTable, this->ArrayComponent, cells.geometry.dims,
      cell, hit.index - glm::dvec3(cell));
  const glm::dvec3 position(pose * glm::dvec4(cells.geometry.IndexToWorld(hit.index), 1.0));
  const glm::dvec3 normal =
    -glm::normalize(glm::dmat3(pose) * cells.geometry.GradientToWorld(hit.gradient));
  for (int a = 0; a < 3; ++a)
  {
    result->IJK[a] = cell[a];
    result->PCoords[a] = std::clamp(hit.index[a] - cell[a], 0.0, 1.0);
    result->Position[a] = position[a];
    result->Normal[a] = normal[a];
  }
  result->Modified();
}

const hasp::CellLabel* vtkHaspClusteredCellMapper::LabelOfCell(std::size_t cell) const
{
  const hasp::ClusteredCells& cells = this->GetCells();
  if (cells.labels.empty())
    return nullptr;
  const auto found = this->Attribute->Labels.find(cells.labels[cell]);
  return found != this->Attribute->Labels.end() ? &found->second : nullptr;
}

bool vtkHaspClusteredCellMapper::GetCellIndex(vtkIdType cellId, int ijk[3]) const
{
  const hasp::ClusteredCells& cells = this->GetCells();
  if (cellId < 0 || static_cast<std::size_t>(cellId) >= cells.Count())
    return false;
  const glm::ivec3 cell = cells.Cell(static_cast<std::size_t>(cellId));
  for (int a = 0; a < 3; ++a)
    ijk[a] = cell[a];
  return true;
}

bool vtkHaspClusteredCellMapper::PickCell(
  vtkIdType cellId, const double from[3], const double to[3], vtkHaspPickedCell* result) const
{
  const hasp::ClusteredCells& cells = this->GetCells();
  if (cellId < 0 || static_cast<std::size_t>(cellId) >= cells.Count())
    return false;
  const auto n = static_cast<std::size_t>(cellId);
  const hasp::CellLabel* label = this->LabelOfCell(n);
  const PosedLine line(cells.geometry, label ? label->pose : std::nullopt, from, to);
  const auto hit = hasp::HitCell(cells, n, line.from, line.to);
  if (hit && result)
    this->Tell(*hit, result);
  return hit.has_value();
}

bool vtkHaspClusteredCellMapper::PickFirstCell(
  const double from[3], const double to[3], vtkHaspPickedCell* result) const
{
  const hasp::ClusteredCells& cells = this->GetCells();
  std::optional<hasp::LineHit> first;
  // The cells that stay where they are, then those of each label with a pose.
  const auto meet = [&](const std::optional<glm::dmat4>& pose, const hasp::CellLabel* only)
  {
    const PosedLine line(cells.geometry, pose, from, to);
    const auto counts = [&](std::size_t n)
    {
      const hasp::CellLabel* label = this->LabelOfCell(n);
      return only ? label == only : !label || (label->visible && !label->pose);
    };
    const auto hit = hasp::FirstHit(cells, line.from, line.to, counts);
    if (hit && (!first || hit->t < first->t))
      first = hit;
  };
  meet({}, nullptr);
  if (!cells.labels.empty())
    for (const auto& [n, label] : this->Attribute->Labels)
      if (label.visible && label.pose)
        meet(label.pose, &label);
  if (first && result)
    this->Tell(*first, result);
  return first.has_value();
}
