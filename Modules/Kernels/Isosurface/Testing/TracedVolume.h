#pragma once
// Volumes with a tracer over them, rays through them, and the comparison with truth.
#include "Isosurface/ActiveCells.h"
#include "Isosurface/CellTracer.h"
#include "Isosurface/Testing/TraceTruth.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <random>

namespace hasp::testing
{

constexpr double HitTolerance = 1e-3; // voxels: what drawing asks for
constexpr double Undecided = 1e-6;    // share of the largest corner: float ends there

template <typename T>
struct TracedVolume
{
  std::vector<T> samples;
  GridView<const T> view;
  AnyGridView grid;
  MinMaxBlocks blocks;
  float isovalue;
  std::shared_ptr<const ClusteredCells> cells;
  CellTracer tracer;

  TracedVolume(std::vector<T> values, const GridGeometry& g, double iso,
    CellPrecision precision = CellPrecision::Exact)
    : samples(std::move(values)),
      view{ samples.data(), g },
      grid(view),
      blocks(grid),
      isovalue(float(iso)),
      cells(std::make_shared<ClusteredCells>(ExtractActiveCells(grid, blocks, iso, precision))),
      tracer(cells)
  {
  }
};

inline GridGeometry Cube(const glm::ivec3& dims)
{
  return { dims, { -3, 4, 1 }, { 0.8, 1.1, 0.5 }, glm::dmat3(1) };
}

template <typename T>
TracedVolume<T> Noise(
  const glm::ivec3& dims, unsigned seed, CellPrecision precision = CellPrecision::Exact)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> sample(0, 200);
  const GridGeometry g = Cube(dims);
  std::vector<T> samples(g.Size());
  for (auto& v : samples)
    v = static_cast<T>(sample(random));
  return { std::move(samples), g, 99.5, precision };
}

/// A ray between two points in and around the volume.
class RandomRays
{
public:
  RandomRays(const glm::ivec3& dims, unsigned seed) : Random(seed), Size(dims - 1) {}
  CellRay Next()
  {
    const glm::dvec3 from = this->Point(0.3), to = this->Point(0.1);
    return { from, glm::normalize(to - from) };
  }

private:
  glm::dvec3 Point(double around)
  {
    std::uniform_real_distribution<double> at(-around, 1.0 + around);
    const double x = at(this->Random), y = at(this->Random), z = at(this->Random);
    return glm::dvec3(x, y, z) * this->Size;
  }
  std::mt19937 Random;
  glm::dvec3 Size;
};

template <typename T>
void ExpectTruth(const TracedVolume<T>& scene, int rays, unsigned seed, double mostUndecided = 1e-3)
{
  RandomRays next(scene.view.geometry.dims, seed);
  int hits = 0, undecided = 0;
  for (int n = 0; n < rays; ++n)
  {
    const CellRay ray = next.Next();
    const auto truth = TraceTruth(scene.view, scene.isovalue, ray.origin, ray.direction, 0, 1e9);
    const auto hit = scene.tracer.Trace(ray);
    ASSERT_EQ(scene.tracer.Occluded(ray), hit.has_value()) << n;
    if (truth.tangency < Undecided)
    {
      ++undecided;
      continue;
    }
    ASSERT_EQ(hit.has_value(), truth.t.has_value()) << n;
    if (!hit)
      continue;
    ++hits;
    ASSERT_NEAR(hit->t, *truth.t, HitTolerance) << n;
    ASSERT_LT(glm::distance(hit->Position(), ray.origin + hit->t * ray.direction), 1e-5) << n;
    ASSERT_EQ(scene.cells->Cell(hit->number), hit->cell) << n;
  }
  EXPECT_GT(hits, rays / 4);
  EXPECT_LE(undecided, mostUndecided * rays);
}

} // namespace hasp::testing
