// Light that is kept on surfaces against paths from scratch, at equal error.
#include "LightScenes.h"
#include "LightTrials.h"

#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include "Light/SceneLightCache.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr int Bounces = 3, Pictures = 16, Pairs = 9;
constexpr double Bar = 0.5;

struct Reached
{
  Timing time; ///< so far; of a moving view, of the picture alone
  double rmse;
};
using Course = std::vector<Reached>;

Timing Sum(const Timing& a, const Timing& b)
{
  return { a.wallS + b.wallS, a.cpuS + b.cpuS };
}

struct Trial
{
  const LitScene& scene;
  PictureView view;
  LightPixels truth;
  int mostSamples;
};

/// The same picture again and again.
Course KeepStill(const Trial& trial)
{
  SceneLightCache cache;
  LitPicture lit;
  Course course;
  Timing all;
  for (int n = 0; n < Pictures; ++n)
  {
    all = Sum(all, TimeOf([&] { cache.Light(trial.scene, trial.view, {}, {}, lit); }));
    course.push_back({ all, RmsError(lit, trial.truth) });
  }
  return course;
}

/// The last of so many pictures, each a degree further about the scene, that ends at the view.
Reached KeepMoving(const Trial& trial)
{
  SceneLightCache cache;
  LitPicture lit;
  Timing last;
  for (int n = 1; n <= Pictures; ++n)
  {
    const PictureView view = OrbitView(trial.scene, double(n - Pictures), trial.view.size.x);
    last = TimeOf([&] { cache.Light(trial.scene, view, {}, {}, lit); });
  }
  return { last, RmsError(lit, trial.truth) };
}

/// After 1, 2, 4 ... samples, until the error is so small.
Course TraceAnew(const Trial& trial, double until, std::uint32_t seed)
{
  PathTracedPicture picture;
  Course course;
  Timing all;
  for (int n = 1; n <= trial.mostSamples; ++n)
  {
    all =
      Sum(all, TimeOf(
                 [&] {
                   AddPathSample(trial.scene, trial.view, { { Bounces }, seed, false }, picture);
                 }));
    if ((n & (n - 1)) != 0)
      continue;
    course.push_back({ all, RmsError(PixelsOf(picture), trial.truth) });
    if (n > 1 && course.back().rmse <= until)
      break;
  }
  return course;
}

/// The time at which paths reach that error: between those measured in logarithms, as the last two
/// go on beyond them, and never below that of one sample.
Timing TimeFor(const Course& paths, double rmse)
{
  std::size_t n = 0;
  while (n + 2 < paths.size() && paths[n + 1].rmse > rmse)
    ++n;
  const Reached &a = paths[n], &b = paths[n + 1];
  const double part = std::max(0.0, std::log(a.rmse / rmse) / std::log(a.rmse / b.rmse));
  const auto at = [&](double from, double to) { return from * std::pow(to / from, part); };
  return { at(a.time.wallS, b.time.wallS), at(a.time.cpuS, b.time.cpuS) };
}

struct Rounds
{
  std::vector<Course> still, paths;
  std::vector<Reached> moving;
};

/// In turn, so that what disturbs the machine disturbs all of them.
Rounds Play(ReportContext& context, const Trial& trial)
{
  Rounds rounds;
  for (int n = 0; n <= Pairs; ++n) // one to warm up
  {
    rounds.still.push_back(KeepStill(trial));
    rounds.moving.push_back(KeepMoving(trial));
    const double least = std::min(rounds.still[0].back().rmse, rounds.moving[0].rmse);
    rounds.paths.push_back(
      TraceAnew(trial, least, static_cast<std::uint32_t>(1000 * context.settings.seed) + n));
    context.progress(double(n + 1) / (Pairs + 1), "");
  }
  return rounds;
}

