#include "PlanReduction.h"

#include "Grid/ProgressPart.h"
#include "Grid/Stopwatch.h"
#include "PlanBones.h"
#include "Planning/PlanLists.h"
#include "Planning/PlanUnits.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{

namespace
{
constexpr const char* Who = "reduction: ";

RigidPose RigidOf(const PlanPose& pose)
{
  return { pose.position, pose.orientation };
}

std::string Called(PlanId fragment)
{
  return "fragment " + std::to_string(fragment);
}

/// The fragment of the whole bone that this one is a piece of.
const PlanFragment& RootOf(const Plan& plan, const PlanFragment& fragment)
{
  const PlanFragment* root = &fragment;
  while (const auto* piece = std::get_if<PieceSource>(&root->source))
    root = FindPlanObject<PlanFragment>(plan, piece->fragment);
  return *root;
}

/// 0: of none, a surface.
PlanId VolumeOf(const Plan& plan, const PlanFragment& fragment)
{
  const PlanFragment& root = RootOf(plan, fragment);
  if (std::holds_alternative<SurfaceSource>(root.source))
    return 0;
  if (const auto* component = std::get_if<ComponentSource>(&root.source))
    return component->volume;
  const auto& label = std::get<LabelSource>(root.source);
  return FindPlanObject<PlanSegmentation>(plan, label.segmentation)->volume;
}

bool IsDonor(const Plan& plan, PlanId fragment)
{
  return std::any_of(plan.transplants.begin(), plan.transplants.end(),
    [&](const PlanTransplant& t) { return t.donor == fragment; });
}

bool IsObstacle(PlanId fragment, const PlanReductionSettings& settings)
{
  return std::find(settings.obstacles.begin(), settings.obstacles.end(), fragment) !=
         settings.obstacles.end();
}

bool StaysPut(const PlanFragment& fragment, const PlanReductionSettings& settings)
{
  return fragment.locked || fragment.id == settings.reference || IsObstacle(fragment.id, settings);
}

void RequireFragment(const Plan& plan, PlanId id)
{
  const auto* fragment = FindPlanObject<PlanFragment>(plan, id);
  if (fragment == nullptr)
    throw std::invalid_argument(Who + CalledObject(plan, id) + " is not a fragment of the plan");
  if (fragment->state == FragmentState::Resected)
    throw std::invalid_argument(Who + Called(id) + " is resected: it is not put together");
  if (IsDivided(plan, id))
    throw std::invalid_argument(Who + Called(id) + " is cut in pieces: name them instead");
}

/// All that take part, fixed ones first.
std::vector<PlanId> FragmentsOf(const Plan& plan, const PlanReductionSettings& settings)
{
  for (const PlanId id : settings.fragments)
    RequireFragment(plan, id);
  for (const PlanId id : settings.obstacles)
    RequireFragment(plan, id);
  if (settings.reference != 0)
    RequireFragment(plan, settings.reference);
  std::vector<PlanId> fixed, moved;
  const auto asked = [&](PlanId id)
  {
    return settings.fragments.empty() || id == settings.reference ||
           std::find(settings.fragments.begin(), settings.fragments.end(), id) !=
             settings.fragments.end();
  };
  for (const PlanFragment& f : plan.fragments)
    if (f.state == FragmentState::Kept && !IsDivided(plan, f.id))
    {
      // Locked ones stand in the way whether they are named or not.
      if (StaysPut(f, settings))
        fixed.push_back(f.id);
      else if (asked(f.id) && (!settings.fragments.empty() || !IsDonor(plan, f.id)))
        moved.push_back(f.id);
    }
  if (std::all_of(fixed.begin(), fixed.end(), [&](PlanId id) { return IsObstacle(id, settings); }))
    throw std::invalid_argument(std::string(Who) + "nothing stays where it is: lock the reference, "
                                                   "such as the cranium, or name it");
  // Of a scan the reference's, or the first's where that is a surface.
  PlanId scan = 0;
  for (const auto* list : { &fixed, &moved })
    for (const PlanId id : *list)
      if (scan == 0)
        scan = VolumeOf(plan, *FindPlanObject<PlanFragment>(plan, id));
  const auto elsewhere = [&](PlanId id)
  {
    const PlanId own = VolumeOf(plan, *FindPlanObject<PlanFragment>(plan, id));
    return own == 0 ? !settings.surfaces.contains(id) : own != scan;
  };
  if (!settings.fragments.empty())
    for (const PlanId id : moved)
      if (elsewhere(id))
        throw std::invalid_argument(
          Who + Called(id) +
          " is of another scan than the reference, or a surface that was not read");
  std::erase_if(moved, elsewhere);
  std::erase_if(fixed, elsewhere);
  if (moved.empty())
    throw std::invalid_argument(std::string(Who) + "there is nothing to move");
  fixed.insert(fixed.end(), moved.begin(), moved.end());
  return fixed;
}

/// Of each unit all others but obstacles.
void AddPartners(const PlanReduction& reduction, const PlanReductionSettings& settings,
  std::vector<AssemblyUnit>& assembly)
{
  const auto isObstacle = [&](std::size_t unit)
  {
    const std::vector<PlanId>& ids = reduction.units[unit].fragments;
    return std::any_of(ids.begin(), ids.end(), [&](PlanId id) { return IsObstacle(id, settings); });
  };
  std::vector<std::size_t> partners;
  for (std::size_t n = 0; n < assembly.size(); ++n)
    if (!isObstacle(n))
      partners.push_back(n);
  if (partners.size() == assembly.size())
    return;
  for (std::size_t n = 0; n < assembly.size(); ++n)
    for (const std::size_t partner : partners)
      if (partner != n)
        assembly[n].partners.push_back(partner);
}

std::vector<AssemblyUnit> AssemblyOf(
  const Plan& plan, const PlanReduction& reduction, const PlanReductionSettings& settings)
{
  std::vector<AssemblyUnit> assembly;
  for (const ReducedUnit& unit : reduction.units)
  {
    AssemblyUnit made;
    for (const PlanId id : unit.fragments)
    {
      const auto& fragment = *FindPlanObject<PlanFragment>(plan, id);
      const auto at = std::find(reduction.fragments.begin(), reduction.fragments.end(), id);
      const BakedFitBody& baked = reduction.bodies[at - reduction.fragments.begin()];
      made.bodies.push_back(
        { baked.body, RigidOf(fragment.scanToPlanned) * RigidPose{ baked.origin } });
      made.fixed = made.fixed || StaysPut(fragment, settings);
    }
    // Torques and turns are about the unit's own place, not about the scan's far origin.
    const RigidPose place{ made.bodies[0].bodyInGroup.position };
    for (GroupBody& body : made.bodies)
      body.bodyInGroup = place.Inverse() * body.bodyInGroup;
    made.groupInWorld = place;
    assembly.push_back(std::move(made));
  }
  AddPartners(reduction, settings, assembly);
  return assembly;
}

void Bake(const Plan& plan, const PlanImages& images, const PlanReductionSettings& settings,
  PlanReduction& made, const ProgressFunction& progress)
{
  std::vector<PlanId> scanned; // label n + 1 of the scan
  for (const PlanId id : made.fragments)
    if (!settings.surfaces.contains(id))
      scanned.push_back(id);
  std::vector<BakedFitBody> baked;
  if (!scanned.empty())
  {
    PlanBones bones(plan, images);
    const BoneLabels labels = bones.Labels(scanned, PartOf(progress, 0.0, 0.2));
    const GridGeometry& scan = GeometryOf(labels.grey);
    const BoneShares shares =
      ShareBone(labels.grey, GridView<const std::uint16_t>{ labels.numbers.data(), scan },
        settings.share, PartOf(progress, 0.2, 0.4));
    made.softValue = shares.softValue;
    for (std::size_t n = 0; n < scanned.size(); ++n)
    {
      const auto at = [&](std::size_t done)
      { return 0.4 + 0.6 * double(done) / double(scanned.size()); };
      baked.push_back(SayingErrors(
        [&]
        {
          return BakeFitBody(
            scan, shares, std::uint16_t(n + 1), settings.bake, PartOf(progress, at(n), at(n + 1)));
        },
        [&](const std::string& error) { return Called(scanned[n]) + ": " + error; }));
    }
  }
  std::size_t next = 0;
  for (const PlanId id : made.fragments)
    if (const auto surface = settings.surfaces.find(id); surface != settings.surfaces.end())
      made.bodies.push_back(surface->second);
    else
      made.bodies.push_back(baked[next++]);
}
} // namespace

