// Time (wall, and CPU of all threads) and undo of each edit of a label map, and how good a proposed
// threshold is. Edits are timed on the phantom's bone (label 1) in a cube of samples; what has a
// closed form is printed beside what was counted. Dice is with the phantom's bone. Not a test.
// Usage: BenchKernelLabelEdits [samples per axis, default 256] [mm of the threshold's scans,
// default 2]
#include "Grid/Phantom.h"
#include "Grid/Stopwatch.h"
#include "Segmentation/Components.h"
#include "Segmentation/LabelEdits.h"
#include "Segmentation/LabelHash.h"
#include "Segmentation/LabelMorphology.h"
#include "Segmentation/ThresholdProposal.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <random>
#include <vector>

namespace
{

using hasp::Label;
using hasp::LabelDelta;

/// Does it, prints it and takes it back.
void Time(const char* what, hasp::GridView<Label> labels, const std::function<LabelDelta()>& edit)
{
  const hasp::Stopwatch watch;
  const std::clock_t cpu = std::clock();
  const LabelDelta delta = edit();
  const double cpuMs = 1e3 * double(std::clock() - cpu) / CLOCKS_PER_SEC;
  const double ms = watch.Milliseconds();
  const hasp::Stopwatch undo;
  hasp::RevertDelta(delta, labels);
  std::printf("%-34s %9.1f %9.1f %9.2f %12.3f %12llu\n", what, ms, cpuMs, undo.Milliseconds(),
    double(delta.Bytes()) / 1e6, static_cast<unsigned long long>(delta.Voxels()));
}

void TimeStrokes(hasp::GridView<Label> labels)
{
  const glm::dvec3 middle = labels.geometry.IndexToWorld(0.5 * glm::dvec3(labels.geometry.dims));
  for (const double radius : { 0.1, 1.0, 3.0, 10.0 })
  {
    const std::vector<glm::dvec3> line{ middle - 15.0, middle + 15.0 }; // 52 mm
    const hasp::Stopwatch watch;
    const hasp::VoxelRuns runs = hasp::RasterizeStroke(labels.geometry, line, radius);
    const glm::dvec3& s = labels.geometry.spacing;
    const double truth = 3.14159265 * radius * radius * (51.9615 + 4.0 / 3.0 * radius);
    std::printf("  stroke of %4.1f mm: %7.2f ms, %8.1f mm3 in closed form, %8.1f mm3 marked\n",
      radius, watch.Milliseconds(), truth, double(hasp::CountVoxels(runs)) * s.x * s.y * s.z);
    Time("  painting it", labels, [&] { return hasp::PaintVoxels(labels, runs, 2); });
  }
}

void TimeEdits(int n)
{
  const hasp::GridGeometry grid = hasp::PhantomGridOfSize(glm::ivec3(n));
  const std::vector<std::int16_t> samples = hasp::SamplePhantom(grid);
  std::vector<Label> map(grid.Size());
  const hasp::GridView<Label> labels{ map.data(), grid };
  hasp::ThresholdLabels(
    hasp::GridView<const std::int16_t>{ samples.data(), grid }, 226, 32767, labels);
  const std::uint64_t hash = hasp::HashLabels({ map.data(), grid });
  std::printf("%d^3 voxels of %.2f x %.2f x %.2f mm, %zu of bone\n%-34s %9s %9s %9s %12s %12s\n", n,
    grid.spacing.x, grid.spacing.y, grid.spacing.z, hasp::CountLabels({ map.data(), grid })[1],
    "edit", "ms", "CPU ms", "undo ms", "delta MB", "voxels");
  TimeStrokes(labels);
  Time("merge into 7", labels, [&] { return hasp::MergeLabels(labels, 1, 7); });
  Time("components", labels, [&] { return hasp::SeparateComponents(labels, 1); });
  Time("cavities", labels, [&] { return hasp::FillCavities(labels, 1); });
  for (const double radius : { 1.0, 5.0 })
  {
    std::printf("radius %.0f mm\n", radius);
    Time("  dilate", labels, [&] { return hasp::DilateLabel(labels, 1, radius); });
    Time("  erode", labels, [&] { return hasp::ErodeLabel(labels, 1, radius); });
    Time("  open", labels, [&] { return hasp::OpenLabel(labels, 1, radius); });
    Time("  close", labels, [&] { return hasp::CloseLabel(labels, 1, radius); });
  }
  std::printf("all undone: %s\n\n",
    hasp::HashLabels({ map.data(), grid }) == hash ? "the same hash" : "ANOTHER HASH");
  // The worst for components: noise, where nearly every run is a piece's border.
  std::mt19937 random(1);
  for (Label& label : map)
    label = random() % 5 < 2;
  Time("components of noise, 40 %, largest", labels,
    [&] {
      return hasp::SeparateComponents(labels, 1, { 0.0, true });
    });
}

void JudgeThreshold(const char* name, const hasp::PhantomSettings& settings, double spacing)
{
  const hasp::GridGeometry grid = hasp::PhantomGrid(glm::dvec3(spacing), settings);
  const std::vector<std::int16_t> samples = hasp::SamplePhantom(grid, settings);
  const hasp::AnalyticVolume bone = hasp::PhantomBone(settings);
  std::vector<double> in(65536), out(65536);
  double all = 0.0;
  std::size_t v = 0;
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i, ++v)
      {
        const bool inside = bone.value(grid.IndexToWorld({ i, j, k })) > 0.0;
        ++(inside ? in : out)[std::size_t(samples[v] + 32768)];
        all += inside;
      }
  const hasp::ThresholdProposal found =
    hasp::ProposeThreshold(hasp::GridView<const std::int16_t>{ samples.data(), grid });
  double hit = 0.0, miss = 0.0, best = 0.0, bestAt = 0.0, at = 0.0;
  for (int value = 32767; value >= -32768; --value)
  {
    hit += in[std::size_t(value + 32768)];
    miss += out[std::size_t(value + 32768)];
    const double dice = 2.0 * hit / (hit + miss + all);
    if (dice > best)
    {
      best = dice;
      bestAt = value;
    }
    if (value >= found.threshold)
      at = dice;
  }
  std::printf("%-26s %9.0f %8.4f %9.0f %8.4f %8.4f %6.1f\n", name, found.threshold, at, bestAt,
    best, best - at, found.separation);
}

