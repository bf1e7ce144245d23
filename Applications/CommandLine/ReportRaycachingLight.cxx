// Light that adds up in a cache, against light by rays of each pixel's own.
#include "RaycachingScene.h"

#include "DirectLight.h"
#include "Evaluation/Flip.h"
#include "MeasuredRows.h"
#include "ReportRegistry.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr int Rays = 16; // a pixel, of the rival
/// A pixel, of the truth: an eighth of the rival's error, which shifts it by a hundredth.
constexpr int TruePictureRays = 256;
constexpr int FirstMoving = 8; // frame that counts

double ForegroundFlip(const PictureTruth& truth, const std::vector<glm::vec3>& shown, int width)
{
  const std::vector<float> flip = Flip(truth.pixels, shown, width);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t n = 0; n < flip.size(); ++n)
    if (truth.surface[n])
    {
      sum += flip[n];
      ++count;
    }
  if (count == 0)
    throw std::runtime_error("the report's orbit shows no surface of this volume: its light cannot "
                             "be compared");
  return sum / double(count);
}

struct Pictures
{
  int frame;
  std::vector<glm::vec3> ours, direct;
};

/// The worst of some frames.
struct LitErrors
{
  double ours = 99.0, direct = 99.0; ///< dB, foreground
  double oursFlip = 0.0, directFlip = 0.0;
  double lead = 99.0;    ///< least dB by which ours is better
  double flipLead = 1.0; ///< and by how much less FLIP sees of it
  std::string Text() const
  {
    char text[160];
    std::snprintf(text, sizeof text, "; PSNR %.2f dB, its %.2f, FLIP %.4f, its %.4f", this->ours,
      this->direct, this->oursFlip, this->directFlip);
    return text;
  }
};

LitErrors Judge(const std::vector<Pictures>& pictures, const RaycachingScene& scene,
  CameraPath& path, DirectLight& direct)
{
  LitErrors worst;
  for (const Pictures& p : pictures)
  {
    path.Orbit(p.frame);
    direct.Draw({ TruePictureRays, scene.DarkeningMm, scene.TowardsLight() }, 999U + p.frame);
    const PictureTruth& truth = direct.Picture();
    const double a = ForegroundPsnr(truth, p.ours), b = ForegroundPsnr(truth, p.direct);
    const double fa = ForegroundFlip(truth, p.ours, scene.pixels),
                 fb = ForegroundFlip(truth, p.direct, scene.pixels);
    worst.ours = std::min(worst.ours, a);
    worst.direct = std::min(worst.direct, b);
    worst.oursFlip = std::max(worst.oursFlip, fa);
    worst.directFlip = std::max(worst.directFlip, fb);
    worst.lead = std::min(worst.lead, a - b);
    worst.flipLead = std::min(worst.flipLead, fb - fa);
  }
  return worst;
}

/// A picture as a window would keep it: both rivals are held against the truth in 8 bits.
std::vector<glm::vec3> InBytes(std::vector<glm::vec3> picture)
{
  for (glm::vec3& pixel : picture)
    for (int c = 0; c < 3; ++c)
      pixel[c] = std::round(255.0F * pixel[c]) / 255.0F;
  return picture;
}

void AddLitCost(ReportContext& context, const RaycachingScene& scene)
{
  IsosurfaceView view = scene.View();
  CameraPath path(view);
  CachingMethod ours(view, vtkHaspRayCachingMapper::Automatic);
  ours.Light(scene.TowardsLight(), scene.DarkeningMm, scene.Ambient, scene.Diffuse);
  DirectLight direct(view);
  const DirectLightSettings settings{ Rays, scene.DarkeningMm, scene.TowardsLight() };
  int frame = 0;
  for (; frame < FirstMoving - 1; ++frame) // all of them move
  {
    path.Orbit(frame);
    ours.Draw();
  }
  std::vector<Pictures> pictures;
  const PairedTimes times = ComparePairs(
    [&]
    {
      path.Orbit(frame);
      return TimeOf([&] { ours.Draw(); });
    },
    [&]
    {
      const Timing time = TimeOf([&] { direct.Draw(settings, frame); });
      if (frame == FirstMoving || frame == FirstMoving + 8)
        pictures.push_back({ frame, ours.Picture(), InBytes(direct.Picture().pixels) });
      ++frame;
      return time;
    },
    { 1, 9 });
  const LitErrors errors = Judge(pictures, scene, path, direct);
  ReportRow row = TimedRatio("raycaching.cost.lit@auto" + scene.cells.tag, times,
    "Embree over active cells, " + std::to_string(Rays) + " ambient rays and a shadow ray a pixel",
    { errors.oursFlip, "FLIP, of surface pixels" },
    scene.data + ", orbit 1 degree a frame from the " + std::to_string(FirstMoving) +
      "th moving frame, ambient occlusion and hard shadow against " +
      std::to_string(TruePictureRays) + " rays" + errors.Text());
  row.bars = { { {}, 0.25 }, { 0.0, {}, "least lead in PSNR, dB,", errors.lead },
    { 0.0, {}, "least lead in FLIP", errors.flipLead } };
  context.report.rows.push_back(row);
  context.report.rows.push_back(AbsentRow("raycaching.cost.lit@cache" + scene.cells.tag, "the same",
    "cached bricks are drawn without light: what lights them are traced rays, and where "
    "those are cast the first ones are cheaper than bricks; see @auto"));
}

} // namespace

void ReportRaycachingLight(ReportContext& context, const RaycachingScene& scene)
{
  context.progress(0.0, "raycaching: light of " + scene.data);
  AddLitCost(context, scene);
}

} // namespace hasp
