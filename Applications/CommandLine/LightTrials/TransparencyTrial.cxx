#include "TransparencyTrial.h"

#include "LayerPicture.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include <array>
#include <cstdio>
#include <string>

namespace hasp
{
namespace
{

constexpr double AllowedMax = 2.0; // of 255: what is out of order, missing or there twice is more

struct Way
{
  LayerOrder order;
  const char* id;
  const char* name;
};
constexpr Way Ways[] = { { LayerOrder::Peeled, "peeled", "depth peeling" },
  { LayerOrder::Weighted, "weighted", "VTK's weighted blending" },
  { LayerOrder::Unsorted, "unsorted", "blending without sorting" } };

/// The last picture and its time; the first one compiles shaders.
Timing DrawTwice(LayerPicture& picture, LayerOrder order)
{
  picture.Draw(order);
  return picture.Draw(order);
}

} // namespace

void MeasureLayers(ReportContext& context, int layers)
{
  LayerPicture picture(layers);
  const std::string at = "@" + std::to_string(layers);
  const std::string data =
    std::to_string(layers) + " layers of opacity 0.5, balls of cells and planes of polydata, " +
    std::to_string(LayerPicture::Width) + " x " + std::to_string(LayerPicture::Height) + " pixels";
  std::array<LayerPicture::Error, 3> errors;
  for (std::size_t n = 0; n < errors.size(); ++n)
  {
    const Timing time = DrawTwice(picture, Ways[n].order);
    errors[n] = picture.FindError();
    const auto add = [&](const std::string& what, double value)
    {
      ReportRow row =
        ErrorFigure("light.transparency." + what + "." + Ways[n].id + at, { value, "of 255" },
          "all that a ray meets, sorted", time, std::string(Ways[n].name) + ", " + data);
      if (what == "max" && Ways[n].order == LayerOrder::Peeled)
        row.bars = { { {}, AllowedMax } };
      context.report.rows.push_back(row);
    };
    add("max", errors[n].largest);
    add("rms", errors[n].rms);
  }
  for (std::size_t n = 1; n < errors.size(); ++n)
  {
    const PairedTimes times = ComparePairs([&] { return picture.Draw(LayerOrder::Peeled); },
      [&] { return picture.Draw(Ways[n].order); });
    char rival[100];
    std::snprintf(
      rival, sizeof rival, "%s: up to %.3g of 255 off", Ways[n].name, errors[n].largest);
    context.report.rows.push_back(
      TimedRatio(std::string("light.transparency.time.") + Ways[n].id + at, times, rival,
        { errors[0].largest, "of 255" }, data));
  }
}

void MeasureTransparency(ReportContext& context)
{
  int done = 0;
  for (const int layers : { 4, 6, 8 })
  {
    context.progress(done++ / 3.0, "transparency: " + std::to_string(layers) + " layers");
    MeasureLayers(context, layers);
  }
}

} // namespace hasp
