#include "Distance/Csg.h"
#include "Distance/SharpContour.h"
#include "Distance/SolidShapes.h"
#include "DistanceCase.h"
#include "DistanceCases.h"
#include "Evaluation/MeshCheck.h"
#include "RandomTree.h"
#include "TrialTimes.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>

namespace hasp
{
namespace
{

/// As an STL file keeps it and gives it back.
MeshCheck CheckStl(TriangleMesh mesh)
{
  for (glm::dvec3& point : mesh.points)
    point = glm::dvec3(glm::vec3(point));
  return CheckMesh(WeldPoints(mesh));
}

/// What is there is sound, and as large as predicted; 0 mm^3: nothing is there.
void AddVolume(ReportContext& context, const std::string& id, const std::string& text,
  const SolidPointer& solid, const GridGeometry& grid, double volumeMm3, double limit)
{
  const MeshCheck check = CheckStl(SharpContour(*solid, grid));
  const bool none = check.triangles == 0;
  const double off =
    volumeMm3 == 0.0 ? (none ? 0.0 : 1.0) : std::abs(check.volumeMm3 / volumeMm3 - 1.0);
  AddCase(context, "contour." + id, text, none || check.Sound() ? off : 1.0, limit,
    "of the volume off; 1: not sound");
}

GridGeometry Around(double halfMm, double voxelMm, const glm::dvec3& at = glm::dvec3(0.0))
{
  GridGeometry grid = TrialGrid(2 * static_cast<int>(std::ceil(halfMm / voxelMm)) + 1, voxelMm);
  grid.origin += at;
  return grid;
}

void AddScales(ReportContext& context)
{
  const auto ball = [](double radius)
  { return MakeCapsule(glm::dvec3(0.003), glm::dvec3(0.003), radius); };
  const double unit = 4.0 / 3.0 * std::numbers::pi;
  AddVolume(
    context, "scale.small", "a ball of 1 mm at 0.05 mm", ball(1.0), Around(1.2, 0.05), unit, 3e-3);
  AddVolume(context, "scale.large", "a ball of 100 mm at 5 mm", ball(100.0), Around(120.0, 5.0),
    1e6 * unit, 3e-3);
  const glm::dvec3 far(150.0, -180.0, 120.0);
  AddVolume(context, "scale.far", "a ball of 1 mm at 0.05 mm, far from the origin",
    MakeCapsule(far, far, 1.0), Around(1.2, 0.05, far), unit, 3e-3);
  const GridGeometry meter{ { 205, 9, 9 }, { -10, -20, -20 }, glm::dvec3(5), glm::dmat3(1) };
  AddVolume(context, "meter", "a bar of 1 m at 5 mm",
    MakeBox({ 500, 0, 0 }, glm::dmat3(1), { 498, 12, 13 }), meter, 996.0 * 24.0 * 26.0, 1e-3);
  GridGeometry flat = Around(2.0, 0.1);
  flat.dims.z = 5;
  flat.spacing.z = 10.0;
  flat.origin.z = -20.0;
  const MeshCheck check = CheckStl(SharpContour(*ball(1.0), flat));
  AddCase(context, "contour.flat", "a ball of 1 mm, voxels of 0.1 x 0.1 x 10 mm: sound",
    check.Sound() ? 0.0 : 1.0, 0.0, "1: not sound");
}

void AddThin(ReportContext& context)
{
  for (const double thick : { 0.9, 0.3, 0.01 })
  {
    char id[40], text[100];
    const MeshCheck plate =
      CheckStl(SharpContour(*MakeSlab({ 0, 0, 0.01 }, { 1, 1, 3 }, 0.4 * thick), Around(5.0, 0.4)));
    std::snprintf(id, sizeof id, "contour.thin.plate%.0f", 100.0 * thick);
    std::snprintf(text, sizeof text, "a plate %g voxels thick: sound, or gone", thick);
    AddCase(
      context, id, text, plate.triangles == 0 || plate.Sound() ? 0.0 : 1.0, 0.0, "1: not sound");
    const SolidPointer slotted =
      MakeDifference(MakeBox(glm::dvec3(0.05), glm::dmat3(1), glm::dvec3(3.0)),
        MakeSlab({ 0, 0, 0.01 }, { 1, 1, 3 }, 0.4 * thick));
    const MeshCheck slot = CheckStl(SharpContour(*slotted, Around(5.0, 0.4)));
    std::snprintf(id, sizeof id, "contour.thin.slot%.0f", 100.0 * thick);
    std::snprintf(text, sizeof text, "a slot %g voxels wide in a block: sound", thick);
    AddCase(context, id, text, slot.Sound() ? 0.0 : 1.0, 0.0, "1: not sound");
  }
  const SolidPointer box = MakeBox(glm::dvec3(0.0), glm::dmat3(1), glm::dvec3(2.0));
  AddVolume(context, "empty.offset", "a box inwards by more than half its width: nothing",
    MakeOffset(box, -2.1), Around(4.0, 0.4), 0.0, 0.0);
  AddVolume(context, "empty.difference", "a box without itself: nothing", MakeDifference(box, box),
    Around(4.0, 0.4), 0.0, 0.0);
  AddVolume(context, "touching", "boxes that share a face are one",
    MakeUnion({ box, MakeBox({ 4, 0, 0 }, glm::dmat3(1), glm::dvec3(2.0)) }), Around(8.0, 0.4),
    128.0, 0.02);
}

void AddThreads(ReportContext& context)
{
  RandomTreeSettings settings;
  settings.depth = 3;
  double different = 0.0;
  for (const std::uint32_t seed : { 3U, 8U, 21U })
  {
    const SolidPointer tree = SolidOf(RandomTree(seed, settings));
    const auto contour = [&] { return SharpContour(*tree, Around(6.0, 0.4)); };
    const TriangleMesh one = OnThreads(1, contour);
    for (const int threads : { 2, 4 })
    {
      const TriangleMesh many = OnThreads(threads, contour);
      different += !(one.points.size() == many.points.size() && one.triangles == many.triangles &&
                     std::memcmp(one.points.data(), many.points.data(),
                       one.points.size() * sizeof(glm::dvec3)) == 0);
    }
  }
  AddCase(context, "contour.threads", "three trees, 1, 2 and 4 threads: the same to the last bit",
    different, 0.0, "of 6 that differ");
}

} // namespace

void TryContourCases(ReportContext& context)
{
  AddScales(context);
  AddThin(context);
  AddThreads(context);
}

} // namespace hasp