void JudgeThresholds(double spacing)
{
  std::printf("\nproposed thresholds, scans of %.1f mm\n%-26s %9s %8s %9s %8s %8s %6s\n", spacing,
    "scan", "proposed", "Dice", "best", "Dice", "lost", "sep.");
  hasp::PhantomSettings settings;
  JudgeThreshold("CT without noise", settings, spacing);
  settings.blurMm = glm::dvec3(0.4);
  settings.noiseHU = 40.0;
  JudgeThreshold("CT", settings, spacing);
  settings.metal.on = true;
  JudgeThreshold("CT, metal", settings, spacing);
  settings.metal.on = false;
  settings.coneBeam.on = true;
  settings.noiseHU = 60.0;
  JudgeThreshold("cone beam", settings, spacing);
  settings.metal.on = true;
  settings.coneBeam.cupping = 0.25;
  settings.noiseHU = 120.0;
  JudgeThreshold("cone beam, cupping 25 %, metal", settings, spacing);
}

} // namespace

int main(int argc, char** argv)
{
  const int n = argc > 1 ? std::atoi(argv[1]) : 256;
  const double spacing = argc > 2 ? std::atof(argv[2]) : 2.0;
  if (n < 16 || n > 1024 || !(spacing >= 0.5 && spacing <= 8.0))
  {
    std::fprintf(stderr, "samples per axis must be in [16, 1024], mm in [0.5, 8]\n");
    return 1;
  }
  TimeEdits(n);
  JudgeThresholds(spacing);
}
