// Disparities in every layout, on a screen and in a head-mounted display.
#include "DisparityScene.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "ReportStereo.h"

#include "vtkVersionMacros.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr StereoLayout Layouts[] = { StereoLayout::SideBySide, StereoLayout::TopBottom,
  StereoLayout::Anaglyph, StereoLayout::Interlaced, StereoLayout::Checkerboard,
  StereoLayout::DualWindow, StereoLayout::QuadBuffer };

constexpr double Bar = 0.5; // pixels; the aim is 0.1

std::vector<StereoHead> Heads(bool quick)
{
  const glm::dvec3 tilted = glm::normalize(glm::dvec3(1, 0.35, 0.1));
  std::vector<StereoHead> heads{ { { 140, -60, 520 } }, { { -120, 90, 700 }, tilted } };
  if (!quick)
    heads.insert(heads.end(), { { { 0, 0, 600 } }, { { 20, 30, 450 }, { 1, 0, 0 }, 70 } });
  for (StereoHead& head : heads)
    head.up = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), head.right));
  return heads;
}

struct Worst
{
  double ours = 0.0, vtk = 0.0;
  int n = 0;
};

Worst MeasureDisparities(DisparityScene& scene, bool quick, bool screen)
{
  std::vector<glm::dvec3> points{ { 60, -35, 90 } };
  if (!quick)
    points.insert(
      points.end(), { { 0, 0, 0 }, { -55, 40, -160 }, { 30, 20, 40 }, { -80, -30, -60 } });
  Worst worst;
  for (const StereoHead& head : Heads(quick))
    for (const glm::dvec3& point : points)
    {
      scene.Place(head,
        screen ? point : head.position + 0.5 * point - 500.0 * glm::cross(head.right, head.up));
      const glm::dvec2 truth = scene.Truth();
      worst.ours = std::max(worst.ours, glm::length(scene.Drawn() - truth));
      if (screen)
        worst.vtk = std::max(worst.vtk, glm::length(scene.ByVtk() - truth));
      ++worst.n;
    }
  return worst;
}

void AddLayout(ReportContext& context, StereoLayout layout, bool screen)
{
  StereoWindow window;
  window.output.layout = layout;
  const FieldOfView out{ 0.65, 0.5, 0.4, 0.5 }, in{ 0.5, 0.65, 0.4, 0.5 };
  if (screen)
    window.screen.emplace();
  else
    window.hmd = StereoHmd{ { out, in } };
  DisparityScene scene(window);
  const Worst worst = MeasureDisparities(scene, context.settings.quick, screen);
  const std::string name = StereoLayoutName(layout);
  const MeasuredError error{ worst.ours, "pixel" };
  PairedTimes times;
  scene.SetSamples(0);
  if (screen)
    times = ComparePairs([&] { return scene.TimeOurs(); }, [&] { return scene.TimeVtk(); });
  else
  {
    scene.TimeOurs(); // makes what later frames have
    times.a = scene.TimeOurs();
  }
  const std::string data = "640 x 400 pixels (4 samples but for times), one ball, " +
                           std::to_string(worst.n) + " heads and places, " +
                           (screen ? "520 x 325 mm screen" : "head-mounted display");
  char vtks[80];
  std::snprintf(
    vtks, sizeof vtks, "VTK " VTK_VERSION " stereo, a camera at the head: %.3g pixel", worst.vtk);
  ReportRow row = ErrorFigure("stereo.disparity.max@" + name + (screen ? "" : ".hmd"), error,
    screen ? vtks : "closed form", times.a, data);
  row.bars = { { {}, Bar } };
  row.n = worst.n;
  context.report.rows.push_back(row);
  if (!screen)
    return;
  context.report.rows.push_back(
    TimedRatio("stereo.pair.time@" + name, times, scene.VtkName(), error, data));
  context.report.curves.push_back(
    { "stereo.error_time@layouts", name, "ms", "pixel", { { 1e3 * times.a.wallS, worst.ours } } });
}

} // namespace

void ReportStereoLayouts(ReportContext& context)
{
  for (const StereoLayout layout : Layouts)
  {
    context.progress(0.6, std::string("stereo: ") + StereoLayoutName(layout));
    AddLayout(context, layout, true);
    AddLayout(context, layout, false);
  }
}

} // namespace hasp
