#include "MirrorFit.h"

#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/GridSolid.h"
#include "Grid/ProgressPart.h"
#include "WorkingGrid.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace hasp
{

namespace
{
constexpr double GridMm = 2.0;
constexpr std::size_t MostPlaces = 20000;
constexpr std::size_t FewPlaces = 2000; // to choose a start with
constexpr double MatchedMm = 2.0;
constexpr double StartTan = 0.3; // 17 degrees

/// Bone's distances on the coarse grid, and places on its surface.
struct CoarseBone
{
  SolidPointer solid;
  std::vector<glm::dvec3> places;
};

CoarseBone MakeCoarseBone(const AnyGridView& ct, double isovalue,
  std::span<const std::uint8_t> keep, const ProgressFunction& progress)
{
  const GridGeometry& scan = GeometryOf(ct);
  GridGeometry grid = scan;
  grid.spacing = glm::dvec3(GridMm);
  grid.origin = scan.origin - scan.direction * glm::dvec3(2.0 * GridMm);
  const glm::dvec3 count = glm::ceil(glm::dvec3(scan.Cells()) * scan.spacing / GridMm) + 5.0;
  CheckPoints(
    "mirror plane", count, GridMm, "the mirror plane is fitted to heads: crop the scan to one");
  grid.dims = glm::ivec3(count);
  CoverageSettings settings;
  settings.isovalue = isovalue;
  settings.samplesPerAxis = 3;
  settings.keep = keep;
  const auto distance = std::make_shared<const std::vector<float>>(
    CoverageDistance(grid, Coverage(ct, grid, settings, progress)));
  if (!std::isfinite(distance->front()))
    throw std::runtime_error("mirror plane: there is no bone to fit a mirror plane to");
  CoarseBone bone{ MakeGridSolid(distance, grid), {} };
  for (std::size_t n = 0; n < distance->size(); ++n)
    if (std::abs((*distance)[n]) < 0.5 * GridMm)
    {
      const auto i = std::size_t(grid.dims.x), j = std::size_t(grid.dims.y);
      const glm::dvec3 x =
        grid.IndexToWorld({ double(n % i), double(n / i % j), double(n / (i * j)) });
      const ImplicitSolid::Sample s = bone.solid->SampleAt(x);
      bone.places.push_back(x - s.value * s.gradient);
    }
  if (bone.places.empty())
    throw std::runtime_error("mirror plane: there is no bone to fit a mirror plane to");
  const std::size_t step = bone.places.size() / MostPlaces + 1;
  for (std::size_t n = 0; n * step < bone.places.size(); ++n)
    bone.places[n] = bone.places[n * step];
  bone.places.resize((bone.places.size() + step - 1) / step);
  return bone;
}

/// A plane through `middle`; all else unit and upright on each other. A step moves it along its
/// normal, and turns that towards u and towards v.
struct Frame
{
  glm::dvec3 middle, normal, u, v;
};

/// The median of the sizes of distances; not of none.
double MedianSize(std::vector<double> sizes)
{
  const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

/// One step; returns how far the plane moved, mm.
double Improve(const ImplicitSolid& bone, std::span<const glm::dvec3> places, Frame& frame)
{
  std::vector<ImplicitSolid::Sample> samples;
  std::vector<double> sizes;
  const MirrorPlane plane{ frame.middle, frame.normal };
  for (const glm::dvec3& p : places)
  {
    samples.push_back(bone.SampleAt(Mirrored(plane, p)));
    sizes.push_back(std::abs(samples.back().value));
  }
  const double farthest = std::max(3.0 * MedianSize(sizes), 1.0);
  glm::dmat3 squares(0.0);
  glm::dvec3 sides(0.0);
  double reach = 0.0;
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const ImplicitSolid::Sample& s = samples[n];
    if (std::abs(s.value) > farthest)
      continue;
    const glm::dvec3 q = places[n] - frame.middle;
    const double height = glm::dot(q, frame.normal);
    // p' = p - 2 (dot(n, p - m) - d) n, by d and by n turned towards u and towards v.
    const auto turned = [&](const glm::dvec3& t)
    { return -2.0 * (glm::dot(q, t) * frame.normal + height * t); };
    const glm::dvec3 row(2.0 * glm::dot(s.gradient, frame.normal),
      glm::dot(s.gradient, turned(frame.u)), glm::dot(s.gradient, turned(frame.v)));
    squares += glm::outerProduct(row, row);
    sides -= s.value * row;
    reach = std::max(reach, glm::length(q));
  }
  for (int a = 0; a < 3; ++a)
    squares[a][a] += 1e-9 * (squares[a][a] + 1.0);
  const glm::dvec3 step = glm::inverse(squares) * sides;
  frame.middle += step.x * frame.normal;
  frame.normal = glm::normalize(frame.normal + step.y * frame.u + step.z * frame.v);
  frame.u = glm::normalize(frame.u - glm::dot(frame.u, frame.normal) * frame.normal);
  frame.v = glm::cross(frame.normal, frame.u);
  return std::abs(step.x) + reach * (std::abs(step.y) + std::abs(step.z));
}

void Settle(const ImplicitSolid& bone, std::span<const glm::dvec3> places, int steps, Frame& frame)
{
  for (int n = 0; n < steps; ++n)
    if (Improve(bone, places, frame) < 1e-4)
      break;
}

/// The best of five starts, by some of the places: straight, and turned to either side and to
/// either shoulder.
Frame BestStart(const CoarseBone& bone)
{
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : bone.places)
    middle += p / double(bone.places.size());
  std::vector<glm::dvec3> few;
  for (std::size_t n = 0; n < bone.places.size(); n += bone.places.size() / FewPlaces + 1)
    few.push_back(bone.places[n]);
  Frame best{};
  double least = 1e30;
  for (const glm::dvec2 lean : { glm::dvec2(0, 0), glm::dvec2(StartTan, 0),
         glm::dvec2(-StartTan, 0), glm::dvec2(0, StartTan), glm::dvec2(0, -StartTan) })
  {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, lean));
    const glm::dvec3 u = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), normal));
    Frame frame{ middle, normal, u, glm::cross(normal, u) };
    Settle(*bone.solid, few, 25, frame);
    std::vector<double> sizes;
    for (const glm::dvec3& p : few)
      sizes.push_back(std::abs(bone.solid->At(Mirrored({ frame.middle, frame.normal }, p))));
    const double size = MedianSize(std::move(sizes));
    if (size < least)
    {
      least = size;
      best = frame;
    }
  }
  return best;
}
} // namespace

glm::dvec3 Mirrored(const MirrorPlane& plane, const glm::dvec3& point)
{
  return point - 2.0 * glm::dot(point - plane.point, plane.normal) * plane.normal;
}

MirrorPlane FitMirrorPlane(const AnyGridView& ct, double isovalue,
  std::span<const std::uint8_t> keep, const ProgressFunction& progress)
{
  const CoarseBone bone = MakeCoarseBone(ct, isovalue, keep, PartOf(progress, 0.0, 0.7));
  Frame frame = BestStart(bone);
  ReportProgress(progress, 0.9);
  Settle(*bone.solid, bone.places, 60, frame);
  const MirrorPlane plane{ frame.middle, frame.normal };
  std::size_t matched = 0;
  for (const glm::dvec3& p : bone.places)
    matched += std::abs(bone.solid->At(Mirrored(plane, p))) <= MatchedMm;
  if (2 * matched < bone.places.size())
    throw std::runtime_error("mirror plane: bone is not like its mirror image: of its surface " +
                             std::to_string(100 * matched / bone.places.size()) +
                             " % come to lie within 2 mm; give the mirror plane");
  return plane;
}

} // namespace hasp
