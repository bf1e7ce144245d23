#include "ReportStereo.h"

#include "BallScene.h"
#include "Pairing.h"
#include "ReportRegistry.h"
#include "Windows.h"

#include "vtkVersionMacros.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace hasp
{
namespace
{

constexpr const char* Rival = "VTK " VTK_VERSION " stereo (sheared camera), same eye angle";

/// Largest distance of a middle from its truth, over both eyes, in pixels.
double Error(const std::array<glm::dvec2, 2>& found, const std::array<glm::dvec2, 2>& truth)
{
  return std::max(glm::length(found[0] - truth[0]), glm::length(found[1] - truth[1]));
}

/// Points that both eyes see, in front of the screen and behind it.
std::vector<glm::dvec3> RandomPoints(std::uint64_t seed, int count)
{
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> across(-60.0, 60.0), up(-45.0, 45.0), deep(-120.0, 120.0);
  std::vector<glm::dvec3> points;
  for (int k = 0; k < count; ++k)
  {
    const double x = across(engine), y = deep(engine), z = up(engine);
    points.emplace_back(x, y, z);
  }
  return points;
}

void AddRows(ReportContext& context, BallScene::Ball kind, const std::string& data)
{
  BallScene scene;
  double ours = 0.0, vtks = 0.0;
  const auto points = RandomPoints(context.settings.seed, context.settings.quick ? 6 : 40);
  for (const glm::dvec3& point : points)
  {
    scene.PlaceBall(point, kind);
    ours = std::max(ours, Error(scene.ByRig(), scene.Truth(point)));
    vtks = std::max(vtks, Error(scene.ByVtk(), scene.Truth(point)));
  }
  scene.PlaceBall(points.front(), kind);
  const PairedTimes times = ComparePairs([&] { return TimeOf([&] { scene.ByRig(); }); },
    [&] { return TimeOf([&] { scene.ByVtk(); }); }); // both read pixels: that waits for the GPU
  ReportRow place;
  place.id = "stereo.place.max@" + data;
  place.value = ours;
  place.unit = "pixel";
  place.better = Better::Lower;
  place.rival = std::string(Rival) + ": " + std::to_string(vtks) + " pixel";
  place.error = ours;
  place.errorUnit = "pixel";
  place.timeS = times.a.wallS;
  place.cpuS = times.a.cpuS;
  place.n = 2 * static_cast<int>(points.size());
  place.data = data + ", " + std::to_string(points.size()) + " random balls, 600 x 400 pixels";
  ReportRow pair = place;
  pair.id = "stereo.pair.time@" + data;
  pair.value = times.ratio.median;
  pair.unit = "ratio";
  pair.rival = Rival;
  pair.q1 = times.ratio.q1;
  pair.q3 = times.ratio.q3;
  pair.n = times.pairs;
  context.report.rows.insert(context.report.rows.end(), { place, pair });
  context.report.curves.push_back(
    { "stereo.error_time@" + data, "eye rig", "ms", "pixel", { { 1e3 * times.a.wallS, ours } } });
  context.report.curves.push_back({ "stereo.error_time@" + data, "VTK stereo", "ms", "pixel",
    { { 1e3 * times.b.wallS, vtks } } });
}

/// The camera maths alone has no pixels: it must hold for any eyes.
void AddStability(ReportContext& context)
{
  for (const double separation : { 0.0, 1e-6, 63.0, 1e4 })
  {
    StereoRig rig;
    rig.head.eyeSeparationMm = separation;
    const double depth = 250.0, expected = separation * depth / (600.0 + depth);
    const double found = ScreenDisparityMm(rig, { 40, -20, -depth });
    const double error = std::abs(found - expected) / std::max(expected, 1e-6);
    context.report.stability.push_back({ "stereo.disparity",
      "eyes " + std::to_string(separation) + " mm apart", error <= 1e-7, error, 1e-7, "relative" });
  }
}

} // namespace

void ReportStereo(ReportContext& context)
{
  ChooseWindows();
  context.report.machine.gl = OpenGLName();
  AddStability(context);
  context.progress(0.1, "stereo: balls as meshes");
  AddRows(context, BallScene::Ball::Mesh, "mesh");
  context.progress(0.5, "stereo: balls as volumes");
  AddRows(context, BallScene::Ball::Volume, "volume");
  ReportStereoLayouts(context);
#if HASP_WITH_CELLS
  ReportStereoSilhouettes(context);
#endif
  BallScene mono;
  mono.PlaceBall({ 0, 0, 0 }, BallScene::Ball::Mesh);
  context.report.unused = mono.SkippedInMono();
}

} // namespace hasp
