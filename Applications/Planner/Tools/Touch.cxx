#include "Tools/Touch.h"

#include "BoneTouch.h"
#include "PlanFragmentLabels.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"
#include "View/SliceView.h"
#include "vtkHaspVolumeView.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace hasp
{

namespace
{
constexpr double SnapMm = 2.5;
constexpr double NearMm = 1.5; // a fragment's surface is so near to what touches it in a slice

const PlanFragment* FragmentOf(const Plan& plan, PlanId id)
{
  return FindPlanObject<PlanFragment>(plan, id);
}

std::optional<SliceAxis> SliceOf(ViewGrid& views, const FrameView& view)
{
  for (const SliceAxis axis : SliceAxes)
    if (static_cast<const FrameView*>(&views.Slice(axis)) == &view)
      return axis;
  return std::nullopt;
}

/// How near a place is to a fragment's voxels, mm: 0 in it; nothing: farther than NearMm.
std::optional<double> AwayFrom(Planner& planner, const PlanFragment& fragment, const glm::dvec3& at)
{
  vtkImageData* image = planner.scene.ImageOfFragment(fragment.id);
  if (!image)
    return std::nullopt;
  const AnyGridView voxels = ViewImage(image);
  const double isovalue = IsovalueOfFragment(planner.plan.Now(), fragment.id);
  if (IsInBone(voxels, isovalue, at))
    return 0.0;
  const auto touched = TouchBone(voxels, isovalue, at, NearMm);
  return touched ? std::optional(glm::distance(touched->place, at)) : std::nullopt;
}

/// The fragment of the scan that is shown that a place is in, or nearest to.
PlanId FragmentAt(Planner& planner, const glm::dvec3& inScan)
{
  const Plan& plan = planner.plan.Now();
  double nearest = NearMm;
  PlanId found = 0;
  for (const PlanFragment& fragment : plan.fragments)
  {
    if (!planner.scene.IsVisible(fragment.id) || IsDivided(plan, fragment.id) ||
        VolumeOfFragment(plan, fragment.id) != planner.scene.ShownVolume())
      continue;
    if (const auto away = AwayFrom(planner, fragment, inScan); away && *away <= nearest)
      nearest = *away, found = fragment.id;
  }
  return found;
}

TouchedPlace TouchScan(Planner& planner, glm::dvec3 inScan, bool onBone)
{
  glm::dvec3 normal(0.0);
  if (vtkImageData* image = planner.scene.ShownImage())
  {
    const AnyGridView scan = ViewImage(image);
    if (const auto touched = TouchBone(scan, planner.scene.Isovalue(), inScan, SnapMm);
        touched && onBone)
      inScan = touched->place, normal = touched->normal;
    else
      normal = BoneNormal(scan, inScan).value_or(glm::dvec3(0.0));
  }
  TouchedPlace place = PlaceOfScan(planner.plan.Now(), FragmentAt(planner, inScan), inScan);
  const PlanFragment* fragment = FragmentOf(planner.plan.Now(), place.object);
  place.normal = fragment ? fragment->scanToPlanned.orientation * normal : normal;
  return place;
}
} // namespace

TouchedPlace PlaceOfScan(const Plan& plan, PlanId object, const glm::dvec3& inScan)
{
  const PlanFragment* fragment = FragmentOf(plan, object);
  return { object, fragment ? fragment->scanToPlanned.Place(inScan) : inScan, inScan };
}

TouchedPlace PlaceOfPlan(const Plan& plan, PlanId object, const glm::dvec3& world)
{
  const PlanFragment* fragment = FragmentOf(plan, object);
  return { object, world, fragment ? fragment->scanToPlanned.PlaceBack(world) : world };
}

glm::dvec3 NormalInScan(const Plan& plan, const TouchedPlace& place)
{
  const PlanFragment* fragment = FragmentOf(plan, place.object);
  return fragment ? glm::conjugate(fragment->scanToPlanned.orientation) * place.normal
                  : place.normal;
}

std::optional<TouchedPlace> TouchAt(
  Planner& planner, FrameView& view, const QPointF& pixel, bool onBone)
{
  if (const auto slice = SliceOf(planner.views, view))
  {
    if (!planner.views.Image())
      return std::nullopt;
    return TouchScan(planner, planner.views.Slice(*slice).PlaceAt(pixel.toPoint()), onBone);
  }
  const double toWindow = view.effectiveDevicePixelRatio();
  const auto place = planner.scene.PlaceAt(
    int(std::floor(pixel.x() * toWindow)), int(std::floor((view.height() - pixel.y()) * toWindow)));
  if (!place)
    return std::nullopt;
  return TouchedPlace{ place->object, place->world, place->inScan, place->normal };
}

std::optional<TouchedPlace> TouchCrosshair(Planner& planner, bool onBone)
{
  if (!planner.views.Image())
    return std::nullopt;
  return TouchScan(planner, planner.views.Crosshair(), onBone);
}

glm::dvec3 ScanNormal(Planner& planner, PlanId volume, const TouchedPlace& place)
{
  const ShelfScan* scan = planner.scans.OfVolume(planner.plan.Now(), volume);
  const auto normal =
    scan ? BoneNormal(ViewImage(scan->image), place.inScan) : std::optional<glm::dvec3>();
  return normal.value_or(NormalInScan(planner.plan.Now(), place));
}

glm::dvec3 ViewDirection(Planner& planner)
{
  double way[3];
  planner.views.Scene().Renderer()->GetActiveCamera()->GetDirectionOfProjection(way);
  return glm::normalize(glm::dvec3(way[0], way[1], way[2]));
}

glm::dvec3 ViewRight(Planner& planner)
{
  double up[3];
  planner.views.Scene().Renderer()->GetActiveCamera()->GetViewUp(up);
  return glm::normalize(glm::cross(ViewDirection(planner), glm::dvec3(up[0], up[1], up[2])));
}

PointerRay RayOf(Planner& planner, FrameView& view, const QPointF& pixel)
{
  if (const auto slice = SliceOf(planner.views, view))
    return { planner.views.Slice(*slice).PlaceAt(pixel.toPoint()), -FrameOf(*slice).towardsViewer };
  vtkCamera* camera = view.Renderer()->GetActiveCamera();
  double eye[3], focus[3], up[3];
  camera->GetPosition(eye);
  camera->GetFocalPoint(focus);
  camera->GetViewUp(up);
  const glm::dvec3 from(eye[0], eye[1], eye[2]), to(focus[0], focus[1], focus[2]);
  const glm::dvec3 into = glm::normalize(to - from);
  const glm::dvec3 right = glm::normalize(glm::cross(into, glm::dvec3(up[0], up[1], up[2])));
  const double mm = view.MmPerPixel();
  const glm::dvec3 across = mm * (pixel.x() - 0.5 * view.width()) * right +
                            mm * (0.5 * view.height() - pixel.y()) * glm::cross(right, into);
  if (camera->GetParallelProjection())
    return { from + across, into };
  return { from, glm::normalize(to + across - from) };
}

} // namespace hasp
