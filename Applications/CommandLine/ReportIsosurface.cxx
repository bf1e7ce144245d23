#include "ReportIsosurface.h"

#include "Grid/AnalyticVolumes.h"
#include "Grid/MinMaxBlocks.h"
#include "Isosurface/RayCaster.h"
#include "IsosurfaceMethods.h"
#include "Pairing.h"
#include "ReportRegistry.h"
#include "SurfaceErrors.h"
#include "Windows.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>

namespace hasp
{
namespace
{

/// A volume whose surface is known in closed form, as int16 samples.
struct Case
{
  AnalyticVolume shape;
  GridGeometry geometry;
  std::string name; ///< "gyroid256"
};

Case MakeCase(const std::string& shape, int dims)
{
  // 64 mm across whatever the number of samples: only the voxel changes.
  const double voxel = 64.0 / (dims - 1);
  const GridGeometry geometry{ glm::ivec3(dims), glm::dvec3(-32.0), glm::dvec3(voxel),
    glm::dmat3(1) };
  return { shape == "gyroid" ? AnalyticGyroid(16.0) : AnalyticSphere({ 0.1, -0.2, 0.3 }, 28.0),
    geometry, shape + std::to_string(dims) };
}

/// The first surface inside the volume's box; a ray that starts inside the solid meets its far
/// side.
std::optional<TrueHit> FirstInBox(
  const Case& c, const glm::dvec3& origin, const glm::dvec3& direction)
{
  double t0 = 0.0, t1 = 1e9;
  const glm::dvec3 high = c.geometry.IndexToWorld(glm::dvec3(c.geometry.dims - 1));
  for (int a = 0; a < 3; ++a)
  {
    const double u = (c.geometry.origin[a] - origin[a]) / direction[a];
    const double v = (high[a] - origin[a]) / direction[a];
    t0 = std::max(t0, std::min(u, v));
    t1 = std::min(t1, std::max(u, v));
  }
  if (!(t0 < t1))
    return std::nullopt;
  AnalyticVolume seen = c.shape;
  if (c.shape.value(origin + t0 * direction) > 0.0)
    seen.value = [&](const glm::dvec3& p) { return -c.shape.value(p); };
  const auto t = FirstSurface(seen, origin, direction, t0, t1);
  if (!t)
    return std::nullopt;
  const glm::dvec3 p = origin + *t * direction;
  constexpr double h = 1e-5;
  glm::dvec3 gradient;
  for (int a = 0; a < 3; ++a)
  {
    glm::dvec3 step(0.0);
    step[a] = h;
    gradient[a] = c.shape.value(p + step) - c.shape.value(p - step);
  }
  return TrueHit{ p, std::abs(glm::dot(glm::normalize(gradient), direction)) };
}

/// A method with its error and the time of one frame.
struct Measured
{
  std::string name;
  SurfaceErrors error;
  Timing frame;
  std::size_t bytes = 0;
};

class Runner
{
public:
  Runner(ReportContext& context, const Case& c)
    : Context(context),
      Data(c.name),
      Voxel(c.geometry.spacing.x),
      View(MakeImage(c.geometry, SampleAnalytic<std::int16_t>(c.shape, c.geometry, 1000.0, 0.0)),
        0.0, context.settings.quick ? 200 : 512, context.settings.quick ? 200 : 512,
        glm::normalize(glm::dvec3(-0.6, 1.0, -0.4))),
      Truth(TraceTruth(
        View, [&](const glm::dvec3& o, const glm::dvec3& d) { return FirstInBox(c, o, d); })),
      Cells(MakeCellMethod(View))
  {
    this->Ours.name = this->Cells->Name();
    this->Cells->Draw();
    this->Ours.error = MeasureErrors(this->View, this->Truth, this->Cells->Points());
    this->Ours.bytes = this->Cells->Bytes();
  }

  /// Frames in turn with the clustered cells; rows, and a point on the rival's curve.
  void Against(IsosurfaceMethod& rival, const std::string& method, const std::string& id)
  {
    this->Context.progress(0.0, "isosurface: " + this->Data + " against " + rival.Name());
    const PairedTimes times = ComparePairs([&] { return TimeOf([&] { this->Cells->Draw(); }); },
      [&] { return TimeOf([&] { rival.Draw(); }); }, { 1, 9 });
    this->Ours.frame = times.a;
    const Measured theirs{ rival.Name(), MeasureErrors(this->View, this->Truth, rival.Points()),
      times.b, rival.Bytes() };

    ReportRow row = this->Row("isosurface.frame." + id, times.ratio.median, "ratio", rival.Name());
    row.q1 = times.ratio.q1;
    row.q3 = times.ratio.q3;
    row.n = times.pairs;
    this->Context.report.rows.push_back(row);
    this->ErrorRows(theirs, method, id);
    this->Curve(method, theirs);
  }

