// Error against time of the phantom: its samples by boxes against sample by sample (identical or it
// says so), and its distances, with the share that is proven.
// Usage: BenchKernelPhantom [samples per axis of the boxes, default 512] [of the plain way, 128]
#include "Grid/Phantom.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace
{

using Clock = std::chrono::steady_clock;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double PeakMiB()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.0;
}

/// Both ways on one grid.
void CompareWays(int side, const hasp::PhantomSettings& settings, const char* what)
{
  const hasp::GridGeometry grid = hasp::PhantomGridOfSize(glm::ivec3(side), settings);
  std::vector<std::int16_t> boxes(grid.Size()), plain(grid.Size());
  auto start = Clock::now();
  hasp::SamplePhantomSlab(grid, settings, 0, side, boxes);
  const double byBoxes = SecondsSince(start);
  start = Clock::now();
  hasp::SamplePhantomPlainly(grid, settings, 0, side, plain);
  const double plainly = SecondsSince(start);
  std::size_t different = 0;
  for (std::size_t n = 0; n < boxes.size(); ++n)
    different += boxes[n] != plain[n];
  std::printf("%-24s %5d^3  boxes %8.3f s  plain %8.3f s  ratio %6.1f  samples that differ %zu\n",
    what, side, byBoxes, plainly, plainly / byBoxes, different);
}

/// A large volume in slabs of 16 slices: time and memory.
void SampleInSlabs(int side)
{
  const hasp::GridGeometry grid = hasp::PhantomGridOfSize(glm::ivec3(side));
  std::vector<std::int16_t> slab(std::size_t(side) * side * 16);
  const auto start = Clock::now();
  for (int k = 0; k < side; k += 16)
  {
    const int last = std::min(k + 16, side);
    hasp::SamplePhantomSlab(
      grid, {}, k, last, std::span(slab).first(std::size_t(side) * side * (last - k)));
  }
  const double spent = SecondsSince(start);
  std::printf("slabs of 16 slices       %5d^3  %8.3f s  %8.1f million samples/s  peak %.0f MiB\n",
    side, spent, 1e-6 * double(grid.Size()) / spent, PeakMiB());
}

void MeasureDistances(hasp::PhantomAnatomy anatomy, const char* what)
{
  hasp::PhantomSettings settings;
  settings.anatomy = anatomy;
  const hasp::AnalyticSolid solid = hasp::PhantomSolid(settings);
  const hasp::Box box = solid.Bounds();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(0, 1);
  std::vector<glm::dvec3> points;
  while (points.size() < 20000)
  {
    const glm::dvec3 share(any(random), any(random), any(random));
    const glm::dvec3 p = box.low - 3.0 + (box.high - box.low + 6.0) * share;
    if (std::abs(solid.Bound(p).mm) <= 3.0)
      points.push_back(p);
  }
  const auto start = Clock::now();
  std::size_t proven = 0;
  double most = 0.0;
  for (const glm::dvec3& p : points)
  {
    const hasp::SolidDistance d = solid.Distance(p);
    proven += d.errorMm == 0.0;
    most = std::max(most, d.errorMm);
  }
  std::printf("distances, %-12s within 3 mm: %.2f %% proven, else at most %.2f mm too large; "
              "%.1f us each, %zu shapes\n",
    what, 100.0 * double(proven) / double(points.size()), most,
    1e6 * SecondsSince(start) / double(points.size()), solid.ShapeCount());
}

} // namespace

int main(int argc, char** argv)
{
  const int side = argc > 1 ? std::atoi(argv[1]) : 512, small = argc > 2 ? std::atoi(argv[2]) : 128;
  if (side < 2 || side > 2048 || small < 2 || small > 512)
  {
    std::fprintf(stderr, "samples per axis: 2 to 2048, and 2 to 512 for the plain way\n");
    return 1;
  }
  SampleInSlabs(side);
  CompareWays(small, {}, "head");
  hasp::PhantomSettings faults;
  faults.blurMm = glm::dvec3(0.5);
  faults.noiseHU = 20.0;
  CompareWays(small, faults, "head, blur and noise");
  MeasureDistances(hasp::PhantomAnatomy::Head, "head");
  MeasureDistances(hasp::PhantomAnatomy::Fibula, "fibula");
  return 0;
}
