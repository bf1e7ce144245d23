#include "MirrorGhost.h"

#include "MirrorFit.h"
#include "WorkingGrid.h"

#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/GridSolid.h"
#include "Distance/TetrahedraContour.h"
#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{
namespace
{

void Require(bool holds, const char* name, double value, const char* range)
{
  if (!holds)
    throw std::invalid_argument(
      std::string("mirror: ") + name + " is " + std::to_string(value) + ", must be " + range);
}

void Check(const MirrorGhostSettings& s)
{
  Require(s.spacingMm >= 0.3 && s.spacingMm <= 3.0, "spacingMm", s.spacingMm, "in [0.3, 3]");
  Require(s.matchedMm > 0.0 && s.matchedMm <= 100.0, "matchedMm", s.matchedMm, "in (0, 100]");
  if (!s.plane)
    return;
  for (int a = 0; a < 3; ++a)
    Require(std::abs(s.plane->point[a]) <= 4000.0, "the plane's point", s.plane->point[a],
      "within 4000 mm");
  const double length = glm::length(s.plane->normal);
  Require(std::abs(length - 1.0) <= 1e-3, "the length of the plane's normal", length, "1");
}

/// One byte a sample; all of them where none is given. Throws if there is no bone.
std::vector<std::uint8_t> KeptBone(
  const AnyGridView& grey, double isovalue, std::span<const std::uint8_t> keep)
{
  const std::size_t size = GeometryOf(grey).Size();
  if (!keep.empty() && keep.size() != size)
    throw std::invalid_argument("mirror: keep has " + std::to_string(keep.size()) +
                                " values, must have one a sample, " + std::to_string(size));
  std::vector<std::uint8_t> kept(size);
  bool any = false;
  std::visit(
    [&](const auto& view)
    {
      for (std::size_t n = 0; n < size; ++n)
      {
        kept[n] = (keep.empty() || keep[n] != 0) && double(view.data[n]) >= isovalue;
        any = any || kept[n] != 0;
      }
    },
    grey);
  if (!any)
    throw std::runtime_error("mirror: there is no bone; choose a lower isovalue");
  return kept;
}

/// The box of what is kept and of its mirror image, on the world's axes.
GridGeometry GridOfBoth(const GridGeometry& scan, const std::vector<std::uint8_t>& kept,
  const MirrorPlane& plane, double spacingMm)
{
  glm::dvec3 low(1e300), high(-1e300);
  const auto add = [&](const glm::dvec3& p)
  {
    low = glm::min(low, p);
    high = glm::max(high, p);
  };
  for (int k = 0; k < scan.dims.z; ++k)
    for (int j = 0; j < scan.dims.y; ++j)
      for (int i = 0; i < scan.dims.x; ++i)
        if (kept[(std::size_t(k) * scan.dims.y + j) * scan.dims.x + i] != 0)
        {
          const glm::dvec3 p = scan.IndexToWorld({ i, j, k });
          add(p);
          add(Mirrored(plane, p));
        }
  const double most = std::max({ scan.spacing.x, scan.spacing.y, scan.spacing.z });
  const glm::dvec3 margin(most + 4.0 * spacingMm);
  const glm::dvec3 count = glm::ceil((high - low + 2.0 * margin) / spacingMm) + 1.0;
  CheckPoints("mirror", count, spacingMm, "a larger spacingMm, or less bone, would do");
  GridGeometry grid;
  grid.dims = glm::ivec3(count);
  grid.spacing = glm::dvec3(spacingMm);
  grid.origin = low - margin;
  return grid;
}

/// A third of its triangles' area for each point, mm^2.
std::vector<double> AreasOf(const TriangleMesh& mesh)
{
  std::vector<double> areas(mesh.points.size(), 0.0);
  for (const glm::uvec3& t : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[t.x], &b = mesh.points[t.y], &c = mesh.points[t.z];
    const double third = glm::length(glm::cross(b - a, c - a)) / 6.0;
    for (int n = 0; n < 3; ++n)
      areas[t[n]] += third;
  }
  return areas;
}

void Summarise(double matchedMm, MirrorGhost& ghost)
{
  const std::vector<double> areas = AreasOf(ghost.mesh);
  std::vector<std::size_t> order(areas.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto size = [&](std::size_t n) { return std::abs(double(ghost.signedDistanceMm[n])); };
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return size(a) < size(b) || (size(a) == size(b) && a < b); });
  const double all = std::accumulate(areas.begin(), areas.end(), 0.0);
  double sum = 0.0;
  for (const std::size_t n : order)
  {
    if (sum < 0.5 * all)
      ghost.medianMm = size(n);
    if (sum < 0.95 * all)
      ghost.p95Mm = size(n);
    sum += areas[n];
    if (size(n) <= matchedMm)
      ghost.matchedShare = sum / all;
  }
}

} // namespace

MirrorGhost MakeMirrorGhost(const AnyGridView& grey, double isovalue,
  std::span<const std::uint8_t> keep, const MirrorGhostSettings& settings,
  const ProgressFunction& progress)
{
  Check(settings);
  const std::vector<std::uint8_t> kept = KeptBone(grey, isovalue, keep);
  MirrorGhost ghost;
  ghost.found = !settings.plane;
  ghost.plane = settings.plane ? *settings.plane
                               : FitMirrorPlane(grey, isovalue, kept, PartOf(progress, 0.0, 0.3));
  ghost.plane.normal = glm::normalize(ghost.plane.normal);
  if (ghost.plane.normal.x < 0.0)
    ghost.plane.normal = -ghost.plane.normal;
  const GridGeometry grid = GridOfBoth(GeometryOf(grey), kept, ghost.plane, settings.spacingMm);
  CoverageSettings coverage;
  coverage.isovalue = isovalue;
  coverage.keep = kept;
  const auto distance = std::make_shared<const std::vector<float>>(CoverageDistance(
    grid, Coverage(grey, grid, coverage, PartOf(progress, 0.3, 0.5)), PartOf(progress, 0.5, 0.8)));
  ghost.mesh = ContourTetrahedra({ distance->data(), grid });
  if (ghost.mesh.triangles.empty())
    throw std::runtime_error("mirror: bone is thinner than spacingMm; choose a smaller one");
  for (glm::dvec3& p : ghost.mesh.points)
    p = Mirrored(ghost.plane, p);
  for (glm::uvec3& t : ghost.mesh.triangles) // turned inside out by the mirror
    std::swap(t.y, t.z);
  const SolidPointer bone = MakeGridSolid(distance, grid);
  ghost.signedDistanceMm.resize(ghost.mesh.points.size());
  ParallelFor(0, std::int64_t(ghost.mesh.points.size()), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
        ghost.signedDistanceMm[n] = float(bone->At(ghost.mesh.points[n]));
    });
  Summarise(settings.matchedMm, ghost);
  ReportProgress(progress, 1.0);
  return ghost;
}

} // namespace hasp
