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

#include <glm/common.hpp>
#include <glm/geometric.hpp>

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

/// A plate of 6 voxels with a rib, round everywhere but where the two meet; turned any way.
ScannedBone ScanPlate(int samples, std::uint64_t seed)
{
  const double v = TrialVoxelMm;
  std::mt19937_64 random(seed);
  const glm::dvec3 x = AnyDirection(random);
  const glm::dvec3 y = glm::normalize(glm::cross(x, AnyDirection(random)));
  const glm::dvec3 z = glm::cross(x, y), at = v * SubVoxelCentre(static_cast<int>(seed % 27), seed);
  const AnalyticVolume rib =
    AnalyticCapsule(at - 20.0 * v * x, at + 20.0 * v * (x + 0.3 * z), 6.0 * v);
  const AnalyticVolume shape{ "plate", [=](const glm::dvec3& p)
    {
      const glm::dvec3 out =
        glm::abs(glm::dvec3(glm::dot(p - at, x), glm::dot(p - at, y), glm::dot(p - at, z))) -
        v * glm::dvec3(16.0, 11.0, 0.1);
      const double box =
        glm::length(glm::max(out, 0.0)) + std::min(0.0, std::max({ out.x, out.y, out.z }));
      return std::max(2.9 * v - box, rib.value(p));
    } };
  ScannedBone bone;
  bone.grid = TrialGrid(samples);
  const std::vector<float> scan = ScannedImage(shape, bone.grid, 0.8, 0.03, seed);
  CoverageSettings inside;
  inside.isovalue = 0.5;
  bone.coverage = Coverage(GridView<const float>{ scan.data(), bone.grid }, bone.grid, inside);
  return bone;
}

void AddRows(ReportContext& context, const std::vector<Method>& methods, const std::string& at,
  const std::string& where)
{
  const Method& binary = methods.front();
  for (const Method& method : methods)
  {
    if (method.id == nullptr)
      continue;
    ReportRow row;
    row.id = std::string("distance.wall") + method.id + at;
    row.value = method.Off() / binary.Off();
    row.unit = "of the binary transform's |thinnest wall - asked|";
    row.better = Better::Lower;
    char text[200];
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
      "; %s: thinnest wall %.3f voxels, %.3f off (%.0f um), walls' RMS error %.3f", method.name,
      method.least, method.Off(), 1e3 * TrialVoxelMm * method.Off(), method.Rms());
    row.data = "shell of 3 voxels of 0.4 mm around " + where + ", blur 0.8 voxel, noise 3 %" + text;
    if (*method.id == '\0')
    {
      row.bars = { { {}, 0.5 } };
      row.data += "; aim 0.25";
    }
    context.report.rows.push_back(row);
  }
}

std::vector<Method> Methods()
{
  return {
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
}

} // namespace

void TryShell(ReportContext& context)
{
  const bool quick = context.settings.quick;
  const std::vector<const char*> places =
    quick ? std::vector{ "gonion left" }
          : std::vector{ "gonion left", "menton", "condylion right" };
  const int samples = quick ? 72 : 112;
  std::vector<Method> bone = Methods(), plate = Methods();
  for (const char* place : places)
  {
    const ScannedBone scan = ScanAt(place, samples, context.settings.seed);
    for (Method& method : bone)
      Measure(scan, method);
  }
  const int plates = quick ? 3 : 9;
  for (int n = 0; n < plates; ++n)
  {
    const ScannedBone scan = ScanPlate(72, context.settings.seed + static_cast<std::uint64_t>(n));
    for (Method& method : plate)
      Measure(scan, method);
  }
  AddRows(context, bone, "",
    "a mandible (" + std::to_string(places.size()) + " windows of " + std::to_string(samples) +
      "^3)");
  AddRows(context, plate, "@plate",
    "a plate of 6 voxels with a rib, turned any way (" + std::to_string(plates) + " of 72^3)");
}

} // namespace hasp
