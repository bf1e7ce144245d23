// What runs in a tick takes no memory: the global operator is replaced by one that counts.
#include "Grid/Testing/CountNew.h"
#include "Haptics/BlockKernels.h"
#include "Haptics/BlockOctree.h"
#include "Haptics/CoarsePhase.h"
#include "Haptics/DynamicPointShell.h"
#include "Haptics/Testing/SampledDistance.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp::testing;
using hasp::RigidPose;
using hasp::test::NewBytes;
using hasp::test::NewCount;

TEST(HapticDataMemory, ATickTakesNone)
{
  auto field = std::make_shared<SampledDistance>(BumpyBall(20.0, 1.5), CubeGrid(64));
  const auto map = std::make_shared<hasp::DistanceMap>(field->View());
  const auto shell = hasp::PointShell::OfSurface(field->View(), {}, { 4096, 256, 1 });
  hasp::CoarsePhase coarse(shell, map);
  const hasp::BlockOctree tool(*map, hasp::BlockOctree::Leaves::Surface);
  const hasp::BlockOctree solid(*map, hasp::BlockOctree::Leaves::Solid);
  std::vector<std::uint8_t> marks(tool.Blocks().size(), 0);
  hasp::ShellVolume volume;
  volume.grid = field->View();
  volume.blocks = std::make_shared<hasp::MinMaxBlocks>(volume.grid);
  volume.owner = field;
  volume.insideAbove = false;
  hasp::DynamicPointShell dynamic(volume, map, {});

  const std::size_t before = NewCount();
  EXPECT_GT(before, 0U); // it does count
  std::size_t near = 0, points = 0;
  for (int tick = 0; tick < 300; ++tick)
  {
    const double a = tick % 100 == 50 ? 2.0 : 0.01 * tick; // goes round, with a jump now and then
    const double apart = tick < 200 ? 38.0 : 38.0 + 0.5 * (tick - 200);
    const RigidPose pose{ apart * glm::dvec3(std::cos(a), std::sin(a), 0.0),
      hasp::TurnBy({ a, 0.0, 0.0 }) };
    const double reach = tick % 30 < 15 ? 0.0 : 3.0;
    coarse.Begin(pose, reach);
    for (int level = 0; level < shell->Levels(); ++level)
      near += coarse.Near(level).size();
    if (tick % 70 == 69)
      coarse.WakeAll();
    tool.MarkOverlaps(solid, pose, marks);
    if (tick % 40 == 39)
      dynamic.SetIsovalue(0.2 * (tick % 3));
    dynamic.Update(pose, reach);
    points += dynamic.Points().count;
    (void)map->At(pose.position);
  }
  EXPECT_EQ(NewCount(), before);
  EXPECT_GT(near, 0U);
  EXPECT_GT(points, 0U);
}

std::size_t Listed(const auto& data)
{
  hasp::ResourceList list;
  data.ListResources(list);
  std::size_t bytes = 0;
  for (const hasp::ResourceUse& use : list)
    bytes += use.bytes;
  return bytes;
}

TEST(HapticDataMemory, WhatIsListedIsWhatIsTaken)
{
  auto field = std::make_shared<SampledDistance>(BumpyBall(20.0, 1.5), CubeGrid(64));
  for (const bool reference : { false, true })
  {
    const std::size_t before = NewBytes();
    const hasp::DistanceMap map(field->View(), { 0.0, {}, reference });
    // And what it is made of: a geometry, vectors' heads, the tasks of threads.
    EXPECT_NEAR(static_cast<double>(NewBytes() - before), Listed(map), 20'000.0);
  }
  const auto map = std::make_shared<hasp::DistanceMap>(field->View());
  hasp::ShellVolume volume;
  volume.grid = field->View();
  volume.blocks = std::make_shared<hasp::MinMaxBlocks>(volume.grid);
  volume.owner = field;
  volume.insideAbove = false;
  hasp::FastestBlockKernels(); // timed once in a process, with memory that is none of a shell's
  for (const int points : { 512, 16'384 })
  {
    hasp::DynamicPointShellSettings settings;
    settings.points = points;
    const std::size_t before = NewBytes();
    const hasp::DynamicPointShell shell(volume, map, {}, settings);
    EXPECT_NEAR(static_cast<double>(NewBytes() - before), Listed(shell), 2'000.0);
  }
}

} // namespace
