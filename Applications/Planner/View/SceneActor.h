#pragma once
#include "Planning/PlanPose.h"
#include "View/SceneLayer.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

class vtkActor;
class vtkBoundingBox;
class vtkMapper;

namespace hasp
{

/// How something looks. Components in [0, 1].
struct SceneLook
{
  glm::dvec3 colour{ 1.0 };
  double opacity = 1.0;
  bool selected = false; ///< glows

  bool operator==(const SceneLook&) const = default;
};

/// `share` of `other` in a colour.
glm::dvec3 Mixed(const glm::dvec3& colour, const glm::dvec3& other, double share);

/// An actor in a 3D view while this lives: it is out of the view, and its mapper off the graphics
/// card, when this goes or is hidden. Data lie where the scan has them; the user matrix takes them
/// to where the plan has them.
/// Threads: RENDER. The view outlives this.
class SceneActor
{
public:
  explicit SceneActor(SceneView& view);
  virtual ~SceneActor();
  SceneActor(const SceneActor&) = delete;
  SceneActor& operator=(const SceneActor&) = delete;

  vtkActor* Actor() const { return this->Shown; }
  void SetVisible(bool visible);
  bool IsVisible() const;
  void SetLook(const SceneLook& look);
  /// Of the user matrix. The same as the last one: nothing, so that what a hand has moved since
  /// stays where it is.
  void SetPose(const PlanPose& pose);

  /// Takes a hit that is nearer than the one that there is, as `object`; nothing while hidden.
  /// Places before the reduction are those of the data.
  void Pick(PlanId object, const SceneRay& ray, std::optional<SceneHit>& nearest) const;
  /// Around what is drawn of it, in the world; nothing while hidden.
  void AddBounds(vtkBoundingBox& box) const;
  virtual void ListResources(ResourceList& list) const = 0;
  /// The same, each "guide 8, mesh".
  void ListResourcesAs(const std::string& called, ResourceList& list) const;

protected:
  struct DataHit
  {
    double t = 0.0;
    glm::dvec3 normal{ 0.0 }; ///< of the data, unit
  };
  /// In data coordinates.
  virtual std::optional<DataHit> First(const glm::dvec3& from, const glm::dvec3& to) const = 0;
  /// Of the data that is drawn; false if there is none.
  virtual bool DataBounds(double bounds[6]) const = 0;
  void SetMapper(vtkMapper* mapper); ///< the old one goes off the graphics card
  void MakeCurrent() const;          ///< before something goes off it

  SceneView& In;

private:
  void Release();

  vtkNew<vtkActor> Shown;
  PlanPose Posed;
};

} // namespace hasp
