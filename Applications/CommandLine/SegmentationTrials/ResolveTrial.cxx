#include "CrackedSkull.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "SegmentationTrials.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace hasp
{
namespace
{

struct Solve
{
  Timing time;
  RandomWalkerRun run;
};

Solve ShareOnce(LabelSplit& split, const CrackedSkull& skull, std::size_t strokes,
  const RandomWalkerSettings& settings = {})
{
  std::vector<Label> labels = skull.bone;
  Solve solve;
  solve.time = TimeOf(
    [&]
    {
      split.Share(
        std::span(skull.strokes).first(strokes), { labels.data(), skull.geometry }, settings);
    });
  solve.run = split.LastRun();
  return solve;
}

/// With the cycles from nothing, of all strokes, with and without a coarse start.
Solve Cold(const CrackedSkull& skull, bool coarse)
{
  LabelSplit split(skull.Samples(), skull.Bone(), 1);
  RandomWalkerSettings settings;
  settings.coarseStart = coarse;
  return ShareOnce(split, skull, skull.strokes.size(), settings);
}

ReportRow SecondsRow(const std::string& id, const Solve& solve, const std::string& rival,
  const std::string& data, std::optional<double> bar)
{
  ReportRow row;
  row.id = id;
  row.value = row.timeS = solve.time.wallS;
  row.cpuS = solve.time.cpuS;
  row.unit = "s";
  row.better = Better::Lower;
  row.rival = rival;
  row.error = solve.run.error;
  row.errorUnit = "of probabilities, estimated";
  row.data = data;
  if (bar)
    row.bars = { { {}, *bar } };
  return row;
}

ReportRow WarmRow(const std::string& id, double warm, const Solve& cold, const std::string& rival,
  const std::string& data, std::optional<double> bar)
{
  ReportRow row;
  row.id = id;
  row.value = warm / cold.run.iterations;
  row.unit = "ratio";
  row.better = Better::Lower;
  row.rival = rival;
  char text[120];
  std::snprintf(text, sizeof text, "; %.3g cycles on voxels, from nothing %d; aim 0.15", warm,
    cold.run.iterations);
  row.data = data + text;
  if (bar)
    row.bars = { { {}, *bar } };
  return row;
}

} // namespace

void TryResolve(ReportContext& context)
{
  const bool quick = context.settings.quick;
  context.progress(0.0, "segmentation: one more stroke");
  const CrackedSkull skull(quick ? 0.9 : 0.42);
  std::optional<LabelSplit> split;
  Solve first;
  const Timing made = TimeOf([&] { split.emplace(skull.Samples(), skull.Bone(), 1); });
  first = ShareOnce(*split, skull, CrackedSkull::First);
  first.time.wallS += made.wallS;
  first.time.cpuS += made.cpuS;
  std::vector<double> wall, cpu, cycles, errors;
  for (std::size_t strokes = CrackedSkull::First + 1; strokes <= skull.strokes.size(); ++strokes)
  {
    context.progress(0.1 * double(strokes), "");
    const Solve more = ShareOnce(*split, skull, strokes);
    wall.push_back(more.time.wallS);
    cpu.push_back(more.time.cpuS);
    cycles.push_back(more.run.iterations);
    errors.push_back(more.run.error);
  }
  const double voxels = double(split->Graph().Nodes());
  const double bytes = double(split->Bytes());
  split.reset();
  const Solve coarse = Cold(skull, true), nothing = Cold(skull, false);

  char text[120];
  std::snprintf(text, sizeof text,
    "phantom's skull with two cracks, %.2f M voxels of bone, 4 labels%s", 1e-6 * voxels,
    quick ? " (not quick: 8 M)" : "");
  const std::string data = text;
  Solve more{ { QuartilesOf(wall).median, QuartilesOf(cpu).median }, {} };
  more.run.error = *std::max_element(errors.begin(), errors.end());
  std::snprintf(
    text, sizeof text, "the same from nothing, without coarse graphs: %.2f s", nothing.time.wallS);
  auto& rows = context.report.rows;
  rows.push_back(SecondsRow("segmentation.first", first,
    text + std::string(" and what the graph costs"), data + ", from the mask to labels", {}));
  ReportRow resolve = SecondsRow(
    "segmentation.resolve", more, text, data + ", median of three more strokes; aim 1.5 s", {});
  const Quartiles seconds = QuartilesOf(wall);
  resolve.q1 = seconds.q1;
  resolve.q3 = seconds.q3;
  resolve.n = int(wall.size());
  if (!quick) // a smaller case says nothing of the bar
    resolve.bars = { { {}, 4.0 } };
  rows.push_back(resolve);

  ReportRow memory;
  memory.id = "segmentation.memory";
  memory.value = bytes / voxels;
  memory.unit = "bytes a voxel of bone";
  memory.better = Better::Lower;
  memory.rival = "a list of six neighbours and weights: 48 bytes, and no solver";
  memory.data = data + ", graph, solver and solution, between solves";
  rows.push_back(memory);
  rows.push_back(WarmRow("segmentation.warm", QuartilesOf(cycles).median, nothing,
    "a start from nothing, without coarse graphs", data, 0.3));
  rows.push_back(WarmRow("segmentation.warm.coarse", QuartilesOf(cycles).median, coarse,
    "a start from what coarse graphs say, whose own cycles are not counted", data, {}));
}

} // namespace hasp
