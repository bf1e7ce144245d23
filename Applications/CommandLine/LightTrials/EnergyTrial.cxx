// Radiance by the number of bounces: it never grows beyond what there is, and each adds less.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include <algorithm>
#include <cstdio>

namespace hasp
{
namespace
{
constexpr float Albedo = 0.8F;
constexpr int Bounces = 8;
} // namespace

void MeasureEnergy(ReportContext& context, const LightData& data)
{
  context.progress(0.0, "light: energy by bounces on " + data.data);
  const bool quick = context.settings.quick;
  const LitScene scene({ BodyOf(data.cells, { glm::vec3(Albedo) }) }, {}, UniformLight(1.0F));
  const PictureView view = OrbitView(scene, 0.0, quick ? 64 : 128);
  std::vector<double> means;
  std::string by;
  const Timing time = TimeOf(
    [&]
    {
      for (int bounces = 1; bounces <= Bounces; ++bounces)
      {
        means.push_back(MeanRadiance(PixelsOf(TracePaths(scene, view, bounces, quick ? 32 : 256,
          static_cast<std::uint32_t>(context.settings.seed)))));
        context.progress(double(bounces) / Bounces, "");
      }
    });
  double worst = 0.0;
  for (int n = 0; n < Bounces; ++n)
  {
    char text[20];
    std::snprintf(text, sizeof text, "%s%.4f", n > 0 ? ", " : "", means[n]);
    by += text;
    if (n >= 2) // the second bounce's light over the first's has another reason: what is open
      worst = std::max(worst, (means[n] - means[n - 1]) / (means[n - 1] - means[n - 2]));
  }
  const double most = *std::max_element(means.begin(), means.end());
  const std::string text =
    data.data + ", albedo 0.8, the same light from everywhere; by bounces " + by;
  ReportRow row = ErrorFigure("light.energy" + data.tag,
    { std::max(0.0, most / Albedo - 1.0), "beyond the bound" },
    "the furnace's bound: no more than the albedo", time, text);
  row.value = most / Albedo;
  row.unit = "of the bound";
  row.bars = { { {}, 1.0 } };
  context.report.rows.push_back(row);
  row.id = "light.energy.increments" + data.tag;
  row.value = worst;
  row.unit = "of the increment before, at most";
  row.rival = "what a bounce can give back of the one before: the albedo";
  row.error = std::max(0.0, worst / Albedo - 1.0);
  row.bars = { { {}, 1.0 } };
  context.report.rows.push_back(row);
}

} // namespace hasp
