#pragma once
#include "Grid/Progress.h"
#include "Grid/RigidPose.h"
#include "Planning/Plan.h"

#include "vtkDataObject.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

class vtkProp3D;

namespace hasp
{

struct BodyDistance;

/// What a prop shows: an image's isosurface, or closed triangles.
struct ShownBody
{
  vtkSmartPointer<vtkDataObject> data; ///< the prop's own
  double isovalue = 0.0;               ///< of an image

  bool operator==(const ShownBody&) const = default;
  /// nullopt: it is neither, or there is no prop. RENDER.
  static std::optional<ShownBody> Of(vtkProp3D* prop);
};

/// What is to be made of a fragment's body.
struct DistanceWork
{
  PlanId fragment = 0;
  ShownBody shown; ///< to know it again; not read by the WORKER
  ShownBody copy;  ///< with samples shared and all else its own
  bool mesh = false, distance = false;
};

/// Null: it was not asked for. Empty: it cannot be made of this body.
struct MadeDistance
{
  PlanId fragment = 0;
  ShownBody shown;
  vtkSmartPointer<vtkPolyData> mesh; ///< its surface, in the scan's world; points of floats
  /// The signed distance to it, of 2 million samples at most, 6 mm around.
  std::shared_ptr<const BodyDistance> distance;
};

/// RENDER.
DistanceWork MakeWork(PlanId fragment, const ShownBody& shown, bool mesh, bool distance);
/// WORKER. Throws Cancelled.
std::vector<MadeDistance> DoWork(
  const std::vector<DistanceWork>& works, const ProgressFunction& progress);

struct PlacedDistance
{
  const BodyDistance* distance = nullptr;
  RigidPose pose; ///< of the scan's world to where the body stands
};

constexpr double FarMm = 1000.0; ///< said of a surface that is more than 6 mm from all of a body

/// Of each point of a mesh that stands in `pose`, the least of the signed distances to the others,
/// mm, NEGATIVE INSIDE; NaN where there are none. As many as it has points. Any thread; 4 ms for
/// 200,000 points before each of the others that is near.
void FindLeastDistances(vtkPolyData* mesh, const RigidPose& pose,
  std::span<const PlacedDistance> others, std::span<float> least);

} // namespace hasp
