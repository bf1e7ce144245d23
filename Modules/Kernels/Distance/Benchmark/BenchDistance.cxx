// Error and time of the distance transforms, one thread: voxels, and CPU time over that of the
// anti-aliased <3,4,5> transform (least of the runs, alternated in one process). Then voxels a
// second of exact Euclidean distances, on one thread and two, beside ITK's where it is there. Not a
// test. Usage: BenchKernelDistance [samples per axis, default 128] [runs, default 7]
#include "Benchmark/Rivals.h"
#include "Distance/AntiAliasedEuclidean.h"
#include "Distance/ChamferDistance.h"
#include "Distance/CoverageDistance.h"
#include "Distance/ElementLanes.h"
#include "Distance/EuclideanDistance.h"
#include "Testing/AnalyticCoverage.h"
#if HASP_WITH_TBB
#include "Grid/Testing/WithThreads.h"
#endif

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string>

namespace
{

using Field = std::vector<float>;
using Mask = std::vector<std::uint8_t>;

template <typename F>
auto OnThreads([[maybe_unused]] int threads, F&& make)
{
#if HASP_WITH_TBB
  return hasp::testing::WithThreads(threads, make);
#else
  return make();
#endif
}

double CpuSeconds()
{
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

double WallSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Row
{
  std::string name;
  std::function<Field()> transform;
  int threads = 1;
  Field distance = {};
  double cpu = std::numeric_limits<double>::infinity(), wall = cpu;
};

void Run(std::vector<Row>& rows, int runs)
{
  for (int run = 0; run < runs; ++run)
    for (Row& row : rows)
    {
      const double cpu = CpuSeconds(), wall = WallSeconds();
      Field distance = OnThreads(row.threads, row.transform);
      row.cpu = std::min(row.cpu, CpuSeconds() - cpu);
      row.wall = std::min(row.wall, WallSeconds() - wall);
      row.distance = std::move(distance);
    }
}

Mask MaskOf(const Field& coverage)
{
  Mask mask(coverage.size());
  std::transform(
    coverage.begin(), coverage.end(), mask.begin(), [](float c) { return c >= 0.5F ? 1 : 0; });
  return mask;
}

void Report(
  const hasp::AnalyticVolume& shape, const hasp::GridGeometry& grid, const char* what, int runs)
{
  const Field coverage = hasp::AnalyticCoverage(shape, grid);
  const Mask mask = MaskOf(coverage);
  const Field binary(mask.begin(), mask.end());
  std::vector<Row> rows = {
    { "<3,4,5> binary", [&] { return hasp::ChamferDistance(grid, binary); } },
    { "<3,4,5> aa", [&] { return hasp::ChamferDistance(grid, coverage); } },
    { "euclid binary", [&] { return hasp::SignedEuclideanDistance(grid, mask); } },
    { "euclid aa", [&] { return hasp::AntiAliasedEuclideanDistance(grid, coverage); } },
    { "guides' band", [&] { return hasp::CoverageDistanceBand(grid, coverage); } },
    { "guides' full", [&] { return hasp::CoverageDistance(grid, coverage); } },
  };
  Run(rows, runs);
  for (const Row& row : rows)
  {
    std::printf(
      "%-20s %-15s %8.1f %6.2f", what, row.name.c_str(), 1e3 * row.cpu, row.cpu / rows[1].cpu);
    for (const double within : { 3.0, 40.0 })
    {
      const auto e = hasp::ErrorOf(row.distance, shape, grid, within);
      if (within == 40.0 && row.name == "guides' band")
        std::printf("  %8s %8s %8s", "-", "-", "-");
      else
        std::printf("  %8.4f %8.4f %8.4f", e.rms, e.p99, e.most);
    }
    std::printf("\n");
  }
}

/// Exact distances alone: what counts is how many voxels a second, at equal threads.
void ReportExact(
  const hasp::AnalyticVolume& shape, const hasp::GridGeometry& grid, const char* what, int runs)
{
  const Mask mask = MaskOf(hasp::AnalyticCoverage(shape, grid));
  std::vector<Row> rows;
  for (const int threads : { 1, 2 })
  {
    rows.push_back({ "Hasp", [&] { return hasp::SignedEuclideanDistance(grid, mask); }, threads });
#if HASP_WITH_ITK
    rows.push_back({ "ITK",
      [&grid, &mask, threads] { return hasp::bench::ItkSignedMaurer(grid, mask, threads); },
      threads });
#endif
  }
  Run(rows, runs);
  for (const Row& row : rows)
    std::printf("%-20s %-6s %7d %8.1f %8.1f %12.1f\n", what, row.name.c_str(), row.threads,
      1e3 * row.cpu, 1e3 * row.wall, 1e-6 * double(grid.Size()) / row.wall);
}

void Measure(int n, int runs)
{
  const double s = n / 128.0;
  const hasp::GridGeometry cube{ glm::ivec3(n), glm::dvec3(-0.5 * n), glm::dvec3(1.0),
    glm::dmat3(1) };
  const hasp::GridGeometry slices{ glm::ivec3(n), glm::dvec3(-0.5 * n, -0.5 * n, -0.75 * n),
    glm::dvec3(0.957, 0.957, 1.5), glm::dmat3(1) };
  const glm::dvec3 off(0.31, -0.22, 0.43); // off the grid's centre
  std::printf("%d^3 voxels, %s; errors within 3 and within 40 voxels\n%-20s %-15s %8s %6s", n,
    hasp::BestElementLanes().name, "shape", "transform", "CPU ms", "/ aa");
  std::printf("  %8s %8s %8s  %8s %8s %8s\n", "rms", "p99", "max", "rms", "p99", "max");
  const auto torus = hasp::AnalyticTorus(off, glm::normalize(glm::dvec3(1, 2, 2)), 35 * s, 12 * s);
  Report(hasp::AnalyticSphere(off, 40.3 * s), cube, "sphere R 40.3", runs);
  Report(hasp::AnalyticSphere(off, 12.3), cube, "sphere R 12.3", runs);
  Report(torus, cube, "torus 35/12, tilted", runs);
  Report(hasp::AnalyticSphere(off, 40.3 * s), slices, "sphere, 0.957/1.5 mm", runs);
  std::printf("\nexact, signed\n%-20s %-6s %7s %8s %8s %12s\n", "shape", "", "threads", "CPU ms",
    "wall ms", "Mvoxel/s");
  ReportExact(hasp::AnalyticSphere(off, 40.3 * s), cube, "sphere R 40.3", runs);
  ReportExact(torus, cube, "torus 35/12, tilted", runs);
  ReportExact(hasp::AnalyticTrabecular(45 * s, 4 * s, 12 * s), cube, "spongy bone", runs);
}

} // namespace

int main(int argc, char** argv)
{
  const int n = argc > 1 ? std::atoi(argv[1]) : 128, runs = argc > 2 ? std::atoi(argv[2]) : 7;
  if (n < 16 || n > 1024 || runs < 1 || runs > 1000)
  {
    std::fprintf(stderr, "samples per axis must be in [16, 1024], runs in [1, 1000]\n");
    return 1;
  }
  Measure(n, runs);
}
