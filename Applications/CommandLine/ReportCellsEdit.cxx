// A box of the volume is carved and restored in turn: cells brought up to date against cells made
// anew.
#include "ReportCellsParts.h"

#include "CellChecks.h"
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/ActiveCells.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

/// First and last sample of a box of 1% of the volume around a place on the surface.
struct EditBox
{
  glm::ivec3 low, high;
};

EditBox BoxAround(const glm::ivec3& cell, const glm::ivec3& dims)
{
  const glm::ivec3 size = glm::max(glm::ivec3(glm::dvec3(dims) * std::cbrt(0.01)), 1);
  const glm::ivec3 low = glm::clamp(cell - size / 2, glm::ivec3(0), dims - size);
  return { low, low + size - 1 };
}

/// A volume of our own with a ball that comes and goes, as large as its box.
template <typename T>
class Sculpture
{
public:
  Sculpture(const GridView<const T>& grid, const EditBox& box, double isovalue)
    : Samples(grid.data, grid.data + grid.geometry.Size()),
      View{ this->Samples.data(), grid.geometry },
      Box(box)
  {
    const glm::dvec3 middle = 0.5 * glm::dvec3(box.low + box.high);
    const glm::dvec3 radius = glm::dvec3(box.high - box.low) * 0.5 + 0.5;
    const double step = std::max(1.0, 0.05 * std::abs(isovalue)); // grey levels a sample of depth
    for (int k = box.low.z; k <= box.high.z; ++k)
      for (int j = box.low.y; j <= box.high.y; ++j)
        for (int i = box.low.x; i <= box.high.x; ++i)
        {
          const T old = this->View(i, j, k);
          const double depth =
            (1.0 - glm::length((glm::dvec3(i, j, k) - middle) / radius)) * radius.x;
          this->Other.push_back(
            depth > 0.0 ? T(std::min(double(old), std::max(0.0, isovalue - step * depth))) : old);
        }
  }

  /// Carves what is whole, restores what is carved.
  void Toggle()
  {
    std::size_t n = 0;
    for (int k = this->Box.low.z; k <= this->Box.high.z; ++k)
      for (int j = this->Box.low.y; j <= this->Box.high.y; ++j)
        for (int i = this->Box.low.x; i <= this->Box.high.x; ++i)
          std::swap(this->Samples[this->View.Offset(i, j, k)], this->Other[n++]);
  }
  AnyGridView Grid() const { return this->View; }

private:
  std::vector<T> Samples, Other;
  GridView<const T> View;
  EditBox Box;
};

template <typename T>
void Compare(ReportContext& context, const CellScene& scene, const GridView<const T>& grid,
  CellPrecision precision)
{
  MinMaxBlocks blocks{ AnyGridView(grid) };
  ClusteredCells cells = ExtractActiveCells(grid, blocks, scene.isovalue, precision);
  const bool compact = precision == CellPrecision::Compact;
  const std::string id = (compact ? "cells.edit.compact" : "cells.edit") + scene.tag;
  if (cells.Count() == 0)
    return context.report.rows.push_back(
      AbsentRow(id, "our own full extraction", "the volume has no surface to edit"));
  const EditBox box = BoxAround(cells.Cell(cells.Count() / 2), grid.geometry.dims);
  Sculpture<T> sculpture(grid, box, scene.isovalue);
  ClusteredCells anew;
  std::size_t different = 0;
  const PairedTimes times = ComparePairs(
    [&]
    {
      sculpture.Toggle();
      return TimeOf([&] { UpdateActiveCells(cells, sculpture.Grid(), blocks, box.low, box.high); });
    },
    [&]
    {
      anew = {};
      const Timing time = TimeOf(
        [&]
        {
          anew = ExtractActiveCells(
            sculpture.Grid(), MinMaxBlocks(sculpture.Grid()), scene.isovalue, precision);
        });
      different = std::max(different, DifferentBytes(cells, anew)); // carved and whole
      return time;
    });
  context.report.rows.push_back(TimedRatio(id, times, "our own full extraction, blocks included",
    { double(different), "bytes that differ from it" },
    scene.data + ", a box of 1% of the volume carved and restored"));
}

} // namespace

void ReportCellEdits(ReportContext& context, const CellScene& scene)
{
  context.progress(0.0, "cells: edits on " + scene.data);
  const AnyGridView grid = ViewImage(scene.image);
  for (const CellPrecision precision : { CellPrecision::Exact, CellPrecision::Compact })
    std::visit([&](const auto& view) { Compare(context, scene, view, precision); }, grid);
}

} // namespace hasp
