// Error against time of the distance transforms, in voxels and milliseconds (least of five runs).
// Usage: BenchKernelDistance [samples per axis, default 128]
#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "Testing/AnalyticCoverage.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>

namespace
{

struct Timed
{
  std::vector<float> distance;
  double milliseconds;
};

Timed LeastOfFive(const std::function<std::vector<float>()>& transform)
{
  Timed best{ {}, 1e300 };
  for (int run = 0; run < 5; ++run)
  {
    const auto start = std::chrono::steady_clock::now();
    best.distance = transform();
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - start;
    best.milliseconds = std::min(best.milliseconds, spent.count());
  }
  return best;
}

void Report(const hasp::AnalyticVolume& shape, const hasp::GridGeometry& grid, const char* what)
{
  const std::vector<float> coverage = hasp::AnalyticCoverage(shape, grid);
  std::vector<std::uint8_t> mask(coverage.size());
  std::transform(
    coverage.begin(), coverage.end(), mask.begin(), [](float c) { return c >= 0.5F ? 1 : 0; });
  const Timed rows[] = {
    LeastOfFive([&] { return hasp::SignedEuclideanDistance(grid, mask); }),
    LeastOfFive([&] { return hasp::CoverageDistance(grid, coverage); }),
  };
  const char* names[] = { "binary", "coverage" };
  for (int r = 0; r < 2; ++r)
    for (const double within : { 3.0, 10.0 })
    {
      const auto e = hasp::ErrorOf(rows[r].distance, shape, grid, within);
      std::printf("%-22s %-9s %5.0f %9.4f %9.4f %9.4f %9.1f\n", what, names[r], within, e.rms,
        e.p99, e.most, rows[r].milliseconds);
    }
}

} // namespace

int main(int argc, char** argv)
{
  const int n = argc > 1 ? std::atoi(argv[1]) : 128;
  if (n < 16 || n > 1024)
  {
    std::fprintf(stderr, "samples per axis must be in [16, 1024]\n");
    return 1;
  }
  const double s = n / 128.0;
  const hasp::GridGeometry cube{ glm::ivec3(n), glm::dvec3(-0.5 * n), glm::dvec3(1.0),
    glm::dmat3(1) };
  const hasp::GridGeometry slices{ glm::ivec3(n), glm::dvec3(-0.5 * n, -0.5 * n, -0.75 * n),
    glm::dvec3(0.957, 0.957, 1.5), glm::dmat3(1) };
  const glm::dvec3 off(0.31, -0.22, 0.43); // off the grid's centre
  std::printf("%d^3 voxels\n%-22s %-9s %5s %9s %9s %9s %9s\n", n, "shape", "transform", "+-vox",
    "rms", "p99", "max", "ms");
  Report(hasp::AnalyticSphere(off, 40.3 * s), cube, "sphere R 40.3");
  Report(hasp::AnalyticSphere(off, 12.3), cube, "sphere R 12.3");
  const auto torus = hasp::AnalyticTorus(off, glm::normalize(glm::dvec3(1, 2, 2)), 35 * s, 10 * s);
  Report(torus, cube, "torus 35/10, tilted");
  Report(hasp::AnalyticSphere(off, 40.3 * s), slices, "sphere, 0.957/1.5 mm");
}
