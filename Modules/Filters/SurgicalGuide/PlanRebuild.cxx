#include "PlanRebuild.h"

#include "FragmentPieces.h"
#include "GuideBuilder.h"
#include "GuideClaims.h"
#include "ImplantBuilder.h"
#include "ImplantClaims.h"
#include "MitreGuide.h"
#include "PlanBones.h"
#include "PlateBuilder.h"
#include "PlateClaims.h"
#include "ReductionModel.h"
#include "TransplantSegments.h"

#include "Planning/PlanLists.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>

namespace hasp
{

namespace
{
void Append(TriangleMesh& mesh, const TriangleMesh& other, const PlanPose& pose)
{
  const auto first = std::uint32_t(mesh.points.size());
  for (const glm::dvec3& p : other.points)
    mesh.points.push_back(pose.Place(p));
  for (const glm::uvec3& t : other.triangles)
    mesh.triangles.push_back(t + first);
}

std::vector<ScrewAxis> AxesOf(const std::vector<PlacedScrew>& screws)
{
  std::vector<ScrewAxis> axes;
  for (const PlacedScrew& screw : screws)
    axes.push_back({ screw.outer, screw.axis });
  return axes;
}

/// Of all joints but those where the plan names no jaw.
std::vector<std::string> WarningsOf(
  const PlanTransplant& object, const std::vector<MadeJoint>& joints)
{
  std::vector<std::string> warnings = JointWarnings(joints, object.mostGapMm, object.mostOverlapMm);
  const auto drop = [&](const JawFace& face, std::size_t joint)
  {
    if (face.fragment == 0)
      std::erase_if(warnings, [&](const std::string& text)
        { return text.starts_with("joints[" + std::to_string(joint) + "]"); });
  };
  drop(object.first, 0);
  drop(object.last, joints.size() - 1);
  return warnings;
}

/// A copy of a scan with one bone alone: what is bone and not this one is as the emptiest sample.
class OneBoneScan
{
public:
  OneBoneScan(const BoneLabels& labels, double isovalue)
  {
    std::visit(
      [&]<typename T>(const GridView<const T>& grey)
      {
        std::vector<T> copy(grey.data, grey.data + grey.geometry.Size());
        const T least = *std::min_element(copy.begin(), copy.end());
        for (std::size_t n = 0; n < copy.size(); ++n)
          if (labels.numbers[n] != 1 && double(copy[n]) >= isovalue)
            copy[n] = least;
        this->Samples = std::move(copy);
        this->Seen =
          GridView<const T>{ std::get<std::vector<T>>(this->Samples).data(), grey.geometry };
      },
      labels.grey);
  }
  OneBoneScan(const OneBoneScan&) = delete;
  OneBoneScan& operator=(const OneBoneScan&) = delete;
  const AnyGridView& View() const { return this->Seen; }

private:
  std::variant<std::vector<std::int16_t>, std::vector<std::uint16_t>, std::vector<std::uint8_t>,
    std::vector<float>>
    Samples;
  AnyGridView Seen;
};
} // namespace

/// Makes a part of each kind of object; an overload for each, so that a new one is not forgotten.
struct PlanRebuild::Internals
{
  Internals(Plan of, PlanImages given)
    : plan(std::move(of)),
      images(std::move(given)),
      bones(this->plan, this->images)
  {
  }

  RebuiltPart MakeOf(const PlanFragment& fragment, const ProgressFunction& progress)
  {
    RebuiltPart part;
    part.mesh = this->bones.Mesh(fragment.id, progress);
    part.cuts = this->bones.Cuts(fragment.id);
    return part;
  }

  RebuiltPart MakeOf(const PlanGroup& group, const ProgressFunction& progress)
  {
    std::vector<PosedMesh> kept;
    double spacing = 5.0; // UniteFragments' most
    for (const PlanId id : group.fragments)
    {
      const PlanFragment& fragment = *FindPlanObject<PlanFragment>(this->plan, id);
      if (fragment.state != FragmentState::Kept)
        continue;
      const PlanPose& pose = fragment.scanToPlanned;
      kept.push_back({ &this->bones.Mesh(id, progress), { pose.position, pose.orientation } });
      spacing = std::min(spacing, this->bones.SpacingMm(id));
    }
    if (kept.empty())
      throw std::runtime_error("none of its fragments is kept");
    RebuiltPart part;
    part.mesh = UniteFragments(kept, spacing, progress);
    return part;
  }

