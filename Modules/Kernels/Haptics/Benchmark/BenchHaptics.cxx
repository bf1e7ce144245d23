// Points of a shell that a millisecond of one core's time allows, and how far the results lie
// apart. Usage: BenchKernelHaptics [rounds, default 15] [points, default 20000]
//
// A bumpy ball against itself, turned and moved by half a voxel: half of the points in contact, in
// Morton order. All contestants take turns, each gets its best round: this host's neighbours are
// noisy. Rivals read floats in one array; the ratio is to the first of them.
#include "Benchmark/ContactRivals.h"
#include "Grid/ParallelFor.h"
#include "Haptics/ContactForce.h"
#include "Testing/ContactScenes.h"

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

std::uint64_t Spread(std::uint64_t v)
{
  std::uint64_t spread = 0;
  for (int bit = 0; bit < 21; ++bit)
    spread |= (v >> bit & 1U) << (3 * bit);
  return spread;
}

std::uint64_t Morton(const glm::dvec3& p, double half)
{
  const glm::dvec3 whole = (p / half + 1.0) * static_cast<double>(1 << 20);
  return Spread(static_cast<std::uint64_t>(whole.x)) |
         Spread(static_cast<std::uint64_t>(whole.y)) << 1U |
         Spread(static_cast<std::uint64_t>(whole.z)) << 2U;
}

/// The bumpy ball in a volume of n^3 samples, 1 mm apart.
struct Bench
{
  explicit Bench(int samples, int count)
    : n(samples),
      radius(0.3 * samples),
      grid{ glm::ivec3(samples), glm::dvec3(-0.5 * (samples - 1)), glm::dvec3(1.0),
        glm::dmat3(1.0) },
      volume(grid.Size()),
      pose{ { 0.25, -0.2, 0.3 }, TurnBy({ 0.02, -0.01, 0.015 }) }
  {
    ParallelFor(0, this->n, 1,
      [&](std::int64_t first, std::int64_t end)
      {
        for (int k = static_cast<int>(first); k < end; ++k)
          for (int j = 0; j < this->n; ++j)
            for (int i = 0; i < this->n; ++i)
              this->volume[(static_cast<std::size_t>(k) * this->n + j) * this->n + i] =
                static_cast<float>(this->Mm(this->grid.IndexToWorld({ i, j, k })));
      });
    ShellOfPoints ball;
    AddBall(ball, count, 1.0);
    const ContactPoints directions = ball.Get(1.0F);
    std::vector<std::pair<std::uint64_t, glm::dvec3>> sorted;
    for (int p = 0; p < count; ++p)
    {
      const glm::dvec3 direction(directions.x[p], directions.y[p], directions.z[p]);
      double r = this->radius;
      for (int step = 0; step < 20; ++step)
        r -= this->Mm(direction * r);
      sorted.emplace_back(Morton(direction * r, this->n), direction * r);
    }
    std::sort(
      sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [key, at] : sorted)
    {
      glm::dvec3 gradient;
      for (int axis = 0; axis < 3; ++axis)
      {
        glm::dvec3 step(0.0);
        step[axis] = 1e-4;
        gradient[axis] = this->Mm(at + step) - this->Mm(at - step);
      }
      const glm::dvec3 normal = glm::normalize(gradient);
      this->shell.Add(at, normal);
      this->structures.push_back({ glm::vec3(at), glm::vec3(normal) });
    }
    this->area = static_cast<float>(4.0 * glm::pi<double>() * this->radius * this->radius / count);
    this->points = this->shell.Get(this->area);
  }

  double Mm(const glm::dvec3& p) const { return BumpyBall(p, this->radius, 0.02 * this->radius); }

  int n;
  double radius;
  GridGeometry grid;
  std::vector<float> volume;
  RigidPose pose;
  ShellOfPoints shell;
  std::vector<rival::Point> structures;
  float area;
  ContactPoints points;
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

void Report(const Bench& bench, const DistanceMapView<std::int16_t>& map,
  const DistanceMapView<float>& reference, ContactTerms terms, int rounds)
{
  const ContactSettings settings{ .attraction = 0.01F, .captureMm = 3.0F };
  const ContactPlacement placement{ bench.pose };
  const rival::Map volume{ bench.volume.data(), bench.grid.dims, glm::vec3(bench.grid.origin),
    1.0F };
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
        kernels[terms](bench.points, placement, map, settings, sums);
        return sums;
      },
      {} });
  Compete(all, rounds);

  ContactSums truth;
  ContactForceReference(terms, bench.points, placement, reference, settings, truth);
  const char* names[] = { "force", "gradient + 6x6", "snap" };
  std::printf("%d^3, %s: %zu points, %.0f%% in contact, %.0f mm^2 attracted\n", bench.n,
    names[static_cast<int>(terms)], bench.shell.Count(),
    100.0 * truth.contacts / static_cast<double>(bench.shell.Count()), truth.attractedArea);
  std::printf("  %-18s %10s %8s %12s %12s\n", "", "points/ms", "ratio", "force error", "to scalar");
  const double count = static_cast<double>(bench.shell.Count());
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
    const auto mm = [&](const glm::dvec3& p) { return bench.Mm(p); };
    const BakedMap<std::int16_t> map(bench.grid, 16.0, mm);
    const BakedMap<float> reference(bench.grid, 16.0, mm);
    for (const ContactTerms terms :
      { ContactTerms::Force, ContactTerms::Matrix, ContactTerms::Snap })
      Report(bench, map.Get(), reference.Get(), terms, rounds);
  }
  return 0;
}
