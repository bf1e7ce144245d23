#include "CrackedSkull.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "SegmentationTrials.h"

#include "Segmentation/PackedDelta.h"

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
  std::size_t undoBytes = 0; ///< of what `labels` were before
};

Solve ShareOnce(LabelSplit& split, const CrackedSkull& skull, std::size_t strokes,
  std::vector<Label>& labels, const RandomWalkerSettings& settings = {})
{
  const GridView<Label> map{ labels.data(), skull.geometry };
  LabelDelta delta;
  Solve solve;
  solve.time =
    TimeOf([&] { delta = split.Share(std::span(skull.strokes).first(strokes), map, settings); });
  solve.run = split.LastRun();
  solve.undoBytes = PackDelta(delta, { map.data, map.geometry }).Bytes();
  return solve;
}

/// The random walk from nothing, of all strokes, with and without a coarse start.
Solve Cold(const CrackedSkull& skull, bool coarse)
{
  LabelSplit split(skull.Samples(), skull.Bone(), 1, { {}, 2.0 });
  RandomWalkerSettings settings;
  settings.coarseStart = coarse;
  std::vector<Label> labels = skull.bone;
  return ShareOnce(split, skull, skull.strokes.size(), labels, settings);
}

/// Strokes one after the other.
struct StrokeByStroke
{
  Solve first;                                       ///< from the mask to labels
  std::vector<double> wall, cpu, cycles, errors;     ///< of those after the first four
  double voxels = 0.0, bytes = 0.0, undoBytes = 0.0; ///< undoBytes: of the largest
  double mapMB = 0.0;                                ///< of the label map
};

StrokeByStroke Draw(ReportContext& context, const CrackedSkull& skull, double norm)
{
  StrokeByStroke result;
  std::optional<LabelSplit> split;
  const Timing made = TimeOf(
    [&] {
      split.emplace(skull.Samples(), skull.Bone(), 1, SplitSettings{ {}, norm });
    });
  std::vector<Label> labels = skull.bone;
  result.first = ShareOnce(*split, skull, CrackedSkull::First, labels);
  result.first.time.wallS += made.wallS;
  result.first.time.cpuS += made.cpuS;
  for (std::size_t strokes = CrackedSkull::First + 1; strokes <= skull.strokes.size(); ++strokes)
  {
    context.progress(0.1 * double(strokes), "");
    const Solve more = ShareOnce(*split, skull, strokes, labels);
    result.undoBytes = std::max(result.undoBytes, double(more.undoBytes));
    result.wall.push_back(more.time.wallS);
    result.cpu.push_back(more.time.cpuS);
    result.cycles.push_back(more.run.iterations);
    result.errors.push_back(more.run.error);
  }
  result.voxels = double(split->Graph().Nodes());
  result.bytes = double(split->Bytes());
  result.mapMB = 1e-6 * double(labels.size() * sizeof(Label));
  labels = skull.bone; // the first strokes one by one change most
  for (std::size_t strokes = 1; strokes <= CrackedSkull::First; ++strokes)
    result.undoBytes =
      std::max(result.undoBytes, double(ShareOnce(*split, skull, strokes, labels).undoBytes));
  return result;
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

/// Rows of one norm; `at` stands behind their names.
void AddRows(ReportContext& context, const std::string& at, const StrokeByStroke& drawn,
  const std::string& rival, const std::string& data)
{
  auto& rows = context.report.rows;
  rows.push_back(SecondsRow("segmentation.first" + at, drawn.first,
    rival + ", and what the graph costs", data + ", from the mask to labels", {}));
  Solve more{ { QuartilesOf(drawn.wall).median, QuartilesOf(drawn.cpu).median }, {} };
  more.run.error = *std::max_element(drawn.errors.begin(), drawn.errors.end());
  ReportRow resolve = SecondsRow("segmentation.resolve" + at, more, rival,
    data + ", median of three more strokes; aim 1.5 s", {});
  const Quartiles seconds = QuartilesOf(drawn.wall);
  resolve.q1 = seconds.q1;
  resolve.q3 = seconds.q3;
  resolve.n = int(drawn.wall.size());
  if (!context.settings.quick) // a smaller case says nothing of the bar
    resolve.bars = { { {}, 4.0 } };
  rows.push_back(resolve);

  ReportRow memory;
  memory.id = "segmentation.memory" + at;
  memory.value = drawn.bytes / drawn.voxels;
  memory.unit = "bytes a voxel of bone";
  memory.better = Better::Lower;
  memory.rival = "a list of six neighbours and weights: 48 bytes, and no solver";
  memory.data = data + ", graph, solver and solution, between solves";
  rows.push_back(memory);

  ReportRow undo;
  undo.id = "segmentation.undo" + at;
  undo.value = 1e-6 * drawn.undoBytes;
  undo.unit = "MB";
  undo.better = Better::Lower;
  char text[120];
  std::snprintf(text, sizeof text, "a copy of the label map: %.0f MB", drawn.mapMB);
  undo.rival = text;
  undo.data = data + ", of seven strokes one by one that which changes most";
  undo.bars = { { {}, 1.0 } };
  rows.push_back(undo);
}

} // namespace

void TryResolve(ReportContext& context)
{
  const bool quick = context.settings.quick;
  context.progress(0.0, "segmentation: one more stroke");
  const CrackedSkull skull(quick ? 0.9 : 0.42);
  const StrokeByStroke cut = Draw(context, skull, 1.0), walk = Draw(context, skull, 2.0);
  const Solve coarse = Cold(skull, true), nothing = Cold(skull, false);

  char text[160];
  std::snprintf(text, sizeof text,
    "phantom's skull with two cracks, %.2f M voxels of bone, 4 labels%s", 1e-6 * cut.voxels,
    quick ? " (not quick: 8 M)" : "");
  const std::string data = text;
  std::snprintf(text, sizeof text, "the random walk from nothing, without coarse graphs: %.2f s",
    nothing.time.wallS);
  AddRows(context, "", cut, text, data + ", norm 1");
  AddRows(context, ".walk", walk, text, data + ", norm 2");
  auto& rows = context.report.rows;
  rows.push_back(WarmRow("segmentation.warm", QuartilesOf(walk.cycles).median, nothing,
    "a start from nothing, without coarse graphs", data + ", norm 2", 0.3));
  rows.push_back(WarmRow("segmentation.warm.coarse", QuartilesOf(walk.cycles).median, coarse,
    "a start from what coarse graphs say, whose own cycles are not counted", data + ", norm 2",
    {}));
}

} // namespace hasp
