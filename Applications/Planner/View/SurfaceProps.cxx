#include "View/SurfaceProps.h"

#include "Model/PlanSession.h"
#include "Planning/PlanLists.h"
#include "View/BlobFile.h"
#include "View/FragmentLook.h"

namespace hasp
{
namespace
{

/// The surface's hash; empty: it is no surface's.
std::string HashOf(const Plan& plan, PlanId fragment)
{
  const auto* found = FindPlanObject<PlanFragment>(plan, fragment);
  const auto* source = found ? std::get_if<SurfaceSource>(&found->source) : nullptr;
  const auto* surface = source ? FindPlanObject<PlanSurface>(plan, source->surface) : nullptr;
  return surface ? surface->hash : std::string();
}

} // namespace

void SurfaceProps::Put(const std::string& hash, vtkPolyData* mesh)
{
  if (mesh)
    this->Meshes[hash] = WithNormals(mesh, true);
  else
    this->Meshes.erase(hash);
}

bool SurfaceProps::Sync()
{
  const Plan& plan = this->Of.plan.Now();
  bool changed = std::erase_if(this->Entries,
                   [&](const auto& entry)
                   {
                     const std::string hash = HashOf(plan, entry.first);
                     return hash != entry.second.hash || !this->Meshes.contains(hash);
                   }) > 0;
  for (const PlanFragment& fragment : plan.fragments)
  {
    const std::string hash = HashOf(plan, fragment.id);
    const auto mesh = this->Meshes.find(hash);
    const bool visible = this->Of.isVisible(fragment.id);
    const auto found = this->Entries.find(fragment.id);
    if (mesh == this->Meshes.end() || (found == this->Entries.end() && !visible))
      continue;
    SurfaceEntry& entry = this->Entries[fragment.id];
    if (!entry.shown)
    {
      entry = { hash, std::make_unique<MeshProp>(this->Of.view, mesh->second) };
      changed = true;
    }
    entry.shown->SetPose(fragment.scanToPlanned);
    entry.shown->SetLook(LookOf(fragment, this->Of.selected == fragment.id));
    entry.shown->SetVisible(visible);
  }
  return changed;
}

void SurfaceProps::ListResources(ResourceList& list) const
{
  const Plan& plan = this->Of.plan.Now();
  for (const PlanFragment& fragment : plan.fragments)
    if (const auto entry = this->Entries.find(fragment.id); entry != this->Entries.end())
      entry->second.shown->ListResourcesAs(CalledObject(plan, fragment.id), list);
    else if (std::holds_alternative<SurfaceSource>(fragment.source))
      list.push_back({ CalledObject(plan, fragment.id), 0, 0.0,
        this->Of.isVisible(fragment.id) ? "its surface is not in memory" : "hidden" });
}

} // namespace hasp
