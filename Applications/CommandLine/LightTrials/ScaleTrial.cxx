// The same scene much smaller, much larger, and of cells that are a hundred times as long as wide.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr int Side = 48, Block = 8, Bounces = 4;

/// Spongy bone on a plate, some 40 mm across times `scale`; cells stretched along z, and squeezed
/// again by their matrix.
LitScene SceneOf(double scale, double stretched)
{
  LitBody bone = BodyOf(CellsOf(AnalyticTrabecular(18.0, 2.0, 8.0), 48, 20.0,
                          glm::dvec3(scale, scale, scale * stretched)),
    { glm::vec3(0.8F), 0.04F, 0.5F });
  bone.bodyToWorld = glm::scale(glm::dmat4(1.0), glm::dvec3(1, 1, 1.0 / stretched));
  LitBody plate = BodyOf(SquareMesh(24.0 * scale), { glm::vec3(0.5F) });
  plate.bodyToWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -18.5 * scale));
  return LitScene({ bone, plate }, {}, Daylight());
}

/// Means over blocks of pixels: a path that rounds to the other side of an edge is no error.
std::vector<double> BlocksOf(const LightPixels& pixels)
{
  std::vector<double> sums((Side / Block) * (Side / Block), 0.0);
  for (int y = 0; y < Side; ++y)
    for (int x = 0; x < Side; ++x)
    {
      const glm::vec4& pixel = pixels[std::size_t(y) * Side + x];
      sums[std::size_t(y / Block) * (Side / Block) + x / Block] +=
        (double(pixel.r) + pixel.g + pixel.b) / (3.0 * Block * Block);
    }
  return sums;
}

} // namespace

void MeasureLightScales(ReportContext& context)
{
  context.progress(0.0, "light: scenes of other sizes");
  const int samples = context.settings.quick ? 32 : 256;
  const auto seed = static_cast<std::uint32_t>(context.settings.seed);
  const auto picture = [&](const LitScene& scene)
  {
    return BlocksOf(
      PixelsOf(TracePaths(scene, OrbitView(scene, 30.0, Side), Bounces, samples, seed)));
  };
  const std::vector<double> plain = picture(SceneOf(1.0, 1.0));
  const double mean = std::max(1e-30, *std::max_element(plain.begin(), plain.end()));
  struct Case
  {
    const char *id, *text;
    double scale, stretched;
  };
  for (const Case& one : { Case{ "small", "1e-3 mm across", 1e-3 / 40.0, 1.0 },
         Case{ "large", "1e4 mm across", 1e4 / 40.0, 1.0 },
         Case{ "spacing", "cells 100 times as long as wide, and squeezed by their matrix", 1.0,
           100.0 } })
  {
    const LitScene scene = SceneOf(one.scale, one.stretched);
    std::vector<double> found;
    const Timing time = TimeOf([&] { found = picture(scene); });
    double worst = 0.0;
    for (std::size_t n = 0; n < plain.size(); ++n)
    {
      if (!std::isfinite(found[n]))
        worst = 1e30;
      if (plain[n] > 1e-3 * mean)
        worst = std::max(worst, std::abs(found[n] / plain[n] - 1.0));
      else if (found[n] > 1e-2 * mean)
        worst = std::max(worst, found[n] / mean);
    }
    ReportRow row = ErrorFigure(std::string("light.extreme.") + one.id, { worst, "relative" },
      "the same paths in the plain scene of 40 mm", time,
      std::string("spongy bone on a plate, ") + one.text +
        "; the worst of blocks of 8 x 8 pixels, " + std::to_string(samples) + " paths a pixel");
    row.bars = { { {}, 0.01 } };
    context.report.rows.push_back(row);
  }
}

} // namespace hasp
