// What it costs to make the haptic data of a body, and what the coarse phases leave to be
// evaluated. Usage: BenchKernelHapticData [points of the shell, default 20000]
//
// The coarse rows: microseconds of processor time a tick, least of 15 rounds of 200 ticks, all
// methods in turn within a round; a shell that trembles by 0.1 mm as a hand does. Evaluation is a
// plain scalar loop (distance and force), the same for all.
#include "Grid/Stopwatch.h"
#include "Haptics/BlockOctree.h"
#include "Haptics/CoarsePhase.h"
#include "Haptics/Testing/SampledDistance.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numeric>

namespace
{

using namespace hasp;
using namespace hasp::testing;
using View = DistanceMapView<std::int16_t>;

double ProcessorMicroseconds()
{
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

/// Distance in steps at an index position; 32767 outside.
float At(const View& view, const glm::vec3& index)
{
  if (!(index.x >= 0.0F && index.y >= 0.0F && index.z >= 0.0F && index.x <= view.last.x &&
        index.y <= view.last.y && index.z <= view.last.z))
    return 32767.0F;
  const glm::ivec3 cell = glm::min(glm::ivec3(index), glm::ivec3(view.last) - 1);
  const glm::vec3 t = index - glm::vec3(cell);
  const glm::ivec3 block = cell >> 3, in = cell & 7;
  const std::int16_t* p =
    view.samples + view.firstSample[(block.z * view.blocks.y + block.y) * view.blocks.x + block.x] +
    (in.z * View::Row + in.y) * View::Row + in.x;
  const auto along = [&](int o)
  { return static_cast<float>(p[o]) + t.x * static_cast<float>(p[o + 1] - p[o]); };
  const float a = along(0), b = along(View::Row), c = along(View::Slice),
              d = along(View::Slice + View::Row);
  const float low = a + t.y * (b - a), high = c + t.y * (d - c);
  return low + t.z * (high - low);
}

/// Force of all points of a run.
glm::vec3 Evaluate(const View& view, const ContactPoints& p, const RigidPose& pose)
{
  const glm::mat3 turn = glm::mat3(glm::mat3_cast(pose.orientation));
  const glm::mat3 toIndex = view.toIndex * turn;
  const glm::vec3 shift = view.toIndex * glm::vec3(pose.position) + view.indexOfOrigin;
  glm::vec3 force(0.0F);
  for (std::uint32_t n = 0; n < p.count; ++n)
  {
    const float d = At(view, toIndex * glm::vec3(p.x[n], p.y[n], p.z[n]) + shift);
    if (d < 0.0F)
      force += d * (turn * glm::vec3(p.nx[n], p.ny[n], p.nz[n]));
  }
  return force;
}

/// The finest level's points in the order of the octree's leaves.
struct LeafPoints
{
  std::vector<float> columns[6];
  std::vector<std::uint32_t> firsts; ///< of each leaf; and the end
};

LeafPoints PointsByLeaf(const PointShell& shell, const DistanceMap& map, const BlockOctree& tree)
{
  const View view = map.View();
  std::vector<std::vector<std::array<float, 6>>> byBlock(
    static_cast<std::size_t>(view.blocks.x) * view.blocks.y * view.blocks.z);
  for (int level = 0; level < shell.Levels(); ++level)
  {
    const ContactPoints p = shell.Level(level);
    for (std::uint32_t n = 0; n < p.count; ++n)
      if (p.x[n] != ContactPoints::FarAway)
      {
        const glm::ivec3 b =
          glm::ivec3(view.toIndex * glm::vec3(p.x[n], p.y[n], p.z[n]) + view.indexOfOrigin) / 8;
        byBlock[(static_cast<std::size_t>(b.z) * view.blocks.y + b.y) * view.blocks.x + b.x]
          .push_back({ p.x[n], p.y[n], p.z[n], p.nx[n], p.ny[n], p.nz[n] });
      }
  }
  LeafPoints points;
  for (const std::uint32_t block : tree.Blocks())
  {
    points.firsts.push_back(static_cast<std::uint32_t>(points.columns[0].size()));
    for (const auto& p : byBlock[block])
      for (int c = 0; c < 6; ++c)
        points.columns[c].push_back(p[c]);
  }
  points.firsts.push_back(static_cast<std::uint32_t>(points.columns[0].size()));
  return points;
}

class Scene
{
public:
  Scene(int samples, int points)
    : Body(BumpyBall(0.35 * samples, 0.02 * samples), CubeGrid(samples)),
      Map(std::make_shared<DistanceMap>(this->Body.View())),
      Shell(PointShell::OfSurface(this->Body.View(), {}, { points, 256, 1 })),
      Coarse(this->Shell, this->Map),
      Tool(*this->Map, BlockOctree::Leaves::Surface),
      Solid(*this->Map, BlockOctree::Leaves::Solid),
      Marks(this->Tool.Blocks().size()),
      ByLeaf(PointsByLeaf(*this->Shell, *this->Map, this->Tool))
  {
  }
  RigidPose PoseAt(double apart, int tick) const
  {
    const double a = 0.06 * tick; // 9.5 Hz at 1 kHz
    return { { apart + 0.1 * std::sin(a), 0.1 * std::cos(a), 0.0 },
      TurnBy({ 0.0, 0.0, 3.0 + 0.001 * std::sin(a) }) };
  }
  /// The shell's middle where its first point touches.
  double Touching() const
  {
    double far = 4.0 * this->Shell->Radius(), near = 0.0;
    while (far - near > 0.01)
      (this->Contacts(0.5 * (far + near)) > 0 ? near : far) = 0.5 * (far + near);
    return near;
  }
  std::uint32_t Contacts(double apart) const
  {
    std::uint32_t contacts = 0;
    const RigidPose pose = this->PoseAt(apart, 0);
    for (int level = 0; level < this->Shell->Levels(); ++level)
    {
      const ContactPoints p = this->Shell->Level(level);
      for (std::uint32_t n = 0; n < p.count; ++n)
        contacts += this->Map->At(pose.Place({ p.x[n], p.y[n], p.z[n] })).mm < 0.0 ? 1 : 0;
    }
    return contacts;
  }
  glm::vec3 TickOff(const RigidPose& pose)
  {
    glm::vec3 force(0.0F);
    for (int level = 0; level < this->Shell->Levels(); ++level)
      force += Evaluate(this->Map->View(), this->Shell->Level(level), pose);
    return force;
  }
  glm::vec3 TickCoarse(const RigidPose& pose)
  {
    glm::vec3 force(0.0F);
    this->Coarse.Begin(pose, 0.0);
    for (int level = 0; level < this->Shell->Levels(); ++level)
      for (const ContactPoints& run : this->Coarse.Near(level))
        force += Evaluate(this->Map->View(), run, pose);
    return force;
  }
  glm::vec3 TickOctree(const RigidPose& pose)
  {
    std::fill(this->Marks.begin(), this->Marks.end(), std::uint8_t(0));
    this->Tool.MarkOverlaps(this->Solid, pose, this->Marks);
    glm::vec3 force(0.0F);
    for (std::size_t leaf = 0; leaf < this->Marks.size(); ++leaf)
      if (this->Marks[leaf] != 0)
      {
        const std::uint32_t first = this->ByLeaf.firsts[leaf];
        const auto column = [&](int c) { return this->ByLeaf.columns[c].data() + first; };
        force += Evaluate(this->Map->View(),
          { column(0), column(1), column(2), column(3), column(4), column(5), nullptr, 1.0F,
            this->ByLeaf.firsts[leaf + 1] - first },
          pose);
      }
    return force;
  }
  void Report(const char* what, double apart)
  {
    using Tick = glm::vec3 (Scene::*)(const RigidPose&);
    const Tick ticks[] = { &Scene::TickOff, &Scene::TickCoarse, &Scene::TickOctree };
    double least[3] = { 1e300, 1e300, 1e300 };
    double sums[3] = {};
    for (int round = 0; round < 15; ++round)
      for (int method = 0; method < 3; ++method)
      {
        const double start = ProcessorMicroseconds();
        glm::vec3 force(0.0F);
        for (int tick = 0; tick < 200; ++tick)
          force += (this->*ticks[method])(this->PoseAt(apart, tick));
        least[method] = std::min(least[method], (ProcessorMicroseconds() - start) / 200.0);
        sums[method] = glm::length(glm::dvec3(force));
      }
    const double off = std::max({ std::abs(sums[1] - sums[0]), std::abs(sums[2] - sums[0]) });
    std::printf("%4d  %-10s %8u %8.1f %8.2f %8.2f %7.1f x %7.1f x   %.0e\n",
      this->Body.geometry.dims.x, what, this->Contacts(apart), least[0], least[1], least[2],
      least[0] / least[1], least[0] / least[2], off / std::max(sums[0], 1.0));
  }

private:
  SampledDistance Body;
  std::shared_ptr<const DistanceMap> Map;
  std::shared_ptr<const PointShell> Shell;
  CoarsePhase Coarse;
  BlockOctree Tool, Solid;
  std::vector<std::uint8_t> Marks;
  LeafPoints ByLeaf;
};

std::size_t BytesOf(const auto& data)
{
  ResourceList list;
  data.ListResources(list);
  return std::accumulate(list.begin(), list.end(), std::size_t(0),
    [](std::size_t sum, const ResourceUse& use) { return sum + use.bytes; });
}

void ReportMaking(int samples)
{
  const SampledDistance body(BumpyBall(0.35 * samples, 0.02 * samples), CubeGrid(samples));
  double map = 1e300, shell = 1e300;
  std::size_t mapBytes = 0, shellBytes = 0;
  for (int run = 0; run < 3; ++run)
  {
    const Stopwatch mapTime;
    mapBytes = BytesOf(DistanceMap(body.View()));
    map = std::min(map, mapTime.Milliseconds());
    const Stopwatch shellTime;
    shellBytes = BytesOf(*PointShell::OfSurface(body.View(), {}));
    shell = std::min(shell, shellTime.Milliseconds());
  }
  std::printf("%4d  map %7.1f ms %6.2f MB   shell of 65,536 points %7.1f ms %6.2f MB\n", samples,
    map, 1e-6 * static_cast<double>(mapBytes), shell, 1e-6 * static_cast<double>(shellBytes));
}

} // namespace

int main(int argc, char** argv)
{
  const int points = argc > 1 ? std::atoi(argv[1]) : 20'000;
  if (points < 1000 || points > 1'000'000)
  {
    std::fprintf(stderr, "points of the shell: 1000 to 1000000\n");
    return 2;
  }
  for (const int samples : { 128, 256 })
    ReportMaking(samples);
  std::printf(
    "grid  pose       contacts   all us   sleep   octree  all/sleep  all/octree  forces off\n");
  for (const int samples : { 128, 256 })
  {
    Scene scene(samples, points);
    const double touching = scene.Touching();
    scene.Report("separated", touching + 20.0);
    scene.Report("2 mm off", touching + 2.0);
    scene.Report("touching", touching - 1.0);
    scene.Report("pressed", touching - 5.0);
    scene.Report("inside", 2.0);
  }
  return 0;
}
