#pragma once
#include "View/MeasureActor.h"
#include "View/SceneEntries.h"

#include <memory>

namespace hasp
{

struct MeasureEntry
{
  std::unique_ptr<MeasureActor> shown;
};

/// Distances and angles with their values, between places after the reduction. They follow
/// fragments that a hand moves, too, before that is a step of the plan. Threads: RENDER.
class MeasureProps : public SceneEntries<MeasureEntry>
{
public:
  using SceneEntries::SceneEntries;

  bool Sync() override;
  void Pick(const SceneRay&, std::optional<SceneHit>&) const override {}
  void Prepare() override;
  void ListResources(ResourceList& list) const override;

private:
  std::vector<glm::dvec3> PlacesOf(const PlanMeasure& measure) const;
  void Follow(const PlanMeasure& measure, MeasureActor& shown);
};

} // namespace hasp
