#include "Evaluation/FitCertificate.h"

#include "Evaluation/BonePieces.h"
#include "Evaluation/FitFaults.h"
#include "Evaluation/MeshSamples.h"
#include "Evaluation/Misfit.h"
#include "Evaluation/SurfaceDistance.h"
#include "Evaluation/TriangleTree.h"
#include "Grid/ProgressPart.h"
#include "Grid/SideBySide.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace hasp
{

namespace
{
void MeasureMesh(const TriangleMesh& mesh, const FindSelfIntersectionsFunction& selfIntersections,
  FitCertificate& c)
{
  c.mesh = CheckMesh(mesh);
  c.pieces = MeshPieces(mesh);
  for (const glm::uvec3& t : mesh.triangles)
    c.slivers += HeightOf(mesh, t) < SliverMm;
  JudgeMesh(c, c.faults);
  // Only of these can it be told; others have faults enough.
  if (!c.mesh.TwoManifold() || c.mesh.turnedEdges > 0 || c.mesh.degenerate > 0 ||
      mesh.triangles.empty())
    return;
  if (!selfIntersections)
  {
    c.faults.push_back({ FitFaultKind::NotChecked,
      "self-intersections were not measured: this build has no CGAL (HASP_ENABLE_CGAL)", {} });
    return;
  }
  try
  {
    const auto pairs = selfIntersections(mesh);
    c.selfIntersections = pairs.size();
    if (pairs.empty())
      return;
    const glm::dvec3 at = mesh.points[mesh.triangles[pairs.front()[0]].x];
    c.faults.push_back({ FitFaultKind::MeetsItself,
      "the mesh meets itself: " + std::to_string(pairs.size()) + " pairs of triangles", at });
  }
  catch (const std::invalid_argument&)
  {
    c.faults.push_back({ FitFaultKind::NotChecked,
      "self-intersections were not measured: the mesh has triangles without an area, or is no "
      "oriented 2-manifold",
      {} });
  }
}

/// Is the place at the wall of a slot or hole, as claimed?
bool InCut(const PartClaims& claims, const glm::dvec3& place)
{
  for (const ClaimedSlot& slot : claims.slots)
  {
    const glm::dvec3 off = place - slot.point;
    if (std::abs(glm::dot(off, slot.normal)) <= 0.5 * slot.widthMm + 2.0 * slot.toleranceMm &&
        std::abs(glm::dot(off, slot.along)) <= 0.5 * slot.lengthMm + 2.0 * slot.toleranceMm)
      return true;
  }
  for (const ClaimedHole& hole : claims.holes)
    if (glm::length(glm::cross(place - hole.point, hole.axis)) <=
        0.5 * std::max(hole.diameterMm, hole.roomMm) + 2.0 * hole.toleranceMm)
      return true;
  return false;
}

/// Those that do not come out in a cut: there the shell ends.
std::vector<Chord> ChordsOfShell(const std::vector<MeshSample>& samples,
  const std::vector<Chord>& chords, const PartClaims& claims)
{
  std::vector<Chord> uncut = chords;
  for (std::size_t n = 0; n < uncut.size(); ++n)
    if (InCut(claims, samples[n].point - chords[n].mm * samples[n].normal))
      uncut[n].mm = 0.0;
  return uncut;
}

/// Those that do not begin in one, either: there a wall ends.
std::vector<Chord> UncutChords(const std::vector<MeshSample>& samples,
  const std::vector<Chord>& chords, const PartClaims& claims)
{
  std::vector<Chord> uncut = ChordsOfShell(samples, chords, claims);
  for (std::size_t n = 0; n < uncut.size(); ++n)
    if (InCut(claims, samples[n].point))
      uncut[n].mm = 0.0;
  return uncut;
}

/// The part's surface: what its walls and its gap are measured by.
struct Surface
{
  TriangleTree tree;
  std::vector<MeshSample> samples;
  std::vector<Chord> chords;
  std::vector<std::optional<NearestSurface>> nearest; ///< of a shell
  WallThickness wall;

  Surface(const TriangleMesh& mesh, const AnyGridView& bone, const PartClaims& claims,
    const ProgressFunction& progress)
    : tree(mesh),
      samples(SampleMesh(mesh, GapSampleMm)),
      chords(MeasureChords(tree, samples)),
      wall(MeasureWalls(samples, chords))
  {
    ReportProgress(progress, 0.4);
    if (!claims.shell)
      return;
    const GuideGapSettings settings = GapSettingsOf(claims);
    std::vector<glm::dvec3> places;
    places.reserve(this->samples.size());
    for (const MeshSample& sample : this->samples)
      places.push_back(sample.point);
    this->nearest = DistanceToIsosurface(
      bone, settings.isovalue, places, settings.nearMm, PartOf(progress, 0.4, 1.0));
  }
};

void MeasureGap(const Surface& surface, const AnyGridView& bone, FitCertificate& c)
{
  const ClaimedShell& shell = *c.claims.shell;
  const GuideGapSettings settings = GapSettingsOf(c.claims);
  BonePieces pieces(bone, c.claims.isovalue, c.claims.ignoreBelowMm3);
  c.gap = MeasureGuideGap(surface.samples, surface.nearest, settings,
    [&](const glm::dvec3& at) { return pieces.Counts(at); });
  c.shell = MeasureShell(surface.samples, ChordsOfShell(surface.samples, surface.chords, c.claims),
    surface.nearest, { shell.gapMm, shell.gapToleranceMm, settings.facing, c.claims.withdrawal });
  JudgeGap(*c.gap, shell, c.mesh.volumeMm3, c.faults);
}

void MeasureCuts(const TriangleTree& tree, FitCertificate& c)
{
  for (std::size_t n = 0; n < c.claims.slots.size(); ++n)
  {
    c.slots.push_back(FitSlot(tree, c.claims.slots[n]));
    JudgeSlot(c.slots.back(), c.claims.slots[n], n, c.faults);
  }
  for (std::size_t n = 0; n < c.claims.holes.size(); ++n)
  {
    c.holes.push_back(FitHole(tree, c.claims.holes[n]));
    JudgeHole(c.holes.back(), c.claims.holes[n], n, c.faults);
  }
}

bool DoesNotFit(const FitCertificate& c)
{
  return std::any_of(c.faults.begin(), c.faults.end(),
    [](const FitFault& fault)
    {
      return fault.kind == FitFaultKind::Gap || fault.kind == FitFaultKind::TouchesBone ||
             fault.kind == FitFaultKind::Slot || fault.kind == FitFaultKind::Hole;
    });
}
} // namespace

GuideGapSettings GapSettingsOf(const PartClaims& claims)
{
  GuideGapSettings settings;
  settings.isovalue = claims.isovalue;
  settings.gapMm = claims.shell->gapMm;
  settings.toleranceMm = claims.shell->gapToleranceMm;
  // Half way into the shell: what lies farther off than its middle should is no inner wall.
  settings.nearMm = claims.shell->gapMm + 0.5 * claims.shell->thicknessMm;
  return settings;
}

FitCertificate CertifyFit(const TriangleMesh& mesh, const AnyGridView& bone,
  const PartClaims& claims, const FindSelfIntersectionsFunction& selfIntersections,
  const ProgressFunction& progress)
{
  ValidateClaims(claims);
  GeometryOf(bone).Validate();
  FitCertificate c;
  c.claims = claims;
  std::optional<Surface> surface;
  // The mesh alone takes one core, and as long as all that is asked of its surface.
  SideBySide([&] { MeasureMesh(mesh, selfIntersections, c); },
    [&] { surface.emplace(mesh, bone, claims, PartOf(progress, 0.0, 0.8)); });
  if (mesh.triangles.empty())
    return c;
  c.low = surface->tree.Low();
  c.high = surface->tree.High();
  c.wall = surface->wall;
  if (claims.leastUncutMm > 0.0)
    c.uncut =
      MeasureWalls(surface->samples, UncutChords(surface->samples, surface->chords, claims));
  if (claims.shell)
    MeasureGap(*surface, bone, c);
  JudgeWalls(c, c.faults);
  MeasureCuts(surface->tree, c);
  if (claims.withdrawal)
  {
    InsertionSettings settings;
    settings.isovalue = claims.isovalue;
    settings.ignoreBelowMm3 = claims.ignoreBelowMm3;
    settings.direction = *claims.withdrawal;
    c.insertion = MeasureInsertion(bone, surface->samples, settings, PartOf(progress, 0.8, 1.0));
    JudgeInsertion(*c.insertion, c.faults);
  }
  if (DoesNotFit(c))
    if (const auto misfit = ExplainMisfit(mesh, bone, claims, c.mesh.volumeMm3))
      c.faults.insert(c.faults.begin(), *misfit);
  ReportProgress(progress, 1.0);
  return c;
}

} // namespace hasp
