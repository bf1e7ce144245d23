#include "Output/ScanWorlds.h"

#include "PlanFragmentLabels.h"
#include "Planning/PlanLists.h"

#include <algorithm>
#include <set>

namespace hasp
{
namespace
{

/// Which scan's world an object is in.
class Places
{
public:
  explicit Places(const Plan& plan) : Of(plan)
  {
    for (const PlanTransplant& transplant : plan.transplants)
      this->Donors.insert(VolumeOfFragment(plan, transplant.donor));
    const auto first = std::find_if(plan.volumes.begin(), plan.volumes.end(),
      [this](const PlanVolume& volume) { return !this->Donors.contains(volume.id); });
    if (!plan.volumes.empty())
      this->Main = first == plan.volumes.end() ? plan.volumes.front().id : first->id;
    for (const PlanTransplant& transplant : plan.transplants)
      this->Donors.erase((*this)(transplant)); // one scan of all
  }

  bool IsDonor(PlanId volume) const { return this->Donors.contains(volume); }

  PlanId operator()(const PlanFragment& fragment) const { return this->OfBone(fragment.id); }
  PlanId operator()(const PlanCut& cut) const { return this->OfBones(cut.fragments); }
  PlanId operator()(const PlanGuide& guide) const { return this->OfBone(guide.bone); }
  PlanId operator()(const PlanPlate& plate) const
  {
    return plate.volume != 0 ? plate.volume : this->OfBones(plate.fragments);
  }
  PlanId operator()(const PlanImplant& implant) const { return this->OfBone(implant.volume); }
  PlanId operator()(const PlanTransplant& transplant) const
  {
    for (const JawFace& face : { transplant.first, transplant.last })
    {
      if (face.fragment != 0)
        return this->OfBone(face.fragment);
      if (const auto* cut = FindPlanObject<PlanCut>(this->Of, face.cut))
        return (*this)(*cut);
    }
    return this->Main;
  }
  PlanId operator()(const PlanMitreGuide& guide) const
  {
    const auto* transplant = FindPlanObject<PlanTransplant>(this->Of, guide.transplant);
    return transplant ? this->OfBone(transplant->donor) : this->Main;
  }

private:
  /// A scan or a fragment.
  PlanId OfBone(PlanId bone) const
  {
    if (FindPlanObject<PlanVolume>(this->Of, bone))
      return bone;
    const PlanId volume = VolumeOfFragment(this->Of, bone);
    return volume != 0 ? volume : this->Main;
  }
  PlanId OfBones(const std::vector<PlanId>& bones) const
  {
    return bones.empty() ? this->Main : this->OfBone(bones.front());
  }

  const Plan& Of;
  std::set<PlanId> Donors;
  PlanId Main = 0;
};

} // namespace

std::vector<ScanWorld> WorldsOf(const Plan& plan)
{
  const Places places(plan);
  const auto world = [&](PlanId volume)
  {
    ScanWorld found{ volume, places.IsDonor(volume), plan };
    const auto leave = [&](auto& objects)
    { std::erase_if(objects, [&](const auto& object) { return places(object) != volume; }); };
    leave(found.plan.fragments);
    leave(found.plan.cuts);
    leave(found.plan.guides);
    leave(found.plan.plates);
    leave(found.plan.implants);
    leave(found.plan.transplants);
    leave(found.plan.mitreGuides);
    return found;
  };
  std::vector<ScanWorld> worlds;
  for (const PlanVolume& volume : plan.volumes)
    worlds.push_back(world(volume.id));
  return worlds.empty() ? std::vector{ world(0) } : worlds;
}

std::vector<PlanId> SeenIn(const ScanWorld& world)
{
  const Plan& plan = world.plan;
  std::vector<PlanId> seen;
  const auto add = [&](const auto& objects)
  {
    for (const auto& object : objects)
      if (!IsDivided(plan, object.id))
        seen.push_back(object.id);
  };
  add(plan.fragments);
  add(plan.cuts);
  add(plan.guides);
  add(plan.plates);
  add(plan.implants);
  add(plan.transplants);
  add(plan.mitreGuides);
  return seen;
}

} // namespace hasp
