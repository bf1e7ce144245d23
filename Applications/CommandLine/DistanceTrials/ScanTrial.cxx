#include "Distance/ChamferDistance.h"
#include "Distance/Coverage.h"
#include "Distance/CoverageDistance.h"
#include "DistanceErrors.h"
#include "DistanceTrials.h"
#include "ReportRegistry.h"
#include "TrialShapes.h"
#include "TrialTimes.h"

#include <glm/geometric.hpp>

#include <cstdio>

namespace hasp
{
namespace
{

constexpr int Samples = 64;
constexpr int Border = 12; ///< the surface beyond the window is not seen: it would be nearer there
constexpr double BlurVoxels = 0.8, Noise = 0.03;

/// A shape moved so that a place of its surface, in any direction, is in the window's middle.
AnalyticVolume Moved(bool torus, const glm::dvec3& offCentre, std::mt19937_64& random)
{
  const double v = TrialVoxelMm;
  const glm::dvec3 way = AnyDirection(random);
  if (!torus)
    return AnalyticSphere(v * (offCentre - 80.3 * way), 80.3 * v);
  const glm::dvec3 axis = glm::normalize(glm::cross(way, AnyDirection(random)));
  const glm::dvec3 round = std::cos(0.8) * way + std::sin(0.8) * axis; // from the tube's middle
  return AnalyticTorus(v * (offCentre - 70.0 * way - 20.0 * round), axis, 70.0 * v, 20.0 * v);
}

/// Trilinear isosurface at half the step, inside or not by 5^3 places a voxel, as guides have it.
std::vector<float> CoverageOf(const std::vector<float>& image, const GridGeometry& grid)
{
  CoverageSettings settings;
  settings.isovalue = 0.5;
  return Coverage(GridView<const float>{ image.data(), grid }, grid, settings);
}

struct Method
{
  const char* id;
  const char* name;
  DistanceErrors errors{ TrialVoxelMm }, clean{ TrialVoxelMm };
  Timing time{};
};

} // namespace

void TryScans(ReportContext& context)
{
  const GridGeometry grid = TrialGrid(Samples);
  const int step = context.settings.quick ? 9 : 1;
  std::mt19937_64 random(context.settings.seed);
  Method guide{ "distance.rms.ct", "the guides' transform on coverage of it" };
  Method grey{ "distance.rms.ct.grey", "GreyDistance of the image as it is" };
  Method chamfer{ "distance.rms.ct.chamfer", "anti-aliased <3,4,5> on coverage of it" };
  for (int n = 0; n < 27; n += step)
    for (const bool torus : { false, true })
      for (const double noise : { 0.0, Noise })
      {
        if (noise == 0.0 && n % 9 != 0)
          continue; // printed beside
        const std::uint64_t seed = context.settings.seed + static_cast<std::uint64_t>(n);
        const AnalyticVolume shape = Moved(torus, SubVoxelCentre(n, seed), random);
        const std::vector<float> image = ScannedImage(shape, grid, BlurVoxels, noise, seed);
        const std::vector<double> truth = TrueDistances(shape, grid);
        const std::vector<float> coverage = CoverageOf(image, grid);
        const ErrorRange range{ -3.0, 3.0, Border };
        const auto measure = [&](Method& method, auto transform)
        {
          std::vector<float> distances;
          const Timing time =
            OnThreads(1, [&] { return TimeOf([&] { distances = transform(); }); });
          if (noise > 0.0)
            method.time = time;
          AddErrors(
            distances, truth, grid, range, shape.name, noise > 0.0 ? method.errors : method.clean);
        };
        measure(guide, [&] { return CoverageDistanceBand(grid, coverage); });
        measure(grey,
          [&] {
            return GreyDistance(GridView<const float>{ image.data(), grid }, 0.5);
          });
        measure(chamfer, [&] { return ChamferDistance(grid, coverage); });
      }
  for (const Method* method : { &guide, &grey, &chamfer })
  {
    char text[260];
    std::snprintf(text, sizeof text,
      "windows of %d^3 on a sphere R 80.3 and a torus 70/20 voxels, any place and way, %d centres, "
      "blur 0.8 voxel, noise 3 %%, within 3 voxels; %s; without noise RMS %.3g; ",
      Samples, 26 / step + 1, method->name, method->clean.Rms());
    ReportRow row = ErrorFigure(method->id, { method->errors.Rms(), "voxel" }, "closed form",
      method->time, text + method->errors.Text());
    if (method != &chamfer)
    {
      row.rival = "closed form; anti-aliased <3,4,5> here: " + chamfer.errors.Text();
      row.bars = { { {}, 0.035 } };
      row.data += "; aim 0.02";
    }
    row.n = static_cast<int>(method->errors.Count());
    context.report.rows.push_back(row);
  }
}

} // namespace hasp
