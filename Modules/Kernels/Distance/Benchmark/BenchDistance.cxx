// Error and time of the distance transforms, one thread: voxels, and CPU time over that of the
// anti-aliased <3,4,5> transform (least of the runs, alternated in one process). Not a test.
// Usage: BenchKernelDistance [samples per axis, default 128] [runs, default 7]
#include "Distance/ChamferDistance.h"
#include "Distance/CoverageDistance.h"
#include "Distance/ElementLanes.h"
#include "Distance/EuclideanDistance.h"
#include "Testing/AnalyticCoverage.h"
#if HASP_WITH_TBB
#include "Grid/Testing/WithThreads.h"
#endif

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string>

namespace
{

using Field = std::vector<float>;

double Seconds()
{
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

struct Row
{
  std::string name;
  std::function<Field()> transform;
  Field distance = {};
  double seconds = std::numeric_limits<double>::infinity();
};

void Run(std::vector<Row>& rows, int runs)
{
  for (int run = 0; run < runs; ++run)
    for (Row& row : rows)
    {
      const double start = Seconds();
      Field distance = row.transform();
      row.seconds = std::min(row.seconds, Seconds() - start);
      row.distance = std::move(distance);
    }
}

void Report(
  const hasp::AnalyticVolume& shape, const hasp::GridGeometry& grid, const char* what, int runs)
{
  const Field coverage = hasp::AnalyticCoverage(shape, grid);
  std::vector<std::uint8_t> mask(coverage.size());
  std::transform(
    coverage.begin(), coverage.end(), mask.begin(), [](float c) { return c >= 0.5F ? 1 : 0; });
  const Field binary(mask.begin(), mask.end());
  std::vector<Row> rows = {
    { "<3,4,5> binary", [&] { return hasp::ChamferDistance(grid, binary); } },
    { "<3,4,5> aa", [&] { return hasp::ChamferDistance(grid, coverage); } },
    { "euclid binary", [&] { return hasp::SignedEuclideanDistance(grid, mask); } },
    { "guides' band", [&] { return hasp::CoverageDistanceBand(grid, coverage); } },
    { "guides' full", [&] { return hasp::CoverageDistance(grid, coverage); } },
  };
  Run(rows, runs);
  for (const Row& row : rows)
  {
    std::printf("%-20s %-15s %8.1f %6.2f", what, row.name.c_str(), 1e3 * row.seconds,
      row.seconds / rows[1].seconds);
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
  Report(hasp::AnalyticSphere(off, 40.3 * s), cube, "sphere R 40.3", runs);
  Report(hasp::AnalyticSphere(off, 12.3), cube, "sphere R 12.3", runs);
  const auto torus = hasp::AnalyticTorus(off, glm::normalize(glm::dvec3(1, 2, 2)), 35 * s, 12 * s);
  Report(torus, cube, "torus 35/12, tilted", runs);
  Report(hasp::AnalyticSphere(off, 40.3 * s), slices, "sphere, 0.957/1.5 mm", runs);
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
#if HASP_WITH_TBB
  hasp::testing::WithThreads(1,
    [&]
    {
      Measure(n, runs);
      return 0;
    });
#else
  Measure(n, runs);
#endif
}
