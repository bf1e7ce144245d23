#include "Distance/SharpContour.h"
#include "DistanceTrials.h"
#include "Evaluation/MeshCheck.h"
#include "Grid/ParallelFor.h"
#include "RandomTree.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"
#include "TrialTimes.h"

#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr double VoxelsMm[] = { 0.5, 0.7, 1.0 };
constexpr double HalfMm = 6.0; ///< shapes without an end are cut off by the grid

struct Tree
{
  SolidPointer solid;
  GridGeometry grid;
  TriangleMesh mesh;
  Timing time{};
  bool thrown = false;
  // What is found:
  bool fellBack = false, sound = false, crossed = false;
  double squares = 0.0; ///< of the points' values, voxels
};

Tree Contoured(std::uint32_t seed, double voxelMm)
{
  RandomTreeSettings settings;
  settings.depth = 1 + static_cast<int>(seed % 4);
  settings.latticeMm = voxelMm; // shared planes, touching faces and slots lie on grid points
  Tree tree;
  tree.solid = SolidOf(RandomTree(seed, settings));
  tree.grid = TrialGrid(2 * static_cast<int>(std::ceil(HalfMm / voxelMm)) + 1, voxelMm);
  tree.time = TimeOf(
    [&]
    {
      try
      {
        tree.mesh = SharpContour(*tree.solid, tree.grid);
      }
      catch (const std::runtime_error&)
      {
        tree.thrown = true;
      }
    });
  return tree;
}

/// A sample that is well inside: something had to come.
bool HoldsSomething(const Tree& tree)
{
  const glm::ivec3 n = tree.grid.dims;
  for (int k = 1; k < n.z - 1; ++k)
    for (int j = 1; j < n.y - 1; ++j)
      for (int i = 1; i < n.x - 1; ++i)
        if (tree.solid->At(tree.grid.IndexToWorld(glm::dvec3(i, j, k))) <
            -0.1 * tree.grid.spacing.x)
          return true;
  return false;
}

void Check(Tree& tree)
{
  if (tree.mesh.triangles.empty())
  {
    tree.fellBack = tree.thrown || HoldsSomething(tree);
    return;
  }
  std::size_t points = 0;
  double squares = 0.0;
  for (glm::dvec3& point : tree.mesh.points)
  {
    const glm::dvec3 index = tree.grid.WorldToIndex(point);
    const glm::dvec3 toBorder = glm::min(index, glm::dvec3(tree.grid.dims - 1) - index);
    if (std::min({ toBorder.x, toBorder.y, toBorder.z }) > 0.2) // not where the grid cuts it off
    {
      const double voxels = tree.solid->At(point) / tree.grid.spacing.x;
      squares += voxels * voxels;
      ++points;
    }
    point = glm::dvec3(glm::vec3(point)); // as an STL file keeps it
  }
  tree.squares = squares / static_cast<double>(std::max<std::size_t>(1, points));
  const TriangleMesh stl = WeldPoints(tree.mesh);
  tree.sound = CheckMesh(stl).Sound();
#if HASP_WITH_CGAL
  tree.crossed = !tree.sound || CountSelfIntersections(stl) > 0;
#endif
}

struct Sum
{
  int trees = 0, meshes = 0, empty = 0, fellBack = 0, unsound = 0, crossed = 0;
  std::size_t triangles = 0;
  double squares = 0.0;
  Timing time{};
  std::string failed{}; ///< "seed@voxel", a few

  void Add(const Tree& tree, std::uint32_t seed)
  {
    ++this->trees;
    this->time.wallS += tree.time.wallS;
    this->time.cpuS += tree.time.cpuS;
    this->fellBack += tree.fellBack;
    const bool none = tree.mesh.triangles.empty();
    this->empty += none && !tree.fellBack;
    this->meshes += !none;
    this->triangles += tree.mesh.triangles.size();
    this->squares += tree.squares;
    this->unsound += !none && !tree.sound;
    this->crossed += !none && tree.crossed;
    if ((tree.fellBack || (!none && (!tree.sound || tree.crossed))) && this->failed.size() < 80)
    {
      char text[40];
      std::snprintf(text, sizeof text, " %u@%g", seed, tree.grid.spacing.x);
      this->failed += text;
    }
  }
};

ReportRow RowOf(const Sum& sum, const char* id, double share, const char* asked)
{
  ReportRow row;
  row.id = id;
  row.value = share;
  row.unit = "share";
  row.rival = asked;
  row.error = std::sqrt(sum.squares / std::max(1, sum.meshes));
  row.errorUnit = "voxel RMS of points off the surface";
  row.timeS = sum.time.wallS;
  row.cpuS = sum.time.cpuS;
  row.n = sum.trees;
  char text[300];
  std::snprintf(text, sizeof text,
    "%d random trees at voxels of 0.5, 0.7 and 1 mm, half of their shapes and all slots on the "
    "grid's planes: %d meshes of %zu triangles, %d empty; as floats of an STL file",
    sum.trees / 3, sum.meshes, sum.triangles, sum.empty);
  row.data = text + (sum.failed.empty() ? "" : "; failed, seed@voxel:" + sum.failed);
  return row;
}

} // namespace

void TryContour(ReportContext& context, int count)
{
  const auto trees = static_cast<std::uint32_t>(count);
  const auto first = static_cast<std::uint32_t>(context.settings.seed * 100'000);
  constexpr std::uint32_t Batch = 20;
  Sum sum;
  for (std::uint32_t begin = 0; begin < trees; begin += Batch)
  {
    context.progress(static_cast<double>(begin) / trees, "");
    std::vector<Tree> batch;
    const std::uint32_t end = std::min(trees, begin + Batch);
    for (std::uint32_t n = begin; n < end; ++n)
      for (const double voxelMm : VoxelsMm)
        batch.push_back(Contoured(first + n, voxelMm));
    ParallelFor(0, static_cast<std::int64_t>(batch.size()), 1,
      [&](std::int64_t low, std::int64_t high)
      {
        for (std::int64_t n = low; n < high; ++n)
          Check(batch[n]);
      });
    for (std::size_t n = 0; n < batch.size(); ++n)
      sum.Add(batch[n], first + begin + static_cast<std::uint32_t>(n / 3));
  }
  const auto share = [&](int bad)
  { return 1.0 - static_cast<double>(bad) / std::max(1, sum.meshes); };
  ReportRow manifold = RowOf(sum, "contour.manifold", share(sum.unsound),
    "closed, two triangles an edge, one fan a point, all turned outwards, none without area");
  manifold.bars = { { 1.0, {} } };
  ReportRow crossing = RowOf(sum, "contour.crossing", share(sum.crossed),
    "no two triangles meet but in a shared edge or point, by CGAL's exact predicates");
  crossing.bars = { { 1.0, {} } };
#if !HASP_WITH_CGAL
  crossing = AbsentRow("contour.crossing", "CGAL's exact predicates",
    "self-intersections not checked: this build has no CGAL (HASP_ENABLE_CGAL)");
#endif
  ReportRow fallback =
    RowOf(sum, "contour.fallback", static_cast<double>(sum.fellBack) / std::max(1, sum.trees),
      "none: where the sharp contour gives up, or leaves out what a sample holds, it failed");
  fallback.bars = { { {}, 0.0 } };
  context.report.rows.insert(context.report.rows.end(), { manifold, crossing, fallback });
}

} // namespace hasp
