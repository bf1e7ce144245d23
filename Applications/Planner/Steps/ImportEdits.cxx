#include "Steps/ImportEdits.h"

#include "Model/ObjectNames.h"

#include <algorithm>
#include <filesystem>

namespace hasp
{

bool HoldsPlan(const std::string& path)
{
  std::error_code ignored; // then it is none
  return std::filesystem::is_regular_file(std::filesystem::path(path) / "plan.json", ignored);
}

PlanId VolumeOfHash(const Plan& plan, const std::string& hash)
{
  const auto found = std::find_if(plan.volumes.begin(), plan.volumes.end(),
    [&](const PlanVolume& volume) { return volume.hash == hash; });
  return found == plan.volumes.end() ? 0 : found->id;
}

PlanId SegmentationOfBlob(const Plan& plan, const std::string& blob)
{
  const auto found = std::find_if(plan.segmentations.begin(), plan.segmentations.end(),
    [&](const PlanSegmentation& one) { return one.labels == blob && one.recipe.steps.empty(); });
  return found == plan.segmentations.end() ? 0 : found->id;
}

std::vector<PlanEdit> FragmentEdits(PlanId firstId, const LabelMapFragments& map)
{
  PlanId id = firstId;
  const PlanId segmentation = id++;
  std::vector<PlanEdit> edits{ AddObject<PlanSegmentation>{
    { segmentation, "labels", map.volume, map.blob } } };
  for (const LabelEntry& entry : map.labels)
  {
    PlanFragment fragment;
    fragment.id = id++;
    fragment.name = ObjectNames::OfFragment(fragment.id, entry.value, entry.name);
    fragment.colour = entry.colour;
    fragment.source = LabelSource{ segmentation, entry.value, map.isovalue, map.spacingMm };
    edits.push_back(AddObject<PlanFragment>{ std::move(fragment) });
  }
  return edits;
}

std::vector<PlanEdit> SurfaceEdits(
  const Plan& plan, PlanId firstId, const std::string& hash, double thicknessMm)
{
  const auto known = std::find_if(plan.surfaces.begin(), plan.surfaces.end(),
    [&](const PlanSurface& surface) { return surface.hash == hash; });
  PlanId id = firstId;
  const PlanId surface = known == plan.surfaces.end() ? id++ : known->id;
  std::vector<PlanEdit> edits;
  if (known == plan.surfaces.end())
    edits.push_back(
      AddObject<PlanSurface>{ { surface, ObjectNames::Of<PlanSurface>(surface), hash } });
  PlanFragment fragment;
  fragment.id = id;
  fragment.name = ObjectNames::Of<PlanFragment>(id);
  fragment.source = SurfaceSource{ surface, thicknessMm };
  edits.push_back(AddObject<PlanFragment>{ std::move(fragment) });
  return edits;
}

} // namespace hasp
