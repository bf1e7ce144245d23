// After a cut of the view, and after the isovalue has jumped: how soon is how much right?
#include "RaycachingScene.h"

#include "Grid/MinMaxBlocks.h"
#include "Isosurface/RayCaster.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <algorithm>
#include <functional>

namespace hasp
{
namespace
{

constexpr double Mostly = 0.95; // of the surface's pixels

struct Contender
{
  std::string name;
  std::unique_ptr<IsosurfaceMethod> method;
};

std::vector<Contender> Contenders(const IsosurfaceView& view)
{
  const auto caching = [&](int mode) { return std::make_unique<CachingMethod>(view, mode); };
  std::vector<Contender> all;
  all.push_back({ "ray caching, cache", caching(vtkHaspRayCachingMapper::Cache) });
  all.push_back({ "ray caching, auto", caching(vtkHaspRayCachingMapper::Automatic) });
  all.push_back({ "ray cast, skipping", caching(vtkHaspRayCachingMapper::RaycastSkipping) });
  all.push_back({ "clustered cells", MakeCellMethod(view) });
  all.push_back({ "flying edges and mesh", MakeMeshMethod(view) });
  return all;
}

struct Course
{
  double firstMs = 0.0;  ///< of the first frame
  double mostlyMs = 0.0; ///< until 95 % of the surface's pixels were shown, or all of its frames
  double shown = 0.0;    ///< share of them then
  double firstPsnr = 0.0;
};

/// Frames after a change until `mostMs` have gone; a point of a curve each.
Course Follow(ReportContext& context, const std::string& id, Contender& contender,
  const PictureTruth& truth, int frames, double mostMs)
{
  ReportCurve curve{ id, contender.name, "ms", "dB", {} };
  Course course;
  double ms = 0.0;
  for (int frame = 0; frame < frames && ms < mostMs; ++frame)
  {
    ms += 1e3 * TimeOf([&] { contender.method->Draw(); }).wallS;
    const double psnr = ForegroundPsnr(truth, contender.method->Picture());
    curve.points.push_back({ ms, psnr });
    const SurfacePoints points = contender.method->Points();
    std::size_t surface = 0, shown = 0;
    for (std::size_t n = 0; n < points.size(); ++n)
    {
      surface += truth.surface[n];
      shown += truth.surface[n] && points[n];
    }
    if (frame == 0)
      course = { ms, 0.0, 0.0, psnr };
    if (course.shown < Mostly)
    {
      course.mostlyMs = ms;
      course.shown = surface == 0 ? 0.0 : double(shown) / double(surface);
    }
  }
  context.report.curves.push_back(curve);
  return course;
}

/// All contenders from the same start through the same change.
std::vector<Course> FollowAll(ReportContext& context, const RaycachingScene& scene,
  const std::string& what, double isovalue, double degrees)
{
  IsosurfaceView view = scene.View();
  CameraPath path(view);
  std::vector<Contender> contenders = Contenders(view);
  for (Contender& contender : contenders)
    for (int frame = 0; frame < 3 * SettlingFrames; ++frame) // also of the other isovalue
    {
      contender.method->SetIsovalue(scene.cells.isovalue + 10.0 * (frame % 3));
      contender.method->Draw();
    }
  for (Contender& contender : contenders)
  {
    contender.method->SetIsovalue(scene.cells.isovalue);
    for (int frame = 0; frame < 2 * SettlingFrames; ++frame)
      contender.method->Draw();
  }
  path.Orbit(1, degrees);
  const PictureTruth truth = TrueRaycachingPicture(view, isovalue);
  std::vector<Course> courses;
  for (Contender& contender : contenders)
  {
    contender.method->SetIsovalue(isovalue);
    courses.push_back(Follow(context, "raycaching.error_time@" + what + scene.cells.tag, contender,
      truth, context.settings.quick ? 6 : 20, 3000.0));
  }
  return courses;
}

void AddFirst95(ReportContext& context, const RaycachingScene& scene, const std::string& what,
  const std::vector<Course>& courses)
{
  const double mesh = courses.back().firstMs;
  for (const auto& [mode, n] : { std::pair("cache", 0), std::pair("auto", 1) })
  {
    ReportRow row;
    row.id = "raycaching.first95." + what + "@" + mode + scene.cells.tag;
    row.value = courses[n].mostlyMs / mesh;
    row.q1 = row.q3 = row.value;
    row.n = 1;
    row.unit = "of the first frame with a new mesh"; // one course, no pairs
    row.rival = "first frame of vtkFlyingEdges3D and its mesh after the same change";
    row.error = courses[n].firstPsnr;
    row.errorUnit = "dB in the first frame";
    row.timeS = courses[n].mostlyMs / 1e3;
    row.cpuS = 0.0;
    row.data = scene.data + ", until 95 % of the surface's pixels are shown, after " + what;
    row.bars = { { {}, 1.0 }, { Mostly, {}, "share of the pixels", courses[n].shown } };
    context.report.rows.push_back(row);
  }
}

/// The direct way with fewer rays: one for each square of n x n pixels.
double DirectPsnr(const std::vector<glm::vec3>& all, int width, const PictureTruth& truth, double n)
{
  std::vector<glm::vec3> coarse(all.size());
  for (std::size_t p = 0; p < all.size(); ++p)
  {
    const auto nearest = [&](std::size_t at)
    { return std::min(std::size_t(width - 1), std::size_t((std::floor(at / n) + 0.5) * n)); };
    coarse[p] = all[nearest(p / width) * width + nearest(p % width)];
  }
  return ForegroundPsnr(truth, coarse);
}

/// The first frame after a jump, against the direct rays that show as much.
void AddJump(ReportContext& context, const RaycachingScene& scene, int mode, const std::string& tag)
{
  IsosurfaceView view = scene.View();
  CachingMethod ours(view, mode);
  const auto direct = MakeDirectMethod(view), exact = MakeCellMethod(view);
  const double from = scene.cells.isovalue, to = 1.5 * from;
  PictureTruth truths[2] = { TrueRaycachingPicture(view, from), TrueRaycachingPicture(view, to) };
  std::vector<glm::vec3> full[2];
  for (int k = 0; k < 2; ++k)
  {
    exact->SetIsovalue(k ? to : from);
    exact->Draw();
    full[k] = exact->Picture();
  }
  for (int frame = 0; frame < 4 * SettlingFrames; ++frame) // both, so that Automatic has chosen
  {
    ours.SetIsovalue(frame % 3 ? from : to);
    ours.Draw();
  }
  int jump = 0;
  double worst = 99.0;
  const PairedTimes times = ComparePairs(
    [&]
    {
      for (int frame = 0; frame < 12; ++frame) // at rest
        ours.Draw();
      ours.SetIsovalue(++jump % 2 ? to : from);
      const Timing time = TimeOf([&] { ours.Draw(); });
      worst = std::min(worst, ForegroundPsnr(truths[jump % 2], ours.Picture()));
      return time;
    },
    [&]
    {
      direct->SetIsovalue(jump % 2 ? to : from);
      const Timing all = TimeOf([&] { direct->Draw(); });
      const double psnr = ForegroundPsnr(truths[jump % 2], ours.Picture());
      double n = 1.0; // pixels a ray: the most with which the direct way is still as good
      while (
        n < 16.0 && DirectPsnr(full[jump % 2], scene.pixels, truths[jump % 2], 1.1 * n) >= psnr)
        n *= 1.1;
      return Timing{ all.wallS / (n * n), all.cpuS / (n * n) };
    },
    { 1, 9 });
  ReportRow row = TimedRatio("raycaching.cost.isovalue" + tag + scene.cells.tag, times,
    direct->Name() + ", with the rays that show as much", { worst, "dB, worst of the frames" },
    scene.data + ", first frame after a jump of the isovalue by half, " + ours.Name());
  row.bars = { { {}, 0.8 } };
  context.report.rows.push_back(row);
}

} // namespace

void ReportRaycachingChanges(ReportContext& context, const RaycachingScene& scene)
{
  context.progress(0.0, "raycaching: changes of " + scene.data);
  const double isovalue = scene.cells.isovalue;
  AddFirst95(context, scene, "cut", FollowAll(context, scene, "cut", isovalue, 90.0));
  AddFirst95(context, scene, "jump", FollowAll(context, scene, "jump", 1.5 * isovalue, 0.0));
  AddJump(context, scene, vtkHaspRayCachingMapper::Automatic, "");
  AddJump(context, scene, vtkHaspRayCachingMapper::Cache, "@cache");
}

} // namespace hasp
