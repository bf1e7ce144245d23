#include "Planning/PlanObjects.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace hasp
{

namespace
{
template <typename... Ts>
bool IsAny(const Plan& plan, PlanId id)
{
  return ((FindPlanObject<Ts>(plan, id) != nullptr) || ...);
}

bool IsBoneOfScan(const Plan& plan, PlanId id)
{
  return IsAny<PlanVolume>(plan, id) || IsOfScan(plan, id);
}

PlanReference ToVolume(const char* key, PlanId id)
{
  return { id, IsAny<PlanVolume>, "the id of a volume of the plan", key };
}

PlanReference ToFragment(
  PlanId id, const char* key, std::size_t entry = PlanReference::NoEntry, const char* member = "")
{
  return { id, IsAny<PlanFragment>, "the id of a fragment of the plan", key, entry, member };
}

std::vector<PlanReference> ToFragments(const std::vector<PlanId>& fragments)
{
  std::vector<PlanReference> references;
  references.reserve(fragments.size());
  for (std::size_t n = 0; n < fragments.size(); ++n)
    references.push_back(ToFragment(fragments[n], "fragments", n));
  return references;
}

/// The same once more, for what is made of a scan's voxels.
void AlsoOfScans(std::vector<PlanReference>& references)
{
  const std::size_t all = references.size();
  for (std::size_t n = 0; n < all; ++n)
    if (PlanReference reference = references[n]; reference.fits == IsAny<PlanFragment>)
    {
      reference.fits = IsOfScan;
      reference.must = "a fragment of a scan: a surface's cannot be cut, guided or plated";
      references.push_back(reference);
    }
}

void CheckIds(const ValueChecks& check, const char* list, const std::vector<PlanId>& ids)
{
  if (ids.size() > MaxPlanObjects)
    check.Refuse(list, "has more than " + std::to_string(MaxPlanObjects) + " entries");
  if (std::set<PlanId>(ids.begin(), ids.end()).size() != ids.size())
    check.Refuse(list, "must name each once");
}

/// What a recipe is refused for, said of the object that holds it.
template <typename Validate>
void CheckRecipe(const ValueChecks& check, const char* key, const Validate& validate)
{
  try
  {
    validate();
  }
  catch (const std::invalid_argument& error)
  {
    check.Refuse(std::string(key) + ":", error.what());
  }
}

struct CheckSource
{
  const ValueChecks& check;
  PlanId self;

  void operator()(const LabelSource& source) const
  {
    this->check.Closed("source.label", source.label, 1, 65535);
    this->check.Closed("source.isovalue", source.isovalue, -1e6, 1e6);
    this->check.Closed("source.spacingMm", source.spacingMm, 0.1, 2.0);
  }
  void operator()(const ComponentSource& source) const
  {
    this->check.Closed("source.isovalue", source.isovalue, -1e6, 1e6);
    this->check.Point("source.seed", source.seed);
    this->check.Closed("source.spacingMm", source.spacingMm, 0.1, 2.0);
  }
  void operator()(const PieceSource& source) const
  {
    if (source.fragment >= this->self) // so that no fragment is a piece of itself
      this->check.Refuse("source.fragment", source.fragment, "older than the piece's id");
    this->check.Point("source.seed", source.seed);
  }
  void operator()(const SurfaceSource& source) const
  {
    this->check.Closed("source.thicknessMm", source.thicknessMm, 0.0, 50.0);
    this->check.Closed("source.spacingMm", source.spacingMm, 0.1, 2.0);
  }
};

struct SourceReferences
{
  std::vector<PlanReference> operator()(const LabelSource& source) const
  {
    return { { source.segmentation, IsAny<PlanSegmentation>, "the id of a segmentation of the plan",
      "source.segmentation" } };
  }
  std::vector<PlanReference> operator()(const ComponentSource& source) const
  {
    return { ToVolume("source.volume", source.volume) };
  }
  std::vector<PlanReference> operator()(const PieceSource& source) const
  {
    std::vector<PlanReference> references{ ToFragment(source.fragment, "source.fragment") };
    AlsoOfScans(references);
    return references;
  }
  std::vector<PlanReference> operator()(const SurfaceSource& source) const
  {
    return { { source.surface, IsAny<PlanSurface>, "the id of a surface of the plan",
      "source.surface" } };
  }
};
} // namespace

std::string PlanReference::Key() const
{
  return this->entry == NoEntry              ? this->key
         : std::string(this->member).empty() ? ListKey(this->key, this->entry)
                                             : ListKey(this->key, this->entry, this->member);
}

std::vector<PlanReference> References(const PlanVolume&)
{
  return {};
}

std::vector<PlanReference> References(const PlanSegmentation& object)
{
  return { ToVolume("volume", object.volume) };
}

std::vector<PlanReference> References(const PlanSurface&)
{
  return {};
}

std::vector<PlanReference> References(const PlanFragment& object)
{
  return std::visit(SourceReferences{}, object.source);
}

std::vector<PlanReference> References(const PlanGroup& object)
{
  return ToFragments(object.fragments);
}

std::vector<PlanReference> References(const PlanCut& object)
{
  std::vector<PlanReference> references = ToFragments(object.fragments);
  AlsoOfScans(references);
  return references;
}

std::vector<PlanReference> References(const PlanGuide& object)
{
  std::vector<PlanReference> references = { { object.bone, IsAny<PlanVolume, PlanFragment>,
    "the id of a volume or fragment of the plan", "bone" } };
  for (std::size_t n = 0; n < object.cuts.size(); ++n)
    references.push_back(
      { object.cuts[n], IsAny<PlanCut>, "the id of a cut of the plan", "cuts", n });
  references.push_back({ object.bone, IsBoneOfScan,
    "a volume, or a fragment of a scan: a surface's cannot be guided", "bone" });
  return references;
}

std::vector<PlanReference> References(const PlanPlate& object)
{
  std::vector<PlanReference> references = ToFragments(object.fragments);
  AlsoOfScans(references);
  if (object.volume != 0)
    references.push_back(ToVolume("volume", object.volume));
  return references;
}

std::vector<PlanReference> References(const PlanImplant& object)
{
  return { ToVolume("volume", object.volume) };
}

std::vector<PlanReference> References(const PlanTransplant& object)
{
  std::vector<PlanReference> references = { ToFragment(object.donor, "donor") };
  const auto add = [&](const JawFace& face, const char* cut, const char* fragment)
  {
    if (face.cut != 0)
      references.push_back({ face.cut, IsAny<PlanCut>, "the id of a cut of the plan", cut });
    if (face.fragment != 0)
      references.push_back(ToFragment(face.fragment, fragment));
  };
  add(object.first, "first.cut", "first.fragment");
  add(object.last, "last.cut", "last.fragment");
  AlsoOfScans(references);
  return references;
}

std::vector<PlanReference> References(const PlanMitreGuide& object)
{
  return { { object.transplant, IsAny<PlanTransplant>, "the id of a transplant of the plan",
    "transplant" } };
}

std::vector<PlanReference> References(const PlanMeasure& object)
{
  std::vector<PlanReference> references;
  for (std::size_t n = 0; n < object.points.size(); ++n)
    if (object.points[n].fragment != 0)
      references.push_back(ToFragment(object.points[n].fragment, "points", n, "fragment"));
  return references;
}

std::vector<PlanReference> References(const PlanMirror& object)
{
  std::vector<PlanReference> references = ToFragments(object.fragments);
  if (object.volume != 0)
    references.push_back(ToVolume("volume", object.volume));
  return references;
}

void CheckObject(const PlanVolume& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  check.Hash("hash", object.hash);
}

void CheckObject(const PlanSegmentation& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  if (!object.labels.empty())
    check.Hash("labels", object.labels);
  CheckRecipe(check, "recipe", [&] { ValidateSegmentationRecipe(object.recipe); });
}

void CheckObject(const PlanSurface& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  check.Hash("hash", object.hash);
}

void CheckObject(const PlanFragment& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  std::visit(CheckSource{ check, object.id }, object.source);
  CheckPlanPose(object.scanToPlanned, check);
}

void CheckObject(const PlanGroup& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  CheckIds(check, "fragments", object.fragments);
}

void CheckObject(const PlanCut& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  CheckIds(check, "fragments", object.fragments);
  check.Closed("reachMm", object.reachMm, 0.0, 500.0);
  ValidateOsteotomy(object.blade, subject + ".blade");
}

void CheckObject(const PlanGuide& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  CheckIds(check, "cuts", object.cuts);
  CheckRecipe(check, "recipe", [&] { ValidateGuideRecipe(object.recipe); });
}

void CheckObject(const PlanPlate& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  CheckIds(check, "fragments", object.fragments);
  if (object.fragments.size() > 100)
    check.Refuse("fragments", "has more than 100 entries");
  if ((object.volume == 0) == object.fragments.empty())
    check.Refuse("volume and fragments", "must be one of the two: a scan as it is, or fragments");
  if (!object.recipe.fragments.empty())
    check.Refuse("recipe.fragments", "must be none: they are the plan's");
  CheckRecipe(check, "recipe", [&] { ValidatePlateRecipe(object.recipe); });
}

void CheckObject(const PlanImplant& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  CheckRecipe(check, "recipe", [&] { ValidateImplantRecipe(object.recipe); });
}

void CheckObject(const PlanTransplant& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  CheckRecipe(check, "transplant", [&] { ValidateTransplant(object.transplant); });
  check.Closed("mostGapMm", object.mostGapMm, 0.0, 10.0);
  check.Closed("mostOverlapMm", object.mostOverlapMm, 0.0, 10.0);
}

void CheckObject(const PlanMitreGuide& object, const std::string& subject)
{
  ValueChecks(subject).Text("name", object.name);
  ValidateMitreGuideChoices(object.choices, subject, "choices.");
}

void CheckObject(const PlanMeasure& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  const std::size_t needed = object.kind == MeasureKind::Distance ? 2 : 3;
  if (object.points.size() != needed)
    check.Refuse("the number of points", double(object.points.size()), std::to_string(needed));
  for (std::size_t n = 0; n < needed; ++n)
    check.Point(ListKey("points", n, "point"), object.points[n].point);
}

void CheckObject(const PlanMirror& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  CheckIds(check, "fragments", object.fragments);
  if ((object.volume == 0) == object.fragments.empty())
    check.Refuse("volume and fragments", "must be one of the two: a scan's bone, or fragments");
  check.Closed("isovalue", object.isovalue, -1e6, 1e6);
  if (!object.plane)
    return;
  check.Point("plane.point", object.plane->point);
  check.Unit("plane.normal", object.plane->normal);
}

void CheckPlanPose(const PlanPose& pose, const ValueChecks& check)
{
  check.Point("scanToPlanned.position", pose.position);
  if (const double length = glm::length(pose.orientation); !(std::abs(length - 1.0) <= 1e-6))
    check.Refuse("scanToPlanned.orientation's length", length, "1 within 1e-6");
}

void CheckCaseLabel(const std::string& label)
{
  ValueChecks("plan").Text("caseLabel", label);
}

} // namespace hasp
