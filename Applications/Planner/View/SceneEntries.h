#pragma once
#include "View/SceneActor.h"

#include "vtkActor.h"

#include <map>

namespace hasp
{

/// A layer with an actor an object: Entry has `shown`, a pointer to a SceneActor that may be null.
template <typename Entry>
class SceneEntries : public SceneLayer
{
public:
  using SceneLayer::SceneLayer;

  vtkProp3D* PropOf(PlanId object) const override
  {
    const auto found = this->Entries.find(object);
    const bool seen =
      found != this->Entries.end() && found->second.shown && found->second.shown->IsVisible();
    return seen ? found->second.shown->Actor() : nullptr;
  }
  void Pick(const SceneRay& ray, std::optional<SceneHit>& nearest) const override
  {
    for (const auto& [id, entry] : this->Entries)
      if (entry.shown)
        entry.shown->Pick(id, ray, nearest);
  }
  void AddBounds(vtkBoundingBox& box) const override
  {
    for (const auto& [id, entry] : this->Entries)
      if (entry.shown)
        entry.shown->AddBounds(box);
  }

protected:
  std::map<PlanId, Entry> Entries;
};

} // namespace hasp
