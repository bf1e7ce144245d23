#include "SurfaceFragment.h"

#include "SurfaceDistances.h"

#include "Distance/SheetMesh.h"
#include "Evaluation/MeshCheck.h"
#include "Grid/ProgressPart.h"
#include "Haptics/DistanceMap.h"
#include "Haptics/PointShell.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace hasp
{
namespace
{

template <typename... Parts>
std::string Text(const Parts&... parts)
{
  std::ostringstream text;
  text << "surface: ";
  (text << ... << parts);
  return text.str();
}

void CheckRange(const char* name, double value, double low, double high)
{
  if (!(value >= low && value <= high))
    throw std::invalid_argument(Text(name, " is ", value, ", must be in [", low, ", ", high, "]"));
}

void Check(const SurfaceFragmentSettings& s)
{
  CheckRange("spacingMm", s.spacingMm, 0.05, 10.0);
  CheckRange("thicknessMm", s.thicknessMm, 0.0, 50.0);
  CheckRange("rangeMm", s.rangeMm, 0.0, 100.0);
  CheckRange("shellPoints", s.shellPoints, 1, 1e8);
  if (s.thicknessMm > 0.0 && s.thicknessMm < 2.0 * s.spacingMm)
    throw std::invalid_argument(
      Text("thicknessMm is ", s.thicknessMm, ", must be 0 or two of spacingMm at least, now ",
        2.0 * s.spacingMm, "; choose a smaller spacingMm"));
}

struct Box
{
  glm::dvec3 low{ 1e300 }, high{ -1e300 };
};

/// Of points that are triangles' corners. Refuses what looks like other units.
Box BoxOf(const TriangleMesh& mesh)
{
  Box box;
  for (const glm::uvec3& t : mesh.triangles)
    for (int n = 0; n < 3; ++n)
    {
      box.low = glm::min(box.low, mesh.points[t[n]]);
      box.high = glm::max(box.high, mesh.points[t[n]]);
    }
  const glm::dvec3 size = box.high - box.low;
  const double longest = std::max({ size.x, size.y, size.z });
  if (longest < 1.0)
    throw std::invalid_argument(Text(
      "it is ", longest, " mm long; is it in metres or inches? Scale it to millimetres first"));
  if (longest > 4000.0)
    throw std::invalid_argument(Text("it is ", longest,
      " mm long, at most 4000 mm are measured; is it in micrometres? Scale it first"));
  return box;
}

/// The mesh as a closed one that is turned outwards.
TriangleMesh Closed(
  const TriangleMesh& mesh, const SurfaceFragmentSettings& settings, SurfaceFragment& made)
{
  if (mesh.triangles.empty())
    throw std::invalid_argument(Text("it has no triangles"));
  const MeshRims rims = FindRims(mesh); // checks points and indices
  BoxOf(mesh);
  if (settings.thicknessMm > 0.0)
  {
    if (rims.edges == 0)
      made.warnings.push_back(Text("it is closed, and was made a sheet of ", settings.thicknessMm,
        " mm all the same; without a thickness it is the body that it encloses"));
    return SheetMesh(mesh, { settings.thicknessMm, settings.behind });
  }
  TriangleMesh closed = mesh;
  for (glm::dvec3& p : closed.points) // as FindRims: equal within a millionth of a millimetre
    p = glm::round(p * 1e6) * 1e-6 + 0.0;
  closed = WeldPoints(closed);
  const MeshCheck check = CheckMesh(closed);
  if (check.turnedEdges > 0)
    throw std::invalid_argument(Text("at ", check.turnedEdges,
      " edges triangles are wound against each other, the first at (", check.turnedAt->x, ", ",
      check.turnedAt->y, ", ", check.turnedAt->z,
      ") mm; turn all of them the same way round first"));
  if (rims.edges > 0)
    throw std::invalid_argument(Text("it is open: ", rims.edges, " border edges in ", rims.loops,
      " holes or rims, the longest ", rims.longestMm, " mm, the first at (", rims.at.x, ", ",
      rims.at.y, ", ", rims.at.z,
      ") mm; fill the holes of a body, or give a sheet its thickness (thicknessMm)"));
  if (check.crowdedEdges > 0)
    made.warnings.push_back(Text(
      check.crowdedEdges, " edges have more than two triangles: what they enclose is one body"));
  if (check.pieces > 1)
    made.warnings.push_back(
      Text("it is in ", check.pieces, " pieces, which move as one; what lies in another is solid"));
  if (check.volumeMm3 < 0.0)
  {
    made.warnings.push_back(Text("it is inside out, and was turned"));
    for (glm::uvec3& t : closed.triangles)
      std::swap(t.y, t.z);
  }
  return closed;
}

/// Samples at whole multiples of the spacing, where the level set has its own.
GridGeometry GridAround(const Box& box, double rangeMm, const SurfaceFragmentSettings& settings)
{
  const double spacing = settings.spacingMm;
  const glm::dvec3 low = glm::floor((box.low - rangeMm) / spacing) - 1.0;
  const glm::dvec3 count = glm::ceil((box.high + rangeMm) / spacing) + 2.0 - low;
  const double samples = count.x * count.y * count.z;
  if (!(samples <= double(settings.mostSamples)))
    throw std::invalid_argument(Text("its grid would have ", samples, " samples, at most ",
      settings.mostSamples, " are allowed; choose a larger spacingMm, now ", spacing));
  GridGeometry grid;
  grid.dims = glm::ivec3(count);
  grid.spacing = glm::dvec3(spacing);
  grid.origin = low * spacing;
  return grid;
}

} // namespace

SurfaceFragment BakeSurface(const TriangleMesh& mesh, const SurfaceFragmentSettings& settings,
  const FragmentWants& wants, const ProgressFunction& progress)
{
  Check(settings);
  SurfaceFragment made;
  TriangleMesh closed = Closed(mesh, settings, made);
  made.volumeMm3 = CheckMesh(closed).volumeMm3;
  const Box box = BoxOf(closed);
  made.model.origin = 0.5 * (box.low + box.high);
  if (wants.map || wants.shell)
  {
    const double range = settings.rangeMm == 0.0 ? 16.0 * settings.spacingMm : settings.rangeMm;
    const GridGeometry grid = GridAround(box, range, settings);
    const std::vector<float> distances =
      SurfaceDistances(closed, grid, range, PartOf(progress, 0.0, 0.6));
    if (std::none_of(distances.begin(), distances.end(), [](float d) { return d < 0.0F; }))
      throw std::invalid_argument(Text("nothing of it is as thick as spacingMm, ",
        settings.spacingMm, " mm; choose a smaller one"));
    const GridView<const float> view{ distances.data(), grid };
    if (wants.map)
      made.model.map = std::make_shared<const DistanceMap>(view,
        DistanceMapSettings{ .rangeMm = range, .origin = made.model.origin },
        PartOf(progress, 0.6, 0.8));
    if (wants.shell)
      made.model.shell = PointShell::OfSurface(
        view, made.model.origin, { .points = settings.shellPoints }, PartOf(progress, 0.8, 1.0));
  }
  if (wants.surface)
    made.model.surface = std::make_shared<const TriangleMesh>(std::move(closed));
  ReportProgress(progress, 1.0);
  return made;
}

int ShellPointsOf(const TriangleMesh& mesh, double thicknessMm, double pointMm2, int most)
{
  constexpr int Least = 1024;
  const double faces = thicknessMm > 0.0 ? 2.0 : 1.0;
  return int(std::clamp(faces * CheckMesh(WeldPoints(mesh)).areaMm2 / pointMm2, double(Least),
    double(std::max(Least, most))));
}

} // namespace hasp