PlanReduction ReducePlan(const Plan& plan, const PlanImages& images,
  const PlanReductionSettings& settings, const ProgressFunction& progress)
{
  PlanReduction made;
  made.fragments = FragmentsOf(plan, settings);
  for (PlanUnit& unit : UnitsOf(plan, made.fragments))
    made.units.push_back({ unit.group, std::move(unit.fragments), {} });
  Stopwatch time;
  Bake(plan, images, settings, made, PartOf(progress, 0.0, 0.6));
  made.bakedMs = time.Milliseconds();
  const std::vector<AssemblyUnit> assembly = AssemblyOf(plan, made, settings);
  Stopwatch fits;
  std::vector<AssembledUnit> assembled =
    Assemble(assembly, settings.assembly, settings.seed, PartOf(progress, 0.6, 1.0));
  made.assembledMs = fits.Milliseconds();
  for (std::size_t n = 0; n < made.units.size(); ++n)
  {
    // From the unit's own place back to a motion of the world.
    const RigidPose back = assembly[n].groupInWorld.Inverse();
    made.units[n].assembled = std::move(assembled[n]);
    AssembledUnit& unit = made.units[n].assembled;
    unit.groupInWorld = unit.groupInWorld * back;
    unit.fit.groupInWorld = unit.fit.groupInWorld * back;
    for (FitProposal& proposal : unit.proposals.proposals)
      proposal.fit.groupInWorld = proposal.fit.groupInWorld * back;
  }
  return made;
}

PoseFragments ReductionEdit(
  const Plan& plan, const PlanReduction& reduction, const std::vector<std::size_t>& proposals)
{
  PoseFragments edit;
  for (std::size_t n = 0; n < reduction.units.size(); ++n)
  {
    const ReducedUnit& unit = reduction.units[n];
    if (unit.assembled.turn == 0)
      continue;
    RigidPose motion = unit.assembled.groupInWorld;
    if (n < proposals.size() && proposals[n] > 0)
    {
      const auto& all = unit.assembled.proposals.proposals;
      if (proposals[n] >= all.size())
        throw std::invalid_argument("reduction: unit " + std::to_string(n) + " has " +
                                    std::to_string(all.size()) + " proposals, number " +
                                    std::to_string(proposals[n] + 1) + " is asked for");
      motion = all[proposals[n]].fit.groupInWorld;
    }
    for (const PlanId id : unit.fragments)
    {
      const RigidPose now = RigidOf(FindPlanObject<PlanFragment>(plan, id)->scanToPlanned);
      const RigidPose then = motion * now;
      edit.poses.push_back({ id, { then.position, glm::normalize(then.orientation) } });
    }
  }
  return edit;
}

} // namespace hasp
