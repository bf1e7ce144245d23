#include "ReportCells.h"

#include "MeasuredRows.h"
#include "ReportCellsParts.h"
#include "ReportRegistry.h"
#include "ReportVolume.h"
#include "Windows.h"

#include "vtkImageData.h"

#include <filesystem>
#include <functional>

namespace hasp
{
namespace
{

using MakeScene = std::function<CellScene(int)>;

void AddExponent(ReportContext& context, const std::string& id, const std::string& of,
  const std::vector<std::pair<double, double>>& figures)
{
  ReportRow row;
  row.id = id;
  row.value = GrowthExponent(figures);
  row.unit = "power of samples an axis";
  row.better = Better::Lower;
  row.n = int(figures.size());
  row.data = of + ", " + std::to_string(int(figures.front().first)) + " to " +
             std::to_string(int(figures.back().first)) + " samples an axis";
  context.report.rows.push_back(row);
}

/// Extraction and bytes over sizes, so that growth can be read.
void MeasureGrowth(ReportContext& context, const std::string& name, const MakeScene& scene,
  const std::vector<int>& sizes)
{
  std::vector<std::pair<double, double>> bytes, times;
  for (const int n : sizes)
  {
    const CellSize size = ReportCellBytes(context, scene(n));
    bytes.emplace_back(n, size.bytes);
    times.emplace_back(n, size.extractionS);
  }
  AddExponent(context, "cells.growth.bytes@" + name, name + ", bytes", bytes);
  AddExponent(context, "cells.growth.extract@" + name, name + ", CPU time", times);
}

void MeasureVolume(ReportContext& context, int pixels)
{
  const std::string& path = context.settings.volume;
  if (!std::filesystem::exists(path))
  {
    context.report.rows.push_back(AbsentRow("cells.bytes.exact@cranium", "a mesh of a real CT",
      "no real CT there: give --volume the path that Utilities/Scripts/cranium prints"));
    return;
  }
  const ReportVolume volume = ReadReportVolume(path);
  const CellScene scene{ "@" + volume.name, volume.data, volume.image, volume.isovalue };
  ReportCellBytes(context, scene);
  ReportCellEdits(context, scene);
  ReportCellDepth(context, scene, pixels);
  ReportCellRays(context, scene, pixels);
}

} // namespace

void ReportCells(ReportContext& context)
{
  const bool quick = context.settings.quick;
  const std::uint64_t seed = context.settings.seed;
  const int pixels = quick ? 160 : 512;
  const int head = quick ? 96 : 256;
  RequireReportVolume(context.settings.volume);
  ChooseWindows();
  context.report.machine.gl = OpenGLName();

  const auto headOf = [&](int n) { return HeadScene(n, seed, n == head); };
  MeasureGrowth(context, "head", headOf, { head / 2, head * 3 / 4, head });
  MeasureGrowth(context, "gyroid", GyroidScene, { head / 2, head });
  MeasureGrowth(context, "bone", SpongyBoneScene, { head / 2, head });

  const CellScene scene = headOf(head);
  ReportCellEdits(context, scene);
  ReportCellDepth(context, scene, pixels);
  ReportCellRays(context, scene, pixels);
  const std::vector<int> deep = quick ? std::vector{ 40, 80 } : std::vector{ 128, 256, 384 };
  for (const int n : deep)
    ReportCellFrames(context, SpongyBoneScene(n), pixels, n == deep.back());
  MeasureVolume(context, pixels);
  const std::int64_t rays = quick ? 20'000 : context.settings.soak ? 100'000'000 : 1'000'000;
  ReportRandomRays(context, scene, rays);
  ReportCellStream(context, quick ? 256 : 1024);
  if (context.settings.soak)
    ReportCellStream(context, 2048);
}

} // namespace hasp
