#include "IsosurfaceComparison.h"

#include "ReportRegistry.h"

#include <algorithm>
#include <cstdio>

namespace hasp
{

IsosurfaceComparison::IsosurfaceComparison(ReportContext& context, const std::string& data,
  const std::string& curve, double voxelMm, const IsosurfaceView& view, SurfaceTruth truth)
  : Context(context),
    Data(data),
    CurveId("isosurface.error_time@" + curve),
    VoxelMm(voxelMm),
    View(view),
    Truth(std::move(truth)),
    Cells(MakeCellMethod(view))
{
  for (int frame = 0; frame < SettlingFrames; ++frame)
    this->Cells->Draw();
  this->Ours.error = MeasureErrors(this->View, this->Truth, this->Cells->Points());
}

void IsosurfaceComparison::Against(
  IsosurfaceMethod& rival, const std::string& method, const std::string& id)
{
  this->Context.progress(0.0, "isosurface: " + this->Data + " against " + rival.Name());
  const PairedTimes times = ComparePairs([&] { return TimeOf([&] { this->Cells->Draw(); }); },
    [&] { return TimeOf([&] { rival.Draw(); }); }, { 1, 9 });
  this->Ours.frame = times.a;
  const Measured theirs{ rival.Name(), MeasureErrors(this->View, this->Truth, rival.Points()),
    times.b };

  ReportRow row = this->Row("isosurface.frame." + id, times.ratio.median, "ratio", this->Ours);
  row.rival = rival.Name();
  row.error = this->Ours.error.rmsMm / this->VoxelMm;
  row.errorUnit = "voxel RMS";
  row.q1 = times.ratio.q1;
  row.q3 = times.ratio.q3;
  row.n = times.pairs;
  this->Context.report.rows.push_back(row);
  this->ErrorRows(theirs, id);
  this->CurvePoint(method, theirs);
}

void IsosurfaceComparison::Finish(std::size_t meshBytes)
{
  this->ErrorRows(this->Ours, "cells");
  this->CurvePoint("clustered cells", this->Ours);
  ReportRow row = this->Row(
    "isosurface.bytes.mesh", double(this->Cells->Bytes()) / meshBytes, "share", this->Ours);
  row.rival = "VTK polydata with normals, 64-bit ids, as vtkFlyingEdges3D leaves it";
  row.error = this->Ours.error.rmsMm / this->VoxelMm;
  row.errorUnit = "voxel RMS";
  this->Context.report.rows.push_back(row);

  ResourceList& unused = this->Context.report.unused;
  for (const ResourceUse& use : this->Cells->Resources())
    if (use.bytes == 0 && use.milliseconds == 0.0 &&
        std::none_of(unused.begin(), unused.end(),
          [&](const ResourceUse& known) { return known.resource == use.resource; }))
      unused.push_back(use);
}

ReportRow IsosurfaceComparison::Row(
  const std::string& id, double value, const std::string& unit, const Measured& measured) const
{
  ReportRow row;
  row.id = id + "@" + this->Data;
  row.value = value;
  row.unit = unit;
  row.better = Better::Lower;
  row.rival = measured.name;
  row.timeS = measured.frame.wallS;
  row.cpuS = measured.frame.cpuS;
  row.n = measured.error.pixels;
  row.data = this->Data + ", " + std::to_string(this->View.width) + "^2 pixels";
  return row;
}

void IsosurfaceComparison::ErrorRows(const Measured& measured, const std::string& id)
{
  const auto add = [&](const std::string& what, double mm, const std::string& where)
  {
    ReportRow row =
      this->Row("isosurface." + what + "." + id, mm / this->VoxelMm, "voxel", measured);
    row.error = row.value;
    row.errorUnit = "voxel";
    char millimetres[40];
    std::snprintf(millimetres, sizeof millimetres, ", %.5f mm", mm);
    row.data += millimetres + where;
    this->Context.report.rows.push_back(row);
  };
  add("rms", measured.error.rmsMm, "");
  add("p99", measured.error.p99Mm, "");
  add("max", measured.error.maxMm,
    " at pixel " + std::to_string(measured.error.maxX) + "," + std::to_string(measured.error.maxY));
  ReportRow missed = this->Row("isosurface.missed." + id, measured.error.missed, "share", measured);
  missed.error = measured.error.missed;
  missed.errorUnit = "share of surface pixels";
  this->Context.report.rows.push_back(missed);
}

void IsosurfaceComparison::CurvePoint(const std::string& method, const Measured& measured)
{
  const std::pair<double, double> point(1e3 * measured.frame.wallS, measured.error.rmsMm);
  for (ReportCurve& curve : this->Context.report.curves)
    if (curve.id == this->CurveId && curve.method == method)
    {
      curve.points.push_back(point);
      return;
    }
  this->Context.report.curves.push_back({ this->CurveId, method, "ms", "mm RMS", { point } });
}

} // namespace hasp
