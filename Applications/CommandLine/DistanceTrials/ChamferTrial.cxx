#include "Distance/ChamferDistance.h"
#include "Distance/CoverageDistance.h"
#include "DistanceErrors.h"
#include "DistanceTrials.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"
#include "TrialTimes.h"

#include <cstdio>
#include <optional>

namespace hasp
{
namespace
{

constexpr int Samples = 72;
constexpr int Shapes = 3;

/// Sphere, torus, capsule of about 20 voxels, turned any way.
AnalyticVolume Shape(int n, const glm::dvec3& centre, std::mt19937_64& random)
{
  const double v = TrialVoxelMm;
  if (n == 0)
    return AnalyticSphere(v * centre, 20.0 * v);
  const glm::dvec3 axis = AnyDirection(random);
  return n == 1 ? AnalyticTorus(v * centre, axis, 18.0 * v, 7.0 * v)
                : AnalyticCapsule(v * (centre - 12.0 * axis), v * (centre + 12.0 * axis), 10.0 * v);
}

struct Offset
{
  double voxels;
  std::optional<double> most; ///< the bar
  DistanceErrors binary{ TrialVoxelMm }, smooth{ TrialVoxelMm }, guide{ TrialVoxelMm };
};

ReportRow RatioOf(const DistanceErrors& ours, const DistanceErrors& rival, const std::string& id,
  const char* rivalName, const Timing& time, const std::string& data)
{
  ReportRow row;
  row.id = id;
  row.value = ours.Rms() / rival.Rms();
  row.unit = "of the rival's RMS";
  row.better = Better::Lower;
  row.rival = std::string(rivalName) + ": " + rival.Text();
  row.error = ours.Rms();
  row.errorUnit = "voxel";
  row.timeS = time.wallS;
  row.cpuS = time.cpuS;
  row.n = static_cast<int>(ours.Count());
  row.data = data + ours.Text();
  return row;
}

void Add(Timing& sum, const Timing& time, double share)
{
  sum.wallS += share * time.wallS;
  sum.cpuS += share * time.cpuS;
}

/// By coverage of so many places a voxel and axis; 0: exact.
struct Kind
{
  int perAxis;
  const char* at; ///< of the ids
  const char* text;
  std::vector<Offset> offsets;
  Timing smooth{}, guide{};
};

void Measure(Kind& kind, const AnalyticVolume& shape, double share)
{
  const GridGeometry grid = TrialGrid(Samples);
  const std::vector<float> coverage =
    kind.perAxis > 0 ? SampledCoverage(shape, grid, kind.perAxis) : ExactCoverage(shape, grid);
  const auto timed = [&](Timing& sum, auto transform)
  {
    std::vector<float> distances;
    Add(sum,
      OnThreads(1, [&] { return TimeOf([&] { distances = transform(grid, coverage, {}); }); }),
      share);
    return distances;
  };
  const std::vector<float> smooth = timed(kind.smooth, ChamferDistance);
  const std::vector<float> guide = timed(kind.guide, CoverageDistance);
  const std::vector<float> binary = ChamferDistance(grid, BinaryOf(coverage));
  const auto truth = [&](const glm::dvec3& world) { return -shape.value(world); };
  for (Offset& offset : kind.offsets)
  {
    const double mm = offset.voxels * TrialVoxelMm;
    AddOffsetErrors(smooth, grid, mm, truth, shape.name, offset.smooth);
    AddOffsetErrors(binary, grid, mm, truth, shape.name, offset.binary);
    AddOffsetErrors(guide, grid, mm, truth, shape.name, offset.guide);
  }
}

void AddRows(ReportContext& context, const Kind& kind, int centres)
{
  char text[240];
  std::snprintf(text, sizeof text,
    "sphere R 20, torus 18/7, capsule 24/10 voxels turned any way, %d centres, %d^3, %s; where "
    "lines of the grid pass the offset; ",
    centres, Samples, kind.text);
  for (const Offset& offset : kind.offsets)
  {
    const std::string at = std::to_string(static_cast<int>(offset.voxels)) + kind.at;
    ReportRow row = RatioOf(offset.smooth, offset.binary, "distance.rms.chamfer_aa." + at,
      "binary <3,4,5>", kind.smooth, text + std::string("anti-aliased <3,4,5>: "));
    if (offset.most)
      row.bars = { { {}, offset.most } };
    context.report.rows.push_back(row);
    context.report.rows.push_back(RatioOf(offset.guide, offset.smooth, "distance.offset." + at,
      "anti-aliased <3,4,5>", kind.guide, text + std::string("the guides' transform: ")));
  }
}

} // namespace

void TryChamfer(ReportContext& context)
{
  const int step = context.settings.quick ? 9 : 1; // of 27 centres
  const int centres = 26 / step + 1;
  std::mt19937_64 random(context.settings.seed);
  std::vector<Kind> kinds = {
    { 4, "", "coverage by 4^3 places a voxel as in the papers",
      { { 0.0, 0.15 }, { 2.0, 0.45 }, { 5.0, {} } } },
    { 0, "@exact", "exact coverage", { { 0.0, {} }, { 2.0, {} }, { 5.0, {} } } },
  };
  for (int n = 0; n < 27; n += step)
    for (int s = 0; s < Shapes; ++s)
    {
      const AnalyticVolume shape = Shape(s, SubVoxelCentre(n, context.settings.seed), random);
      for (Kind& kind : kinds)
        Measure(kind, shape, 1.0 / (Shapes * centres));
    }
  for (const Kind& kind : kinds)
    AddRows(context, kind, centres);
}

} // namespace hasp