  RebuiltPart MakeOf(const PlanGuide& guide, const ProgressFunction& progress)
  {
    const PlanId alone = FindPlanObject<PlanVolume>(this->plan, guide.bone) ? 0 : guide.bone;
    const AnyGridView bone = alone == 0 ? this->bones.Grey(guide.bone)
                                        : this->Alone(alone, guide.recipe.isovalue, progress);
    BuiltGuide built =
      BuildGuide(bone, this->Labelled(guide), BladesOf(this->plan, guide), progress);
    RebuiltPart part;
    part.mesh = std::move(built.mesh);
    part.check = { ClaimsOf(built.made.recipe), bone, built.made.recipe, alone };
    return part;
  }

  RebuiltPart MakeOf(const PlanPlate& plate, const ProgressFunction& progress)
  {
    const PlateRecipe recipe = PlateRecipeOf(this->plan, plate);
    RebuiltPart part;
    BoneScan scan{ GridView<const std::uint8_t>{} };
    BoneLabels labels;
    if (plate.volume != 0)
      scan.grey = this->bones.Grey(plate.volume);
    else
    {
      if (recipe.fragments.empty())
        throw std::runtime_error("none of its fragments is kept");
      labels = this->bones.Labels(plate.fragments, progress);
      scan = { labels.grey, labels.View() };
    }
    BuiltPlate built = BuildPlate(scan, recipe, progress);
    part.mesh = std::move(built.mesh);
    part.check = { ClaimsOf(recipe, AxesOf(built.made.screws)), scan.grey };
    if (plate.volume != 0)
      part.check->recipe = recipe;
    return part;
  }

  RebuiltPart MakeOf(const PlanImplant& implant, const ProgressFunction& progress)
  {
    const AnyGridView scan = this->bones.Grey(implant.volume);
    BuiltImplant built = BuildImplant(scan, implant.recipe, progress);
    RebuiltPart part;
    part.mesh = std::move(built.mesh);
    part.check = { ClaimsOf(implant.recipe, built.made.axis, built.made.holes), scan,
      implant.recipe };
    return part;
  }

  RebuiltPart MakeOf(const PlanTransplant& object, const ProgressFunction& progress)
  {
    const Transplant transplant = TransplantOf(this->plan, object);
    const PlanId one[] = { object.donor };
    const BoneLabels donor = this->bones.Labels(one, progress);
    TransplantSegments segments({ donor.grey, donor.View(), 1 }, transplant.donor,
      { this->bones.Isovalue(object.donor), this->bones.SpacingMm(object.donor) }, progress);
    RebuiltPart part;
    const std::vector<PlacedSegment>& placed = segments.Place(transplant);
    for (const PlacedSegment& segment : placed)
    {
      Append(part.mesh, segment.mesh, {});
      part.segments.push_back({ segment.cut, segment.volumeMm3, segment.mesh.triangles.size() });
    }
    part.joints = JointsBetween(
      transplant, placed, this->Jaw(object.first, progress), this->Jaw(object.last, progress));
    part.warnings = WarningsOf(object, part.joints);
    return part;
  }

  RebuiltPart MakeOf(const PlanMitreGuide& object, const ProgressFunction& progress)
  {
    const auto& transplant = *FindPlanObject<PlanTransplant>(this->plan, object.transplant);
    const double isovalue = this->bones.Isovalue(transplant.donor);
    const AnyGridView donor = this->Alone(transplant.donor, isovalue, progress);
    MitreGuide guide =
      MakeMitreGuideRecipe(TransplantOf(this->plan, transplant), donor, isovalue, object.choices);
    BuiltGuide built = BuildGuide(donor, guide.recipe, {}, progress);
    RebuiltPart part;
    part.mesh = std::move(built.mesh);
    part.check = { ClaimsOf(built.made.recipe), donor, built.made.recipe, transplant.donor };
    part.warnings = std::move(guide.warnings);
    return part;
  }