/// kept(round): what was reached, and in what time.
template <typename Kept>
void AddRow(ReportContext& context, const std::string& id, const Rounds& rounds, const Kept& kept,
  const std::string& data, bool bar)
{
  std::size_t a = 0, b = 0;
  const PairedTimes times = ComparePairs([&] { return kept(a++).time; },
    [&]
    {
      const std::size_t round = b++;
      return TimeFor(rounds.paths[round], kept(round).rmse);
    },
    { 1, Pairs });
  const double rmse = kept(0).rmse;
  char text[200];
  std::snprintf(text, sizeof text,
    "; paths anew need %.3g ms of CPU time, from %.4f after one sample to %.4f after %d",
    1e3 * times.b.cpuS, rounds.paths[0].front().rmse, rounds.paths[0].back().rmse,
    1 << (rounds.paths[0].size() - 1));
  ReportRow row = CpuRatio(id, times,
    "paths anew (AddPathSample, 3 bounces, Sobol points), as long as they need for the same error",
    { rmse, "RMSE of radiance" }, data + text);
  if (bar)
    row.bars = { { {}, Bar } };
  context.report.rows.push_back(row);
}

void DrawPaths(
  ReportContext& context, const std::string& id, const std::string& method, const Course& course)
{
  ReportCurve curve{ id, method, "ms of CPU time", "RMSE of radiance", {} };
  for (const Reached& reached : course)
    curve.points.emplace_back(1e3 * reached.time.cpuS, reached.rmse);
  context.report.curves.push_back(curve);
}

} // namespace

void MeasureHybrid(ReportContext& context, const LightData& data, const HybridSettings& settings)
{
  context.progress(0.0, "light: the truth of kept light on " + data.data);
  const int side = settings.side, samples = settings.truthSamples;
  const LitScene scene({ BodyOf(data.cells, { glm::vec3(0.8F) }) }, {}, Daylight());
  Trial trial{ scene, OrbitView(scene, 0.0, side), {}, settings.mostSamples };
  const auto seed = static_cast<std::uint32_t>(77'000'000 + 2 * context.settings.seed);
  PathTracedPicture half = TracePaths(scene, trial.view, Bounces, samples / 2, seed);
  const LightPixels one = PixelsOf(half),
                    other = PixelsOf(TracePaths(scene, trial.view, Bounces, samples / 2, seed + 1));
  trial.truth = one;
  for (std::size_t n = 0; n < one.size(); ++n)
    trial.truth[n] = 0.5F * (one[n] + other[n]);
  context.progress(0.0, "light: kept and anew on " + data.data);
  const Rounds rounds = Play(context, trial);

  char text[160];
  std::snprintf(text, sizeof text,
    ", %d x %d pixels under daylight; the truth has %d paths a pixel, itself off by %.4f", side,
    side, samples, 0.5 * RmsError(one, other));
  const std::string of = data.data + text;
  const auto still = [&](int pictures)
  {
    return [&rounds, pictures](std::size_t round)
    { return rounds.still[round][std::size_t(pictures - 1)]; };
  };
  for (const int pictures : { 1, 2, 4, 8 })
    AddRow(context, "light.hybrid.still." + std::to_string(pictures) + data.tag, rounds,
      still(pictures),
      of + "; the view stays, " + std::to_string(pictures) +
        (pictures > 1 ? " pictures together" : " picture"),
      false);
  AddRow(context, "light.hybrid.still" + data.tag, rounds, still(Pictures),
    of + "; the view stays, 16 pictures together; aim 0.2", data.tag.empty());
  AddRow(
    context, "light.hybrid.moving" + data.tag, rounds,
    [&](std::size_t round) { return rounds.moving[round]; },
    of + "; the view turns a degree a picture, the 16th alone; aim 0.2", data.tag.empty());
  const std::string id = "light.hybrid.error_time" + data.tag;
  DrawPaths(context, id, "kept, still", rounds.still.back());
  DrawPaths(context, id, "kept, the 16th moving", { rounds.moving.back() });
  DrawPaths(context, id, "paths anew", rounds.paths.back());
}

} // namespace hasp
