// The sharp contour of random trees, checked, and its figures beside the plain one's. Not a test.
//   BenchKernelSharpContour [trees = 1000] [first tree: no figures of sharpness] [situation, 0 to
//   4]
#include "Distance/NearSurface.h"
#include "Distance/SharpContour.h"
#include "Distance/TetrahedraContour.h"
#include "Evaluation/MeshCheck.h"
#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif
#include "Testing/MovedSolid.h"
#include "Testing/RandomSolid.h"
#include "Testing/SlottedBlock.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <tuple>

namespace
{
using Clock = std::chrono::steady_clock;
double Since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

hasp::TriangleMesh Rounded(hasp::TriangleMesh mesh)
{
  for (glm::dvec3& p : mesh.points)
    p = glm::dvec3(glm::vec3(p));
  return hasp::WeldPoints(mesh);
}

/// Where all trees of a run lie.
struct Situation
{
  const char* name;
  double scale;
  glm::dvec3 shift;
  bool turned; ///< each in another way
};

void RandomTrees(int first, int count, const Situation& situation)
{
  const double spacings[] = { 0.4, 0.5, 0.83 };
  const double scale = situation.scale;
  int meshes = 0, empty = 0, refused = 0, open = 0, crowded = 0, turned = 0, thin = 0, crossing = 0;
  std::size_t triangles = 0;
  double seconds = 0, least = 1e30, kept = 0;
  for (int n = first; n < first + count; ++n)
    for (const double spacing : spacings)
    {
      std::mt19937 random{ unsigned(n) };
      const glm::dmat3 axes = situation.turned ? hasp::AnyAxes(random) : glm::dmat3(1.0);
      const auto tree = std::make_shared<hasp::MovedSolid>(
        hasp::RandomSolid(unsigned(n) + 1, 1 + n % 4), scale, situation.shift, axes);
      // Grid points on round numbers, so that faces lie along them; and the border cuts.
      const auto grid = hasp::GridAround(situation.shift, scale * 6.0, scale * spacing);
      hasp::TriangleMesh mesh;
      const auto start = Clock::now();
      try
      {
        hasp::SharpContourFacts facts;
        mesh = hasp::SharpContour(*tree, grid, {}, &facts);
        least = std::min(least, facts.leastHeight);
        kept += double(facts.keptInside);
      }
      catch (const std::exception& error)
      {
        ++refused;
        std::printf("tree %d spacing %g: %s\n", n, spacing, error.what());
        continue;
      }
      seconds += Since(start);
      if (mesh.triangles.empty())
      {
        ++empty;
        continue;
      }
      ++meshes;
      triangles += mesh.triangles.size();
      const auto stl = Rounded(mesh);
      const auto check = hasp::CheckMesh(stl);
      const bool sound = check.Sound();
      open += !check.Closed();
      crowded += !check.TwoManifold();
      turned += !check.Outward();
      thin += check.degenerate > 0;
      std::size_t pairs = 0;
#if HASP_WITH_CGAL
      if (sound)
        pairs = hasp::CountSelfIntersections(stl);
#endif
      crossing += pairs > 0;
      if (!sound || pairs > 0)
        std::printf("tree %d spacing %g: open %zu crowded %zu pinched %zu turned %zu thin %zu "
                    "crossing %zu\n",
          n, spacing, check.borderEdges, check.crowdedEdges, check.pinchedPoints, check.turnedEdges,
          check.degenerate, pairs);
    }
  std::printf("%d trees %s: %d meshes (%d empty), %zu triangles, %.1f s; refused %d, not closed "
              "%d, not manifold %d, not outward %d, degenerate %d, self-intersecting %d; least "
              "height %.2f steps, %.2f %% kept inside\n",
    count, situation.name, meshes, empty, triangles, seconds, refused, open, crowded, turned, thin,
    crossing, least, 100.0 * kept / double(triangles));
}

void PrintSharpness(int poses)
{
  std::mt19937 random(5);
  const auto shift = [&] { return 0.4 * double(random()) / double(std::mt19937::max()) - 0.2; };
  for (const bool turned : { false, true })
  {
    hasp::Sharpness sharp, plain;
    double sharpTime = 0, plainTime = 0;
    std::size_t sharpTriangles = 0, plainTriangles = 0;
    for (int n = 0; n < poses; ++n)
    {
      hasp::SlottedBlock block;
      if (n > 0)
        block.at.x = shift(), block.at.y = shift(), block.at.z = shift();
      if (turned)
        block.axes = hasp::AnyAxes(random);
      const auto solid = block.Solid();
      const auto grid = hasp::GridAround(glm::dvec3(0), 9.2, 0.4);
      auto start = Clock::now();
      const auto mesh = hasp::SharpContour(*solid, grid);
      sharpTime += Since(start);
      sharpTriangles += mesh.triangles.size();
      sharp.KeepMost(hasp::MeasureSharpness(block, mesh));
      start = Clock::now();
      const auto samples = hasp::DenseValues(hasp::EvaluateNearSurface(*solid, grid, 1.0));
      const auto other = hasp::ContourTetrahedra({ samples.data(), grid });
      plainTime += Since(start);
      plainTriangles += other.triangles.size();
      plain.KeepMost(hasp::MeasureSharpness(block, other));
    }
    for (const auto& [name, s, time, triangles] :
      { std::tuple{ "sharp", sharp, sharpTime, sharpTriangles },
        std::tuple{ "tetrahedra", plain, plainTime, plainTriangles } })
      std::printf("%-7s %-10s at most: wall %.4f, edge radius %.4f (95%%: %.4f), at corners %.4f, "
                  "rim %.4f, hole %.4f mm; %zu triangles, %.0f ms\n",
        turned ? "turned" : "aligned", name, s.flat, s.edge, s.edge95, s.corner, s.rim, s.hole,
        triangles / poses, 1e3 * time / poses);
  }
}
} // namespace

int main(int argc, char** argv)
{
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const int trees = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int first = argc > 2 ? std::atoi(argv[2]) : 0;
#if !HASP_WITH_CGAL
  std::printf("self-intersections: not checked (HASP_ENABLE_CGAL is off)\n");
#endif
  if (argc < 3)
    PrintSharpness(27);
  const glm::dvec3 far(150, -180, 120);
  const Situation situations[] = { { "at 0", 1.0, {}, false }, { "turned", 1.0, {}, true },
    { "at 150 -180 120", 1.0, far, false },
    { "turned, 0.125 as large, at 150 -180 120", 0.125, far, true },
    { "0.08 as large, at 300 -400 200", 0.08, { 300, -400, 200 }, false } };
  for (int n = 0; n < 5; ++n)
    if (argc < 4 || std::atoi(argv[3]) == n)
      RandomTrees(first, trees, situations[n]);
}
