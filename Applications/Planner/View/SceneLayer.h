#pragma once
#include "Grid/ResourceUse.h"
#include "Planning/Plan.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <QString>

#include <glm/vec3.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>

class vtkBoundingBox;
class vtkProp3D;

namespace hasp
{

class JobQueue;
class PlanSession;
class ScanShelf;
class SceneView;

/// What all layers of a scene share.
struct SceneContext
{
  PlanSession& plan;
  ScanShelf& scans;
  JobQueue& jobs;
  SceneView& view;
  std::function<bool(PlanId)> isVisible; ///< as the user has it; of a volume: its isosurface
  std::function<vtkProp3D*(PlanId)> propOf;
  std::function<void()> propsChanged; ///< a job has made something: others than before
  std::function<void(const QString&)> fault;
  PlanId selected = 0;
  bool brightest = false; ///< values are shown instead of the scan's isosurface
  /// Of segmentations, by their blobs: what fragments are made of. Those that the plan has.
  std::map<std::string, vtkSmartPointer<vtkImageData>> labelMaps{};
};

/// A line of sight, world, mm.
struct SceneRay
{
  glm::dvec3 from, to;
};

/// Where it first meets something.
struct SceneHit
{
  PlanId object = 0;
  double t = 0.0; ///< from + t (to - from)
  glm::dvec3 world{ 0.0 };
  glm::dvec3 inScan{ 0.0 }; ///< before the reduction
  glm::dvec3 normal{ 0.0 }; ///< unit, towards the viewer
};

/// One kind of what a scene shows. It makes what is shown and not there, releases what is gone, and
/// leaves alone what is as it was. Threads: RENDER.
class SceneLayer
{
public:
  explicit SceneLayer(SceneContext& of) : Of(of) {}
  virtual ~SceneLayer() = default;
  SceneLayer(const SceneLayer&) = delete;
  SceneLayer& operator=(const SceneLayer&) = delete;

  /// The plan, what was made of it, what is visible or selected is another. True: its props are
  /// others than before.
  virtual bool Sync() = 0;
  virtual vtkProp3D* PropOf(PlanId) const { return nullptr; }
  /// Takes a hit that is nearer than the one that there is.
  virtual void Pick(const SceneRay&, std::optional<SceneHit>&) const {}
  /// Around all that is shown.
  virtual void AddBounds(vtkBoundingBox& box) const = 0;
  virtual void Prepare() {}                         ///< before each frame
  virtual bool IsRefining() const { return false; } ///< another frame would show more
  virtual void ListResources(ResourceList&) const = 0;

protected:
  SceneContext& Of;
};

} // namespace hasp
