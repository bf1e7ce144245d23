// What is made when, by how many threads, and what is said of it.
#include "BrokenBall.h"

#include "Grid/ThreadLimit.h"
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellAttributes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <limits>
#include <string>
#include <thread>

namespace
{

using hasp::FragmentModels;
using hasp::testing::BrokenBall;
using hasp::testing::LabelledScan;
using hasp::testing::UseOf;

std::string Refusal(const auto& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "nothing was refused";
}

BrokenBall SmallBall()
{
  return { { 24, 23, 22 }, { 0.5, 0.6, 0.7 }, hasp::testing::SkewAxes(false), 0, 5.0 };
}

/// 27 cuboids of about 6 voxels' side.
LabelledScan ManyCuboids()
{
  return hasp::testing::Cuboids(
    3, hasp::testing::GridAt({ 24, 24, 24 }, { 1.0, 1.0, 1.0 }, glm::dmat3(1.0), { 1, 2, 3 }), 9.3);
}

/// 8 of them, and settings that make their models quickly.
LabelledScan FewCuboids()
{
  return hasp::testing::Cuboids(
    2, hasp::testing::GridAt({ 16, 16, 16 }, { 1.0, 1.0, 1.0 }, glm::dmat3(1.0), { 1, 2, 3 }), 6.3);
}
const hasp::FragmentSettings Quick{ .rangeMm = 3.0, .shellPoints = 400 };

std::vector<std::uint16_t> NumbersOf(const FragmentModels& models)
{
  std::vector<std::uint16_t> numbers;
  for (const hasp::FragmentLabel& fragment : models.Labels())
    numbers.push_back(fragment.label);
  return numbers;
}

/// All that can be told of models, as bytes.
std::string BytesOf(const hasp::FragmentModel& model)
{
  std::string bytes;
  const auto add = [&](const void* data, std::size_t count)
  { bytes.append(static_cast<const char*>(data), count); };
  if (model.map)
  {
    const auto view = model.map->View();
    const std::size_t blocks = std::size_t(view.blocks.x) * view.blocks.y * view.blocks.z;
    add(view.firstSample, blocks * sizeof(view.firstSample[0]));
    for (std::size_t b = 0; b < blocks; ++b)
      add(view.samples + view.firstSample[b], view.Slice * view.Row * sizeof(view.samples[0]));
    add(&view.indexOfOrigin, sizeof(view.indexOfOrigin));
  }
  for (int level = 0; model.shell && level < model.shell->Levels(); ++level)
  {
    const hasp::ContactPoints points = model.shell->Level(level);
    for (const float* values : { points.x, points.y, points.z, points.nx, points.ny, points.nz })
      add(values, points.count * sizeof(float));
  }
  if (model.surface)
  {
    add(model.surface->points.data(), model.surface->points.size() * sizeof(glm::dvec3));
    add(model.surface->triangles.data(), model.surface->triangles.size() * sizeof(glm::uvec3));
  }
  return bytes;
}

TEST(FragmentModels, WhatIsNoScanWithLabelsIsRefused)
{
  const BrokenBall ball = SmallBall();
  hasp::FragmentScan scan = ball.scan.Scan();
  scan.labels.geometry.origin.y += 0.3;
  EXPECT_NE(Refusal([&] { FragmentModels{ scan }; }).find("origin"), std::string::npos);
  scan.labels.geometry = ball.scan.Grid;
  scan.labels.geometry.dims.x -= 1;
  EXPECT_NE(Refusal([&] { FragmentModels{ scan }; }).find("size"), std::string::npos);
  scan = ball.scan.Scan();
  scan.labels.data = nullptr;
  EXPECT_NE(Refusal([&] { FragmentModels{ scan }; }).find("no samples"), std::string::npos);
  scan = ball.scan.Scan();
  scan.isovalue = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(Refusal([&] { FragmentModels{ scan }; }).find("isovalue"), std::string::npos);
  scan = ball.scan.Scan();
  for (const auto& [settings, name] :
    { std::pair(hasp::FragmentSettings{ .spacingMm = -1.0 }, "spacingMm is -1"),
      std::pair(hasp::FragmentSettings{ .rangeMm = 0.1 }, "rangeMm is 0.1"),
      std::pair(hasp::FragmentSettings{ .shellPoints = 0 }, "shellPoints is 0") })
    EXPECT_NE(Refusal([&] { FragmentModels(scan, settings); }).find(name), std::string::npos)
      << Refusal([&] { FragmentModels(scan, settings); });
  hasp::GridGeometry flat = ball.scan.Grid;
  flat.dims.z = 1;
  EXPECT_NE(Refusal(
              [&]
              {
                FragmentModels(
                  { hasp::GridView<const std::int16_t>{ ball.scan.Samples.data(), flat },
                    { ball.scan.Labels.data(), flat }, {}, {}, 226.0 });
              })
              .find("2 or more"),
    std::string::npos);
}

TEST(FragmentModels, ALabelThatIsNotThereIsSaidAndWhichAre)
{
  const BrokenBall ball = SmallBall();
  FragmentModels models(ball.scan.Scan());
  for (const std::uint16_t absent : { 0, 1, 4, 65535 })
  {
    const std::string said = Refusal([&] { models.Map(absent); });
    EXPECT_EQ(
      said, "label " + std::to_string(absent) + " is not in the label map, which holds 2, 3");
    EXPECT_EQ(Refusal([&] { models.Surface(absent); }), said);
    models.Release(absent);
  }
  const std::uint16_t some[] = { 2, 9 };
  EXPECT_NE(
    Refusal([&] { models.Prepare(some, hasp::AllOfFragment); }).find("label 9"), std::string::npos);
  EXPECT_EQ(UseOf(models, "").bytes, 0U) << "refused before the work";
  LabelledScan many = ManyCuboids();
  EXPECT_NE(Refusal([&] { FragmentModels(many.Scan()).Map(99); }).find("... (27 in all)"),
    std::string::npos);
  std::fill(many.Labels.begin(), many.Labels.end(), std::uint16_t(0));
  EXPECT_NE(
    Refusal([&] { FragmentModels(many.Scan()).Map(2); }).find("holds none"), std::string::npos);
}

TEST(FragmentModels, LabelsAreSaidWithTheirBoxes)
{
  const LabelledScan scan = ManyCuboids();
  const std::vector<hasp::FragmentLabel> labels = FragmentModels(scan.Scan()).Labels();
  ASSERT_EQ(labels.size(), 27U);
  std::size_t voxels = 0;
  for (std::size_t n = 0; n < labels.size(); ++n)
  {
    EXPECT_EQ(labels[n].label, 2 + n);
    const glm::ivec3 size = labels[n].high - labels[n].low + 1;
    EXPECT_EQ(labels[n].voxels, std::size_t(size.x) * size.y * size.z) << "a cuboid";
    voxels += labels[n].voxels;
  }
  EXPECT_EQ(voxels, std::size_t(scan.Labels.size()) -
                      std::size_t(std::count(scan.Labels.begin(), scan.Labels.end(), 0)));
}

// A scene pays for what it asks for.
TEST(FragmentModels, NothingIsThereBeforeItIsAskedFor)
{
  const BrokenBall ball = SmallBall();
  FragmentModels models(ball.scan.Scan(), Quick);
  hasp::ResourceList list;
  models.ListResources(list);
  ASSERT_EQ(list.size(), 1U + 2U * 3U);
  for (const hasp::ResourceUse& use : list)
  {
    EXPECT_EQ(use.bytes, 0U) << use.resource;
    EXPECT_EQ(use.milliseconds, 0.0) << use.resource;
    EXPECT_EQ(use.reason, "not asked for") << use.resource;
  }
  EXPECT_FALSE(models.HasCells());
  const auto map = models.Map(3);
  const hasp::ResourceUse made = UseOf(models, "fragment 3 distance map");
  EXPECT_GT(made.bytes, 1000U);
  EXPECT_GT(made.milliseconds, 0.0);
  EXPECT_EQ(made.reason, "asked for");
  EXPECT_EQ(UseOf(models, "").bytes, made.bytes) << "nothing else";
  EXPECT_EQ(UseOf(models, "").milliseconds, made.milliseconds);
  EXPECT_EQ(models.Finished(3).map, map);
  EXPECT_EQ(models.Finished(3).shell, nullptr);
  EXPECT_EQ(models.Finished(2).map, nullptr);
  EXPECT_EQ(models.Map(3), map) << "made once";
  models.Release(3, { .shell = true });
  EXPECT_EQ(models.Finished(3).map, map) << "only what is named";
  models.Release(3);
  const hasp::ResourceUse gone = UseOf(models, "fragment 3 distance map");
  EXPECT_EQ(gone.bytes, 0U);
  EXPECT_EQ(gone.milliseconds, 0.0);
  EXPECT_EQ(gone.reason, "released");
  EXPECT_EQ(map.use_count(), 1) << "who shares it keeps it";
}

TEST(FragmentModels, PrepareMakesWhatIsWantedAndNoMore)
{
  const BrokenBall ball = SmallBall();
  FragmentModels models(ball.scan.Scan(), Quick);
  const std::uint16_t both[] = { 2, 3, 2 };
  const auto first = models.Map(2);
  double last = 0.0;
  models.Prepare(both, { .map = true, .surface = true, .cells = true },
    [&](double share)
    {
      EXPECT_GE(share, last - 1e-12);
      EXPECT_LE(share, 1.0);
      last = share;
      return true;
    });
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(models.Finished(2).map, first) << "not made again";
  for (const std::uint16_t label : { 2, 3 })
  {
    EXPECT_NE(models.Finished(label).map, nullptr);
    EXPECT_NE(models.Finished(label).surface, nullptr);
    EXPECT_EQ(models.Finished(label).shell, nullptr);
    EXPECT_EQ(UseOf(models, "fragment " + std::to_string(label) + " pointshell").bytes, 0U);
  }
  EXPECT_TRUE(models.HasCells());
  models.ReleaseCells();
  EXPECT_FALSE(models.HasCells());
  EXPECT_EQ(UseOf(models, "fragment cells").bytes, 0U);
  models.Prepare(both, { .map = true }, [](double share) { return share == 1.0; });
}

// The same bytes, whatever was asked for before, alone or together, on any number of threads.
TEST(FragmentModels, TheSameBytesInAnyOrderAndOnAnyNumberOfThreads)
{
  const LabelledScan scan = FewCuboids();
  FragmentModels one(scan.Scan(), Quick);
  const std::vector<std::uint16_t> labels{ 2, 5, 9 };
  std::vector<std::string> truth;
  hasp::WithThreadLimit(1,
    [&]
    {
      for (const std::uint16_t label : labels)
      {
        one.Shell(label);
        one.Surface(label);
        one.Map(label);
        truth.push_back(BytesOf(one.Finished(label)));
        ASSERT_GT(truth.back().size(), 1'000U);
      }
    });
  for (const int threads : { 1, 2, 4 })
  {
    FragmentModels many(scan.Scan(), Quick);
    hasp::WithThreadLimit(threads, [&] { many.Prepare(labels, hasp::AllOfFragment); });
    for (std::size_t n = 0; n < labels.size(); ++n)
      EXPECT_EQ(BytesOf(many.Finished(labels[n])), truth[n]) << threads << ", " << labels[n];
  }
}

TEST(FragmentModels, ACancelledBakeLeavesNothingInPart)
{
  const LabelledScan scan = FewCuboids();
  constexpr hasp::FragmentWants Wanted{ .map = true, .surface = true };
  FragmentModels whole(scan.Scan(), Quick);
  const std::vector<std::uint16_t> labels = NumbersOf(whole);
  whole.Prepare(labels, Wanted);
  for (const double until : { 0.0, 0.5 })
  {
    FragmentModels models(scan.Scan(), Quick);
    hasp::WithThreadLimit(2, // with one for each fragment all would be done at once
      [&]
      {
        EXPECT_THROW(models.Prepare(labels, Wanted, [&](double share) { return share < until; }),
          hasp::Cancelled);
      });
    std::size_t done = 0;
    for (const std::uint16_t label : labels)
    {
      const hasp::FragmentModel made = models.Finished(label);
      if (made.map || made.surface)
      {
        EXPECT_EQ(BytesOf(made), BytesOf(whole.Finished(label))) << "all of it, or nothing";
        ++done;
      }
    }
    EXPECT_LT(done, labels.size());
    EXPECT_EQ(done > 0, until > 0.0) << "what was done stays";
    models.Prepare(labels, Wanted);
    for (const std::uint16_t label : labels)
      EXPECT_EQ(BytesOf(models.Finished(label)), BytesOf(whole.Finished(label)));
  }
  FragmentModels models(scan.Scan(), Quick);
  EXPECT_THROW(models.Cells([](double) { return false; }), hasp::Cancelled);
  EXPECT_FALSE(models.HasCells());
  EXPECT_THROW(models.Surface(5, [](double) { return false; }), hasp::Cancelled);
  EXPECT_EQ(models.Finished(5).surface, nullptr);
}

// RENDER looks at what is there while a WORKER makes more.
TEST(FragmentModels, WhatIsFinishedIsReadWhileMoreIsMade)
{
  const LabelledScan scan = FewCuboids();
  FragmentModels models(scan.Scan(), Quick);
  const std::vector<std::uint16_t> labels = NumbersOf(models);
  const auto work = models.Begin(labels, { .surface = true, .cells = true });
  std::atomic<bool> done{ false };
  std::thread worker(
    [&]
    {
      work->Run();
      done = true;
    });
  std::size_t seen = 0, before = 0;
  while (!done)
  {
    seen = 0;
    for (const std::uint16_t label : labels)
      seen += models.Finished(label).surface != nullptr;
    EXPECT_GE(seen, before);
    before = seen;
    UseOf(models, "");
  }
  worker.join();
  EXPECT_TRUE(work->Outdated().empty());
  for (const std::uint16_t label : labels)
    EXPECT_NE(models.Finished(label).surface, nullptr);
  EXPECT_TRUE(models.HasCells());
}

TEST(FragmentModels, ABakingOutlivesItsModels)
{
  const LabelledScan scan = FewCuboids();
  std::unique_ptr<hasp::FragmentBaking> work;
  {
    FragmentModels models(scan.Scan(), Quick);
    const std::uint16_t some[] = { 4, 5 };
    work = models.Begin(some, { .surface = true });
  }
  work->Run();
  EXPECT_GT(work->Samples(), 0U);
}

// All fragments in one mapper: the cells are those of the whole bone, each once, with its label.
TEST(FragmentModels, CellsOfFragmentsAreThoseOfTheBone)
{
  LabelledScan scan = ManyCuboids();
  for (std::uint16_t& label : scan.Labels)
    if (label == 7)
      label = 0; // bone that nobody named is there, too
  FragmentModels models(scan.Scan());
  const auto cells = models.Cells();
  EXPECT_EQ(models.Cells(), cells) << "made once";
  hasp::ClusteredCells truth =
    hasp::ExtractActiveCells(scan.Grey(), hasp::MinMaxBlocks(scan.Grey()), LabelledScan::Isovalue);
  hasp::AddLabels(truth, scan.LabelView());
  EXPECT_EQ(cells->clusters, truth.clusters);
  EXPECT_EQ(cells->corners, truth.corners);
  EXPECT_EQ(cells->labels, truth.labels);
  std::size_t together = 0;
  for (const std::uint16_t label : NumbersOf(models))
    together += std::size_t(std::count(cells->labels.begin(), cells->labels.end(), label));
  const auto unnamed = std::count(cells->labels.begin(), cells->labels.end(), 0);
  EXPECT_GT(unnamed, 0);
  EXPECT_EQ(together + std::size_t(unnamed), cells->Count());
  EXPECT_EQ(UseOf(models, "fragment cells").bytes, cells->Bytes());
  EXPECT_EQ(UseOf(models, "").bytes, cells->Bytes()) << "and nothing else";
}

} // namespace