  /// The fragment's scan without other bone; good until it is asked for the next one.
  AnyGridView Alone(PlanId fragment, double isovalue, const ProgressFunction& progress)
  {
    const PlanId one[] = { fragment };
    this->oneBone = std::make_unique<OneBoneScan>(this->bones.Labels(one, progress), isovalue);
    return this->oneBone->View();
  }

  /// Where the plan puts it; empty if the face names no fragment.
  TriangleMesh Jaw(const JawFace& face, const ProgressFunction& progress)
  {
    TriangleMesh jaw;
    if (const PlanFragment* fragment = FindPlanObject<PlanFragment>(this->plan, face.fragment))
      Append(jaw, this->bones.Mesh(fragment->id, progress), fragment->scanToPlanned);
    return jaw;
  }

  // PartInputs refuses these before.
  RebuiltPart MakeOf(const PlanVolume&, const ProgressFunction&) { return {}; }
  RebuiltPart MakeOf(const PlanSegmentation&, const ProgressFunction&) { return {}; }
  RebuiltPart MakeOf(const PlanSurface&, const ProgressFunction&) { return {}; }
  RebuiltPart MakeOf(const PlanMirror&, const ProgressFunction&) { return {}; }
  RebuiltPart MakeOf(const PlanCut&, const ProgressFunction&) { return {}; }
  RebuiltPart MakeOf(const PlanMeasure&, const ProgressFunction&) { return {}; }

  /// Which case, side and plan it is.
  GuideRecipe Labelled(const PlanGuide& guide) const
  {
    return HasCaseLabel(guide.recipe)
             ? WithCaseLabels(guide.recipe, this->plan.caseLabel, guide.side, PlanHash(this->plan))
             : guide.recipe;
  }

  RebuiltPart MakeObject(PlanId id, const ProgressFunction& progress)
  {
    RebuiltPart part;
    ForEachPlanList(
      [&]<typename T>(const PlanList<T>&)
      {
        if (const T* object = FindPlanObject<T>(this->plan, id))
          part = this->MakeOf(*object, progress);
      });
    return part;
  }

  Plan plan;
  PlanImages images;
  PlanBones bones; ///< of the two above
  std::unique_ptr<OneBoneScan> oneBone;
};

PlanRebuild::PlanRebuild(Plan plan, PlanImages images)
  : Inside(std::make_unique<Internals>(std::move(plan), std::move(images)))
{
}

PlanRebuild::~PlanRebuild() = default;

RebuiltPart PlanRebuild::Make(PlanId object, const ProgressFunction& progress)
{
  std::vector<PartInput> inputs = PartInputs(this->Inside->plan, object);
  const Plan& plan = this->Inside->plan;
  const std::string before = CalledObject(plan, object) + ": ";
  std::string kind = std::string(PlanNoun(plan, object)) + ": "; // as its builder begins
  std::replace(kind.begin(), kind.end(), '-', ' ');
  RebuiltPart part = SayingErrors([&] { return this->Inside->MakeObject(object, progress); },
    [&](const std::string& text)
    {
      if (text.starts_with(before))
        return text;
      return before + (text.starts_with(kind) ? text.substr(kind.size()) : text);
    });
  part.object = object;
  part.inputs = std::move(inputs);
  part.volumeMm3 = VolumeOf(part.mesh);
  ReportProgress(progress, 1.0);
  return part;
}

std::vector<PlanId> ImagesOf(const Plan& plan, PlanId object)
{
  std::vector<PlanId> images;
  for (const PartInput& input : PartInputs(plan, object))
    if (FindPlanObject<PlanVolume>(plan, input.id) ||
        FindPlanObject<PlanSegmentation>(plan, input.id))
      images.push_back(input.id);
  return images;
}

} // namespace hasp
