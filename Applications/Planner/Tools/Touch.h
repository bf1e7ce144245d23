#pragma once
#include "Planning/BladeHandles.h"
#include "Planning/Plan.h"

#include <QPointF>

#include <glm/vec3.hpp>

#include <optional>

namespace hasp
{

class FrameView;
struct Planner;

/// A place that was touched, as the plan may ask for it.
struct TouchedPlace
{
  PlanId object = 0;        ///< the fragment that it goes with; 0: the scan itself
  glm::dvec3 world{ 0.0 };  ///< where it is seen, mm: after the reduction
  glm::dvec3 inScan{ 0.0 }; ///< before it
  glm::dvec3 normal{ 0.0 }; ///< unit, out of the bone, world; 0: not known
};

///@{
/// A place that is known in the scan, or as planned. Any thread.
TouchedPlace PlaceOfScan(const Plan& plan, PlanId object, const glm::dvec3& inScan);
TouchedPlace PlaceOfPlan(const Plan& plan, PlanId object, const glm::dvec3& world);
///@}
/// Its normal before the reduction; 0: not known. Any thread.
glm::dvec3 NormalInScan(const Plan& plan, const TouchedPlace& place);

///@{
/// RENDER. What is under a pixel of a view of the grid (of the widget, from its upper left): in 3D
/// the bone that is seen there, in a slice the place in its plane; nothing where nothing is. In a
/// slice, and at the crosshair, `onBone` takes the bone's surface where it is within 2.5 mm.
std::optional<TouchedPlace> TouchAt(
  Planner& planner, FrameView& view, const QPointF& pixel, bool onBone = true);
std::optional<TouchedPlace> TouchCrosshair(Planner& planner, bool onBone = true);
/// The normal there, in the scan, by its grey values: the same each time the plan is opened. Where
/// these say none, the touched one.
glm::dvec3 ScanNormal(Planner& planner, PlanId volume, const TouchedPlace& place);
///@}

///@{
/// RENDER. How the 3D view looks: into the picture, and to its right. Unit.
glm::dvec3 ViewDirection(Planner& planner);
glm::dvec3 ViewRight(Planner& planner);
/// What a pixel of a view looks along.
PointerRay RayOf(Planner& planner, FrameView& view, const QPointF& pixel);
///@}

} // namespace hasp