  /// Once all rivals have run: our own errors, and bytes against the mesh.
  void Finish(std::size_t meshBytes)
  {
    this->ErrorRows(this->Ours, "clustered cells", "cells");
    this->Curve("clustered cells", this->Ours);
    if (meshBytes > 0)
    {
      ReportRow row = this->Row("isosurface.bytes.mesh", double(this->Ours.bytes) / meshBytes,
        "share", "VTK polydata with normals, 64-bit ids, as vtkFlyingEdges3D leaves it");
      this->Context.report.rows.push_back(row);
    }
    for (const ResourceUse& use : this->Cells->Resources())
      if (use.bytes == 0 && use.milliseconds == 0.0)
        this->Unused(use);
  }
  const IsosurfaceView& GetView() const { return this->View; }

private:
  std::string Where() const
  {
    return this->Data + ", int16, " + std::to_string(this->View.width) + "^2 pixels";
  }
  ReportRow Row(
    const std::string& id, double value, const std::string& unit, const std::string& rival) const
  {
    ReportRow row;
    row.id = id + "@" + this->Data;
    row.value = value;
    row.unit = unit;
    row.rival = rival;
    row.error = this->Ours.error.rmsMm / this->Voxel;
    row.errorUnit = "voxel RMS";
    row.timeS = this->Ours.frame.wallS;
    row.cpuS = this->Ours.frame.cpuS;
    row.data = this->Where();
    return row;
  }
  /// RMS, 99th percentile, maximum and where; in voxels with millimetres beside them.
  void ErrorRows(const Measured& m, const std::string& method, const std::string& id)
  {
    const auto add = [&](const std::string& what, double mm, const std::string& note)
    {
      ReportRow row = this->Row("isosurface." + what + "." + id, mm / this->Voxel, "voxel", m.name);
      row.error = row.value;
      row.errorUnit = "voxel";
      row.timeS = m.frame.wallS;
      row.cpuS = m.frame.cpuS;
      row.n = m.error.pixels;
      char text[120];
      std::snprintf(text, sizeof text, ", %.5f mm%s; %s", mm, note.c_str(), method.c_str());
      row.data += text;
      this->Context.report.rows.push_back(row);
    };
    add("rms", m.error.rmsMm, "");
    add("p99", m.error.p99Mm, "");
    add("max", m.error.maxMm,
      " at pixel " + std::to_string(m.error.maxX) + "," + std::to_string(m.error.maxY));
    ReportRow missed = this->Row("isosurface.missed." + id, m.error.missed, "share", m.name);
    missed.error = m.error.missed;
    missed.errorUnit = "share of surface pixels";
    missed.timeS = m.frame.wallS;
    missed.cpuS = m.frame.cpuS;
    this->Context.report.rows.push_back(missed);
  }
  void Curve(const std::string& method, const Measured& m)
  {
    const std::string id = "isosurface.error_time@" + this->Data.substr(0, 6);
    for (ReportCurve& curve : this->Context.report.curves)
      if (curve.id == id && curve.method == method)
      {
        curve.points.emplace_back(1e3 * m.frame.wallS, m.error.rmsMm);
        return;
      }
    this->Context.report.curves.push_back(
      { id, method, "ms", "mm RMS", { { 1e3 * m.frame.wallS, m.error.rmsMm } } });
  }
  void Unused(const ResourceUse& use)
  {
    for (const ResourceUse& known : this->Context.report.unused)
      if (known.resource == use.resource)
        return;
    this->Context.report.unused.push_back(use);
  }

  ReportContext& Context;
  std::string Data;
  double Voxel;
  IsosurfaceView View;
  SurfaceTruth Truth;
  std::unique_ptr<IsosurfaceMethod> Cells;
  Measured Ours;
};

void RunCase(ReportContext& context, const Case& c)
{
  Runner runner(context, c);
  const auto mesh = MakeMeshMethod(runner.GetView());
  runner.Against(*mesh, "VTK mesh", "mesh");
  const auto direct = MakeDirectMethod(runner.GetView());
  runner.Against(*direct, "direct ray cast", "direct");
  for (const auto& [step, id] : { std::pair(1.0, "volume1"), std::pair(0.25, "volume025") })
  {
    const auto volume = MakeVolumeMethod(runner.GetView(), step);
    runner.Against(*volume, "VTK GPU volume mapper", id);
  }
  runner.Finish(mesh->Bytes());
}

} // namespace

void ReportIsosurface(ReportContext& context)
{
  ChooseWindows();
  context.report.machine.gl = OpenGLName();
  const std::vector<int> sizes =
    context.settings.quick ? std::vector{ 64, 96 } : std::vector{ 128, 256 };
  for (const char* shape : { "sphere", "gyroid" })
    for (const int size : sizes)
      RunCase(context, MakeCase(shape, size));
}

} // namespace hasp
