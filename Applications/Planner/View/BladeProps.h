#pragma once
#include "View/MeshProp.h"
#include "View/SceneEntries.h"

#include <memory>

namespace hasp
{

struct BladeEntry
{
  Osteotomy blade;
  std::unique_ptr<MeshProp> shown; ///< the box
  std::unique_ptr<MeshProp> edges; ///< of it
};

/// Cuts as the box of bone that their saws turn to dust, where the scan is. They are seen through,
/// by picks too. Threads: RENDER. Cost: 12 triangles a cut.
class BladeProps : public SceneEntries<BladeEntry>
{
public:
  using SceneEntries::SceneEntries;

  bool Sync() override;
  void Pick(const SceneRay&, std::optional<SceneHit>&) const override {}
  void Prepare() override; ///< edges go with their box: a hand moves it, and tools cover it
  void ListResources(ResourceList& list) const override;
};

} // namespace hasp
