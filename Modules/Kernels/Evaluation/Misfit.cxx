#include "Evaluation/Misfit.h"

#include "Evaluation/FitFaults.h"
#include "Evaluation/MeshSamples.h"
#include "Evaluation/TriangleTree.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace hasp
{

namespace
{
/// new = about + factor * (old - about), an axis at a time.
struct Guess
{
  FitFaultKind kind;
  std::string text;
  glm::dvec3 factor;
  glm::dvec3 about{ 0.0 };

  glm::dvec3 Place(const glm::dvec3& p) const
  {
    return this->about + this->factor * (p - this->about);
  }
  bool Mirrors() const { return this->factor.x * this->factor.y * this->factor.z < 0.0; }
  double Scale() const { return std::abs(this->factor.x); }
};

glm::dvec3 MiddleOf(const GridGeometry& g)
{
  return g.IndexToWorld(0.5 * glm::dvec3(g.dims - 1));
}

std::vector<Guess> Guesses(const glm::dvec3& middleOfPart, const glm::dvec3& middleOfBone)
{
  std::vector<Guess> guesses;
  const std::pair<const char*, double> units[] = { { "inches", 25.4 }, { "centimetres", 10.0 },
    { "metres", 1000.0 } };
  for (const auto& [name, mm] : units)
  {
    guesses.push_back({ FitFaultKind::Units,
      std::string("it is in ") + name + ", and fits in millimetres", glm::dvec3(mm) });
    guesses.push_back({ FitFaultKind::Units,
      std::string("its millimetres were taken for ") + name + "; turned back, it fits",
      glm::dvec3(1.0 / mm) });
  }
  guesses.push_back(
    { FitFaultKind::Space, "it is in RAS coordinates, and fits in LPS", { -1.0, -1.0, 1.0 } });
  const std::pair<const char*, glm::dvec3> places[] = { { "0", glm::dvec3(0.0) },
    { "the middle of its box", middleOfPart }, { "the middle of the volume", middleOfBone } };
  for (int axis = 0; axis < 3; ++axis)
    for (const auto& [name, place] : places)
    {
      glm::dvec3 factor(1.0);
      factor[axis] = -1.0;
      guesses.push_back({ FitFaultKind::Mirrored,
        std::string("it is mirrored, and fits with ") + "xyz"[axis] + " turned about " + name,
        factor, place });
    }
  return guesses;
}

/// The mesh as the guess would have it.
TriangleMesh Moved(TriangleMesh mesh, const Guess& guess, bool insideOut)
{
  for (glm::dvec3& p : mesh.points)
    p = guess.Place(p);
  if (guess.Mirrors() != insideOut)
    for (glm::uvec3& t : mesh.triangles)
      std::swap(t.y, t.z);
  return mesh;
}

/// Are nine of ten points of it in the volume? What is not is not worth measuring.
bool MostlyWithin(const GridGeometry& g, const TriangleMesh& mesh)
{
  std::size_t within = 0;
  for (const glm::dvec3& p : mesh.points)
  {
    const glm::dvec3 index = g.WorldToIndex(p);
    within += glm::all(glm::greaterThanEqual(index, glm::dvec3(0.0))) &&
              glm::all(glm::lessThanEqual(index, glm::dvec3(g.dims - 1)));
  }
  return 10 * within >= 9 * mesh.points.size();
}

/// About 1,000 places of it, on 2,000 of its triangles at most.
std::vector<MeshSample> SomePlaces(const TriangleMesh& mesh)
{
  const std::size_t triangles = 1 + mesh.triangles.size() / 2000;
  TriangleMesh part{ mesh.points, {} };
  for (std::size_t n = 0; n < mesh.triangles.size(); n += triangles)
    part.triangles.push_back(mesh.triangles[n]);
  const std::vector<MeshSample> all = SampleMesh(part, GapSampleMm);
  const std::size_t places = 1 + all.size() / 1000;
  std::vector<MeshSample> some;
  for (std::size_t n = 0; n < all.size(); n += places)
  {
    some.push_back(all[n]);
    some.back().areaMm2 *= double(triangles * places);
  }
  return some;
}

bool GapFits(
  const TriangleMesh& mesh, const AnyGridView& bone, const PartClaims& claims, double volumeMm3)
{
  if (!MostlyWithin(GeometryOf(bone), mesh))
    return false;
  const std::vector<MeshSample> samples = SomePlaces(mesh);
  const GuideGapSettings settings = GapSettingsOf(claims);
  std::vector<glm::dvec3> places;
  for (const MeshSample& sample : samples)
    places.push_back(sample.point);
  const auto nearest = DistanceToIsosurface(bone, claims.isovalue, places, settings.nearMm);
  ClaimedShell shell = *claims.shell;
  shell.leastGapShare *= 0.95; // of a thousand places: two or three standard deviations
  FitFaults faults;
  JudgeGap(MeasureGuideGap(samples, nearest, settings), shell, volumeMm3, faults);
  return faults.empty();
}

bool CutsFit(const TriangleMesh& mesh, const PartClaims& claims)
{
  const TriangleTree tree(mesh);
  FitFaults faults;
  for (std::size_t n = 0; n < claims.slots.size() && faults.empty(); ++n)
    JudgeSlot(FitSlot(tree, claims.slots[n]), claims.slots[n], n, faults);
  for (std::size_t n = 0; n < claims.holes.size() && faults.empty(); ++n)
    JudgeHole(FitHole(tree, claims.holes[n]), claims.holes[n], n, faults);
  return faults.empty();
}
} // namespace

std::optional<FitFault> ExplainMisfit(
  const TriangleMesh& mesh, const AnyGridView& bone, const PartClaims& claims, double volumeMm3)
{
  const bool cuts = !claims.slots.empty() || !claims.holes.empty();
  if (mesh.points.empty() || !(cuts || claims.shell))
    return std::nullopt;
  glm::dvec3 low = mesh.points.front(), high = low;
  for (const glm::dvec3& p : mesh.points)
  {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const bool insideOut = volumeMm3 < 0.0;
  for (const Guess& guess : Guesses(0.5 * (low + high), MiddleOf(GeometryOf(bone))))
  {
    const double volume = std::abs(volumeMm3) * std::pow(guess.Scale(), 3.0);
    const TriangleMesh moved = Moved(mesh, guess, insideOut);
    if (claims.shell && !GapFits(moved, bone, claims, volume))
      continue;
    if (cuts && !CutsFit(moved, claims))
      continue;
    return FitFault{ guess.kind, guess.text, std::nullopt };
  }
  return std::nullopt;
}

} // namespace hasp
