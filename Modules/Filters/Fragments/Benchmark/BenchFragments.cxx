// bin/BenchFragments [samples a side, default 256] [fragments a side, default 4]
//
// What n^3 fragments of a box of bone cost, beside the same bone as one fragment: time, samples of
// grids, memory that stays and the most there was meanwhile. Each line is a process's own, since
// the most memory of a process never falls.
#include "BrokenBall.h"

#include "Grid/Stopwatch.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

double MostMiB()
{
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return double(use.ru_maxrss) / 1024.0;
}

double CpuSeconds()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

void Measure(int side, int fragments, const char* what, const hasp::FragmentWants& wants)
{
  const hasp::testing::LabelledScan scan = hasp::testing::Cuboids(fragments,
    hasp::testing::GridAt(glm::ivec3(side), glm::dvec3(0.5), glm::dmat3(1.0), glm::dvec3(0.0)),
    0.5 * 0.45 * side);
  const double before = MostMiB();
  const hasp::Stopwatch time;
  const double cpu = CpuSeconds();
  hasp::FragmentModels models(scan.Scan());
  const double first = time.Milliseconds();
  std::vector<std::uint16_t> labels;
  for (const hasp::FragmentLabel& there : models.Labels())
    labels.push_back(there.label);
  const auto work = models.Begin(labels, wants);
  work->Run();
  if (wants.cells)
    models.Cells();
  std::printf("%3zu %-15s %8.2f s %8.2f s CPU %7.2f samples of the volume's %8.1f MiB stay %8.1f "
              "MiB more at most (labels %.0f ms)\n",
    labels.size(), what, time.Milliseconds() / 1000.0, CpuSeconds() - cpu,
    double(work->Samples()) / double(scan.Samples.size()),
    double(hasp::testing::UseOf(models, "").bytes) / 1048576.0, MostMiB() - before, first);
}

/// An edit of 9^3 voxels.
void MeasureEdit(int side, int fragments)
{
  hasp::testing::LabelledScan scan = hasp::testing::Cuboids(fragments,
    hasp::testing::GridAt(glm::ivec3(side), glm::dvec3(0.5), glm::dmat3(1.0), glm::dvec3(0.0)),
    0.5 * 0.45 * side);
  hasp::FragmentModels models(scan.Scan());
  models.Cells();
  const glm::ivec3 middle(side / 2);
  for (int k = -4; k <= 4; ++k)
    for (int j = -4; j <= 4; ++j)
      for (int i = -4; i <= 4; ++i)
        scan.Label(middle + glm::ivec3(i, j, k)) = 2;
  const hasp::Stopwatch time;
  const std::size_t changed = models.LabelsChanged(middle - 4, middle + 4).size();
  const double said = time.Milliseconds();
  models.Cells();
  std::printf(
    "an edit of 9^3 voxels: %zu labels changed, known in %.2f ms; cells' labels anew in %.1f ms\n",
    changed, said, time.Milliseconds() - said);
}

void InAProcess(const auto& work)
{
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0)
  {
    work();
    std::fflush(stdout);
    _exit(0);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0)
    std::printf("a measurement ended early\n");
}

} // namespace

int main(int argc, char* argv[])
{
  const int side = argc > 1 ? std::atoi(argv[1]) : 256,
            fragments = argc > 2 ? std::atoi(argv[2]) : 4;
  if (side < 16 || side > 1024 || fragments < 1 || fragments > 16)
    return std::fprintf(
             stderr, "BenchFragments [samples a side, 16 to 1024] [fragments a side, 1 to 16]\n"),
           1;
  std::printf("%d^3 samples of int16, 0.5 mm\n", side);
  for (const int n : { 1, fragments })
    for (const auto& [what, wants] : { std::pair("cells", hasp::FragmentWants{ .cells = true }),
           std::pair("distance maps", hasp::FragmentWants{ .map = true }),
           std::pair("pointshells", hasp::FragmentWants{ .shell = true }),
           std::pair("closed surfaces", hasp::FragmentWants{ .surface = true }),
           std::pair("all", hasp::FragmentWants{ true, true, true, true }) })
      InAProcess([&] { Measure(side, n, what, wants); });
  InAProcess([&] { MeasureEdit(side, fragments); });
  return 0;
}
