#include "ContourRivals.h"
#include "Distance/SharpContour.h"
#include "DistanceTrials.h"
#include "Evaluation/MeshCheck.h"
#include "RandomTree.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"
#include "TrialTimes.h"

#if HASP_WITH_CGAL
#include "Evaluation/SelfIntersections.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr double HalfMm = 8.0; ///< holds all trees of meshes
constexpr double VoxelMm = 0.4;
constexpr double VolumeCellMm = 0.1;

struct Tally
{
  int good = 0, open = 0, crossed = 0, wrongVolume = 0, ended = 0;
  double seconds = 0.0;

  void Add(const BooleanOutcome& outcome, double truth)
  {
    this->seconds += outcome.seconds;
    const bool wrong = !(std::abs(outcome.volumeMm3 / truth - 1.0) <= 0.01);
    if (!outcome.ending.empty())
      ++this->ended;
    else if (!outcome.closed || !outcome.manifold)
      ++this->open;
    else if (outcome.crossings > 0)
      ++this->crossed;
    else if (wrong)
      ++this->wrongVolume;
    else
      ++this->good;
  }
  std::string Text(int trees) const
  {
    char text[240];
    std::snprintf(text, sizeof text,
      "%d of %d good, %d not closed or no 2-manifold, %d meet themselves, %d of wrong volume, %d "
      "crashed or took 60 s; %.3g s each",
      this->good, trees, this->open, this->crossed, this->wrongVolume, this->ended,
      this->seconds / trees);
    return text;
  }
};

BooleanOutcome Ours(const ImplicitSolid& solid)
{
  const GridGeometry grid = TrialGrid(2 * static_cast<int>(HalfMm / VoxelMm) + 1, VoxelMm);
  BooleanOutcome outcome;
  TriangleMesh mesh;
  outcome.seconds = TimeOf([&] { mesh = SharpContour(solid, grid); }).wallS;
  for (glm::dvec3& point : mesh.points)
    point = glm::dvec3(glm::vec3(point));
  mesh = WeldPoints(mesh);
  const MeshCheck check = CheckMesh(mesh);
  outcome.closed = check.Closed();
  outcome.manifold = check.Sound();
  outcome.volumeMm3 = check.volumeMm3;
#if HASP_WITH_CGAL
  if (outcome.manifold)
    outcome.crossings = static_cast<long>(CountSelfIntersections(mesh));
#endif
  return outcome;
}

} // namespace

void TryBooleans(ReportContext& context, const BooleanRival& rival, int trees)
{
  if (!rival.absent.empty())
  {
    context.report.rows.push_back(AbsentRow("contour.boolean_rival", rival.name, rival.absent));
    return;
  }
  RandomTreeSettings settings;
  settings.meshes = true;
  Tally ours, theirs;
  double squares = 0.0;
  auto seed = static_cast<std::uint32_t>(context.settings.seed * 100'000);
  for (int n = 0; n < trees; ++seed)
  {
    settings.depth = 1 + static_cast<int>(seed % 3);
    const SolidPointer solid = SolidOf(RandomTree(seed, settings));
    const double truth = VolumeOf(*solid, HalfMm, VolumeCellMm);
    if (truth < 1.0) // nothing to speak of is left
      continue;
    context.progress(static_cast<double>(n++) / trees, "");
    const BooleanOutcome outcome = Ours(*solid);
    squares += (outcome.volumeMm3 / truth - 1.0) * (outcome.volumeMm3 / truth - 1.0) / trees;
    ours.Add(outcome, truth);
    theirs.Add(rival.run(seed, settings.depth), truth);
  }
  ReportRow row;
  row.id = "contour.boolean_rival";
  row.value = static_cast<double>(theirs.good) / trees;
  row.unit = "share";
  row.better = Better::NotSaid;
  row.rival = rival.name + ": " + theirs.Text(trees);
  row.error = std::sqrt(squares);
  row.errorUnit = "of the volume, RMS, ours";
  row.timeS = ours.seconds / trees;
  row.n = trees;
  row.data = "unions, intersections and differences of boxes, cylinders and capsules, half of them "
             "on a lattice of 0.5 mm; good: closed 2-manifold, does not meet itself, volume within "
             "1 %; the sharp contour at 0.4 mm: " +
             ours.Text(trees);
#if !HASP_WITH_CGAL
  row.data += "; self-intersections not checked: this build has no CGAL";
#endif
  context.report.rows.push_back(row);
}

} // namespace hasp
