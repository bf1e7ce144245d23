#include "StabilityChecks.h"

#include "CachingMethod.h"
#include "CellDepth.h"
#include "CellRenderers.h"
#include "Evaluation/TrilinearTruth.h"
#include "ExtremeVolumes.h"
#include "ReportRegistry.h"
#include "vtkHaspVolumeView.h"

#include "vtkCamera.h"
#include "vtkImageData.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <utility>

namespace hasp
{
namespace
{

/// How far a renderer may be off, voxels: the bar of `hasp report cells`.
constexpr double DepthLimit = 1e-3;
/// The shader's division, scaling and offset round depth to float, the buffer to 24 bits.
constexpr double Roundings = 4.0;

/// Draws until it has found everything.
class CompleteCache : public CachingMethod
{
public:
  using CachingMethod::CachingMethod;
  void Draw() override
  {
    for (int frame = 0, quiet = 0; frame < 1000 && quiet < 64; ++frame)
    {
      CachingMethod::Draw();
      quiet = (*this)->IsRefining() ? 0 : quiet + 1;
    }
  }
};

/// The largest way between two values of a 24-bit depth buffer, voxels: what a picture cannot say.
double DepthStep(const IsosurfaceView& view, const DepthTruth& truth)
{
  const glm::dvec3& s = GeometryOf(truth.grid).spacing;
  const glm::dmat4 worldToClip = glm::inverse(view.clipToWorld);
  double largest = 0.0;
  for (const auto& hit : truth.hits)
    if (hit)
    {
      glm::dvec4 clip = worldToClip * glm::dvec4(hit->position, 1.0);
      clip /= clip.w;
      const auto at = [&](double depth)
      {
        const glm::dvec4 p = view.clipToWorld * glm::dvec4(clip.x, clip.y, depth, 1.0);
        return glm::dvec3(p) / p.w;
      };
      largest = std::max(largest, glm::length(at(clip.z + 2.0 * 0x1p-24) - at(clip.z)));
    }
  return largest / std::min({ s.x, s.y, s.z });
}

} // namespace

void AddStability(ReportContext& context, const std::string& id, const std::string& testCase,
  double figure, double limit, const std::string& unit)
{
  context.report.stability.push_back({ id, testCase, figure <= limit, figure, limit, unit });
}

/// In a picture, cells overlap by 1e-4 voxel: beside a hole of `volume` a pixel in a thousand may
/// show a root just outside its cell; and denormal samples may be gone. The ray cache holds what
/// rays have met by chance: after 64 frames without a find a pixel in a thousand may still wait for
/// one, as its aim for holes allows (after 200 none did).
void CheckStablePicture(ReportContext& context, const std::string& name, const IsosurfaceView& view,
  const ExtremeVolume& volume)
{
  const DepthTruth truth(view);
  std::vector<NamedMethod> renderers = CellRenderers(view);
  std::erase_if(
    renderers, [](const NamedMethod& r) { return r.id == "automatic"; }); // one of the others
  if (auto tracer = MakeTracerMethod(view))
    renderers.push_back({ "rays", std::move(tracer) });
  renderers.push_back(
    { "caching", std::make_unique<CompleteCache>(view, vtkHaspRayCachingMapper::Cache) });
  renderers.push_back(
    { "caching.auto", std::make_unique<CompleteCache>(view, vtkHaspRayCachingMapper::Automatic) });
  for (const NamedMethod& renderer : renderers)
  {
    renderer.method->Draw();
    const bool picture = renderer.id != "rays"; // those give the hit itself
    const DepthErrors errors = MeasureDepth(truth, renderer.method->Points());
    // By rays: asked for, or what Automatic has measured to be cheaper, which hangs on the machine.
    const bool found = renderer.method->Name().starts_with("ray caching, cache");
    const bool gone = picture && volume.denormal && errors.missed == errors.surface;
    AddStability(context, "stability.missed." + renderer.id, name + ": " + errors.Text(),
      double((gone ? 0 : errors.missed) + errors.invented),
      (picture && volume.holes) || found ? 1e-3 * double(errors.surface) : 0.0, "pixels");
    AddStability(context, "stability.depth." + renderer.id, name, errors.max,
      picture ? DepthLimit + Roundings * DepthStep(view, truth) : DepthLimit, "voxel");
  }
}

void CheckStableEyes(ReportContext& context, const ExtremeVolume& ball, int pixels)
{
  const auto look = [&](const std::string& name, const glm::dvec3& eye, const glm::dvec3& at,
                      double angle, double nearMm, double farMm, bool parallel = false)
  {
    IsosurfaceView view(ball.image, ball.isovalue, pixels, pixels, ObliqueView);
    view.camera->SetPosition(eye.x, eye.y, eye.z);
    view.camera->SetFocalPoint(at.x, at.y, at.z);
    view.camera->SetViewAngle(angle);
    view.camera->SetClippingRange(nearMm, farMm);
    view.camera->SetParallelProjection(parallel);
    view.camera->SetParallelScale(8.0);
    view.CameraMoved();
    CheckStablePicture(context, name, view, ball);
  };
  const double voxel = 0.7, far = 1e6 * voxel;
  // The ball is 13 mm across, the volume's diagonal 28.
  look("eye 1e6 voxels away", -far * ObliqueView, glm::dvec3(0), 0.0015, far - 15, far + 15);
  look("eye inside the ball", { 1, 2, 0.5 }, { 1, 3, 0.5 }, 80.0, 0.05, 30.0);
  look("eye on the surface", 0.4 * 24 * voxel * ObliqueView, glm::dvec3(0), 60.0, 0.01, 30.0);
  const auto hit =
    FirstTrilinearHit(ViewImage(ball.image), ball.isovalue, -30.0 * ObliqueView, ObliqueView);
  look("eye 1e-3 mm over the surface", hit.value().position - 1e-3 * ObliqueView, glm::dvec3(0),
    60.0, 1e-4, 30.0);
  look("eye 1e4 mm away", -1e4 * ObliqueView, glm::dvec3(0), 0.15, 9980.0, 10020.0);
  look("near plane through the ball", -20.0 * ObliqueView, glm::dvec3(0), 40.0, 20.0, 60.0);
  look("parallel projection", -30.0 * ObliqueView, glm::dvec3(0), 30.0, 5.0, 60.0, true);
  const GridGeometry grid = ImageGeometry(ball.image);
  for (int axis = 0; axis < 3; ++axis) // along the grid, the middle column of pixels in its planes
    look("rays along grid axis " + std::to_string(axis), -30.0 * grid.direction[axis],
      glm::dvec3(0), 30.0, 5.0, 60.0, true);
}

} // namespace hasp
