#include "Distance/ChamferDistance.h"
#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "Distance/EuclideanDistance.h"
#include "DistanceTrials.h"
#include "Evaluation/SurfaceDistance.h"
#include "Grid/Phantom.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"
#include "TrialTimes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace hasp
{
namespace
{

constexpr double WallVoxels = 3.0;
constexpr int Border = 10; ///< voxels: the bone beyond the window is not seen
constexpr double SoftHU = 40.0, BoneHU = 1000.0;

/// A bone as a scanner sees it: blur 0.8 voxel, noise 3 % of the step.
struct ScannedBone
{
  GridGeometry grid;
  std::vector<float> coverage;
};

ScannedBone ScanAt(const char* landmark, int samples, std::uint64_t seed)
{
  PhantomSettings settings;
  settings.softHU = SoftHU;
  settings.boneHU = settings.diploeHU = settings.jawMarrowHU = BoneHU; // its outer surface alone
  settings.blurMm = glm::dvec3(0.8 * TrialVoxelMm);
  settings.noiseHU = 0.03 * (BoneHU - SoftHU);
  settings.seed = seed;
  const std::vector<PhantomLandmark> landmarks = PhantomLandmarks(settings);
  const auto found = std::find_if(landmarks.begin(), landmarks.end(),
    [&](const PhantomLandmark& known) { return known.name == landmark; });
  ScannedBone bone;
  bone.grid = TrialGrid(samples);
  bone.grid.origin += found->point;
  const std::vector<std::int16_t> scan = SamplePhantom(bone.grid, settings);
  CoverageSettings inside;
  inside.isovalue = 0.5 * (SoftHU + BoneHU);
  bone.coverage =
    Coverage(GridView<const std::int16_t>{ scan.data(), bone.grid }, bone.grid, inside);
  return bone;
}

/// Places where the surface value = wall passes lines of the grid, away from its border.
std::vector<glm::dvec3> OuterPlaces(const std::vector<float>& distances, const GridGeometry& grid)
{
  std::vector<glm::dvec3> places;
  const double wall = WallVoxels * TrialVoxelMm;
  const int n = grid.dims.x;
  const std::size_t steps[] = { 1, std::size_t(n), std::size_t(n) * n };
  for (int k = Border; k < n - Border; ++k)
    for (int j = Border; j < n - Border; ++j)
      for (int i = Border; i < n - Border; ++i)
        for (int axis = 0; axis < 3; ++axis)
        {
          const std::size_t voxel = (std::size_t(k) * n + j) * n + i;
          const double a = distances[voxel] - wall, b = distances[voxel + steps[axis]] - wall;
          if ((a < 0.0) == (b < 0.0))
            continue;
          glm::dvec3 place(i, j, k);
          place[axis] += a / (a - b);
          places.push_back(grid.IndexToWorld(place));
        }
  return places;
}

struct Method
{
  const char* id; ///< after "distance.wall"; null: the one that others are measured against
  const char* name;
  std::vector<float> (*transform)(const ScannedBone&);
  double least = std::numeric_limits<double>::infinity(); ///< voxels
  double squares = 0.0;
  std::size_t places = 0;
  Timing time{};

  double Off() const { return std::abs(this->least - WallVoxels); }
  double Rms() const { return std::sqrt(this->squares / static_cast<double>(this->places)); }
};

/// Walls from the outer surface to the inner one, both of the same field, by search on the
/// trilinear isosurface (Evaluation shares nothing with Distance).
void Measure(const ScannedBone& bone, Method& method)
{
  std::vector<float> distances;
  const Timing time =
    OnThreads(1, [&] { return TimeOf([&] { distances = method.transform(bone); }); });
  method.time.wallS += time.wallS;
  method.time.cpuS += time.cpuS;
  const std::vector<glm::dvec3> places = OuterPlaces(distances, bone.grid);
  for (float& distance : distances)
    distance = std::clamp(-distance, -100.0F, 100.0F); // inside is above; no infinity
  const auto walls = DistanceToIsosurface(GridView<const float>{ distances.data(), bone.grid }, 0.0,
    places, 2.0 * WallVoxels * TrialVoxelMm);
  for (const auto& wall : walls)
  {
    const double voxels =
      wall ? wall->distance / TrialVoxelMm : 2.0 * WallVoxels; // farther than was looked
    method.least = std::min(method.least, voxels);
    method.squares += (voxels - WallVoxels) * (voxels - WallVoxels);
  }
  method.places += walls.size();
}

} // namespace

void TryShell(ReportContext& context)
{
  std::vector<Method> methods = {
    { nullptr, "binary <3,4,5>",
      [](const ScannedBone& bone) { return ChamferDistance(bone.grid, BinaryOf(bone.coverage)); } },
    { "", "the guides' transform",
      [](const ScannedBone& bone) { return CoverageDistanceBand(bone.grid, bone.coverage); } },
    { ".chamfer_aa", "anti-aliased <3,4,5>",
      [](const ScannedBone& bone) { return ChamferDistance(bone.grid, bone.coverage); } },
    { ".euclid", "exact Euclidean, binary",
      [](const ScannedBone& bone)
      { return SignedEuclideanDistance(bone.grid, MaskOf(bone.coverage)); } },
  };
  const std::vector<const char*> places =
    context.settings.quick ? std::vector{ "gonion left" }
                           : std::vector{ "gonion left", "menton", "condylion right" };
  const int samples = context.settings.quick ? 72 : 112;
  for (const char* place : places)
  {
    const ScannedBone bone = ScanAt(place, samples, context.settings.seed);
    for (Method& method : methods)
      Measure(bone, method);
  }
  const Method& binary = methods.front();
  for (const Method& method : methods)
  {
    if (method.id == nullptr)
      continue;
    ReportRow row;
    row.id = std::string("distance.wall") + method.id;
    row.value = method.Off() / binary.Off();
    row.unit = "of the binary transform's |thinnest wall - asked|";
    row.better = Better::Lower;
    char text[300];
    std::snprintf(text, sizeof text,
      "binary <3,4,5>: thinnest wall %.3f voxels, %.3f off (%.0f um), walls' RMS error %.3f",
      binary.least, binary.Off(), 1e3 * TrialVoxelMm * binary.Off(), binary.Rms());
    row.rival = text;
    row.error = method.Off();
    row.errorUnit = "voxel";
    row.timeS = method.time.wallS;
    row.cpuS = method.time.cpuS;
    row.n = static_cast<int>(method.places);
    std::snprintf(text, sizeof text,
      "shell of 3 voxels of %.1f mm around a mandible, blur 0.8 voxel, noise 3 %%, %zu windows of "
      "%d^3; %s: thinnest wall %.3f voxels, %.3f off (%.0f um), walls' RMS error %.3f",
      TrialVoxelMm, places.size(), samples, method.name, method.least, method.Off(),
      1e3 * TrialVoxelMm * method.Off(), method.Rms());
    row.data = text;
    if (*method.id == '\0')
    {
      row.bars = { { {}, 0.5 } };
      row.data += "; aim 0.25";
    }
    context.report.rows.push_back(row);
  }
}

} // namespace hasp
