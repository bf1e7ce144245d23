// Points of a shell that a millisecond of one core's time allows, and how far the results lie
// apart. Usage: BenchKernelHaptics [rounds, default 15] [points, default 20000]
//
// A bumpy ball against itself, turned and moved by half a voxel: half of the points in contact,
// each level in Morton order. Processor time of this thread; all contestants take turns and the
// best round of each counts, for the neighbours of a host are noisy. Rivals read floats in one
// array; the ratio is to the first of them. Run it with nice -n -20.
#include "Benchmark/ContactRivals.h"
#include "Haptics/ContactForce.h"
#include "Haptics/CostModel.h"
#include "Haptics/PointShell.h"
#include "Testing/SampledDistance.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string>

namespace
{

using namespace hasp;

double CpuMilliseconds()
{
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// The bumpy ball in a volume of n^3 samples, 1 mm apart, and its shell with half of its points
/// pressed in.
struct Bench
{
  Bench(int samples, int count)
    : n(samples),
      distance(hasp::testing::BumpyBall(0.3 * samples, 0.006 * samples)),
      grid(hasp::testing::CubeGrid(samples)),
      sampled(distance, grid),
      map(sampled.View(), { .reference = true }),
      shell(PointShell::OfSurface(sampled.View(), glm::dvec3(0.0), { .points = count })),
      pose{ { 0.25, -0.2, 0.3 }, TurnBy({ 0.02, -0.01, 0.015 }) }
  {
    const int last = this->shell->Levels() - 1;
    this->count = this->shell->LevelEnd(last);
    this->area = static_cast<float>(this->shell->SurfaceArea() / this->count);
    for (int level = 0; level <= last; ++level)
    {
      ContactPoints points = this->shell->Level(level);
      points.area = this->area;
      this->runs.push_back(points);
      for (std::uint32_t p = 0; p < points.count; ++p)
        if (points.x[p] != ContactPoints::FarAway)
          this->structures.push_back({ { points.x[p], points.y[p], points.z[p] },
            { points.nx[p], points.ny[p], points.nz[p] } });
    }
  }

  int n;
  hasp::testing::DistanceFunction distance;
  GridGeometry grid;
  hasp::testing::SampledDistance sampled;
  DistanceMap map;
  std::shared_ptr<const PointShell> shell;
  RigidPose pose;
  std::uint32_t count = 0;
  float area = 0.0F;
  std::vector<ContactPoints> runs;
  std::vector<rival::Point> structures;
};

struct Contestant
{
  std::string name;
  std::function<ContactSums()> feel;
  ContactSums sums;
  double best = std::numeric_limits<double>::infinity();
};

ContactSums FromRival(const rival::Sums& from)
{
  ContactSums sums;
  sums.contact = { glm::dvec3(from.force), glm::dvec3(from.torque) };
  std::copy(std::begin(from.matrix), std::end(from.matrix), sums.matrix.begin());
  sums.contacts = static_cast<std::uint32_t>(from.contacts);
  return sums;
}

void Compete(std::vector<Contestant>& all, int rounds)
{
  constexpr int Repeats = 3;
  for (int round = 0; round < rounds; ++round)
    for (Contestant& one : all)
    {
      one.sums = one.feel(); // warm
      const double start = CpuMilliseconds();
      for (int n = 0; n < Repeats; ++n)
        one.sums = one.feel();
      one.best = std::min(one.best, (CpuMilliseconds() - start) / Repeats);
    }
}

void Report(const Bench& bench, ContactTerms terms, int rounds)
{
  const DistanceMapView<std::int16_t> map = bench.map.View();
  const ContactRuns runs = std::span<const ContactPoints>(bench.runs);
  const ContactSettings settings{ .attraction = 0.01F, .captureMm = 3.0F };
  const ContactPlacement placement{ bench.pose };
  const rival::Map volume{ bench.sampled.samples.data(), bench.grid.dims,
    glm::vec3(bench.grid.origin), 1.0F };
  const rival::Pose pose{ glm::mat3(glm::mat3_cast(bench.pose.orientation)),
    glm::vec3(bench.pose.position) };
  const float k = settings.stiffness * bench.area;
  std::vector<Contestant> all;
  if (terms == ContactTerms::Force)
  {
    all.push_back({ "rival -O2",
      [&] { return FromRival(rival::o2::Force(bench.structures, pose, volume, k)); }, {} });
    all.push_back({ "rival -O3 native",
      [&] { return FromRival(rival::native::Force(bench.structures, pose, volume, k)); }, {} });
  }
  else
  {
    all.push_back({ "rival -O2",
      [&] { return FromRival(rival::o2::Matrix(bench.structures, pose, volume, k)); }, {} });
    all.push_back({ "rival -O3 native",
      [&] { return FromRival(rival::native::Matrix(bench.structures, pose, volume, k)); }, {} });
  }
  for (const ContactKernels& kernels : AllContactKernels())
    all.push_back({ kernels.name,
      [&, kernels]
      {
        ContactSums sums;
        kernels[terms](runs, placement, map, settings, sums);
        return sums;
      },
      {} });
  Compete(all, rounds);

  ContactSums truth;
  ContactForceReference(terms, runs, placement, bench.map.Reference(), settings, truth);
  const char* names[] = { "force", "gradient + 6x6", "snap" };
  std::printf("%d^3, %s: %u points, %.0f%% in contact, %.0f mm^2 attracted\n", bench.n,
    names[static_cast<int>(terms)], bench.count,
    100.0 * truth.contacts / static_cast<double>(bench.count), truth.attractedArea);
  std::printf("  %-18s %10s %8s %12s %12s\n", "", "points/ms", "ratio", "force error", "to scalar");
  const double count = static_cast<double>(bench.count);
  const glm::dvec3 scalar = all[2].sums.contact.force;
  for (const Contestant& one : all)
  {
    const glm::dvec3 force = one.sums.contact.force;
    std::printf("  %-18s %10.0f %8.2f %12.1e %12.1e\n", one.name.c_str(), count / one.best,
      all[0].best / one.best,
      glm::length(force - truth.contact.force) / glm::length(truth.contact.force),
      glm::length(force - scalar) / glm::length(scalar));
  }
}

} // namespace

int main(int argc, char** argv)
{
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 15;
  const int points = argc > 2 ? std::atoi(argv[2]) : 20'000;
  if (rounds < 1 || points < 1)
  {
    std::fprintf(stderr, "rounds and points must be at least 1\n");
    return 1;
  }
  std::printf("fastest here: %s\n", FastestContactKernels().name);
  for (const int n : { 128, 256 })
  {
    const Bench bench(n, points);
    for (const ContactTerms terms :
      { ContactTerms::Force, ContactTerms::Matrix, ContactTerms::Snap })
      Report(bench, terms, rounds);
  }
  return 0;
}
