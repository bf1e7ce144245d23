// Extraction time, bytes and losslessness of clustered cells against a mesh.
#include "ReportCellsParts.h"

#include "CellChecks.h"
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CompactCells.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "RivalMesh.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>

namespace hasp
{
namespace
{

const char* const CompactMesh =
  "its indexed mesh: 3x16-bit positions + octahedral normals + 32-bit indices";

/// What one data set's rows are made from.
struct Measured
{
  const CellScene& scene;
  AnyGridView grid;
  ClusteredCells exact;
  PairedTimes times; ///< extraction with blocks
  MeasuredError lossless;
};

Measured MeasureExtraction(ReportContext& context, const CellScene& scene, RivalMesh& rival)
{
  const AnyGridView grid = ViewImage(scene.image);
  Measured m{ scene, grid, {}, {}, {} };
  m.times = ComparePairs(
    [&]
    {
      m.exact = {}; // freed outside the time, as is the rival's output before
      return TimeOf(
        [&] { m.exact = ExtractActiveCells(grid, MinMaxBlocks(grid), scene.isovalue); });
    },
    [&] { return TimeOf([&] { rival.Extract(scene.isovalue); }); });
  const LosslessCheck check = CheckLossless(grid, m.exact);
  m.lossless = { double(check.wrongCorners + check.activeInVolume - check.cells),
    "samples and cells that differ from the volume" };
  char rivalError[60];
  std::snprintf(rivalError, sizeof rivalError, "; its error %.4f voxel RMS", rival.ErrorRms());
  context.report.rows.push_back(TimedRatio(
    "cells.extract" + scene.tag, m.times, rival.Name() + rivalError, { 0.0, "voxel" }, scene.data));
  if (!check.Lossless()) // then the surface is not the volume's
    context.report.rows.back().error = std::max(1.0, m.lossless.value);
  return m;
}

/// The slider: another isovalue of the same volume, blocks kept.
void AddNextIsovalue(ReportContext& context, const Measured& m, RivalMesh& rival)
{
  const MinMaxBlocks blocks(m.grid);
  const double isovalue = m.scene.isovalue + 0.02 * (double(blocks.Max()) - blocks.Min());
  ClusteredCells next;
  const PairedTimes times = ComparePairs(
    [&]
    {
      next = {};
      return TimeOf([&] { next = ExtractActiveCells(m.grid, blocks, isovalue); });
    },
    [&] { return TimeOf([&] { rival.Extract(isovalue); }); });
  const LosslessCheck check = CheckLossless(m.grid, next);
  context.report.rows.push_back(TimedRatio("cells.extract.next" + m.scene.tag, times, rival.Name(),
    { check.Lossless() ? 0.0 : 1.0, "voxel" },
    m.scene.data + ", another isovalue, min-max blocks kept"));
  rival.Extract(m.scene.isovalue);
}

std::string PerCell(std::size_t bytes, std::size_t cells)
{
  char text[60];
  std::snprintf(text, sizeof text, ", %.2f bytes a cell of %zu", double(bytes) / cells, cells);
  return text;
}

void AddBytes(ReportContext& context, const Measured& m, const RivalMesh& mesh)
{
  const std::size_t bytes = m.exact.Bytes();
  const std::string data = m.scene.data + PerCell(bytes, std::max<std::size_t>(m.exact.Count(), 1));
  const auto add = [&](const std::string& id, std::size_t rival, const std::string& name)
  {
    context.report.rows.push_back(FixedFigure("cells.bytes." + id + m.scene.tag,
      double(bytes) / rival, "ratio", name, m.lossless, m.times, data));
  };
  const std::size_t cells = m.exact.Count();
  add("exact", mesh.CompactBytes(), CompactMesh + PerCell(mesh.CompactBytes(), cells));
  add("exact.float", mesh.PlainBytes(),
    "float positions and normals + 32-bit indices" + PerCell(mesh.PlainBytes(), cells));
  add("exact.vtk", mesh.VtkBytes(),
    "vtkPolyData with normals, 64-bit ids" + PerCell(mesh.VtkBytes(), cells));
}

void AddCompact(ReportContext& context, const Measured& m, const RivalMesh& mesh)
{
  ClusteredCells compact;
  const PairedTimes times = ComparePairs(
    [&]
    {
      compact = {};
      return TimeOf([&] { compact = CompactCells(m.exact); });
    },
    [&] {
      return TimeOf([&] { ExtractActiveCells(m.grid, MinMaxBlocks(m.grid), m.scene.isovalue); });
    });
  const CompactShift shift = MeasureShift(m.grid, compact);
  const MeasuredError error{ shift.rms, "voxel RMS" };
  const std::string data = m.scene.data + PerCell(compact.Bytes(), m.exact.Count());
  std::vector<ReportRow>& rows = context.report.rows;
  rows.push_back(FixedFigure("cells.bytes.compact" + m.scene.tag,
    double(compact.Bytes()) / mesh.CompactBytes(), "ratio", CompactMesh, error, times, data));
  const std::string edges = m.scene.data + ", " + std::to_string(shift.edges) + " edge crossings";
  const auto figure = [&](const std::string& id, double value, const std::string& unit)
  {
    rows.push_back(FixedFigure("cells.compact." + id + m.scene.tag, value, unit,
      "the exact trilinear surface", error, times, edges));
  };
  figure("rms", shift.rms, "voxel");
  figure("p999", shift.p999, "voxel");
  figure("max", shift.max, "voxel");
  figure("changed", double(shift.changedCells), "cells with another sign pattern");
  rows.push_back(TimedRatio("cells.compact.time" + m.scene.tag, times, "our own exact extraction",
    error, m.scene.data + ", from exact cells"));
}

} // namespace

CellSize ReportCellBytes(ReportContext& context, const CellScene& scene)
{
  context.progress(0.0, "cells: extraction and bytes on " + scene.data);
  RivalMesh mesh(scene);
  const Measured m = MeasureExtraction(context, scene, mesh);
  AddNextIsovalue(context, m, mesh);
  AddBytes(context, m, mesh);
  AddCompact(context, m, mesh);
  return { double(m.exact.Bytes()), m.times.a.cpuS };
}

} // namespace hasp
