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

PlanReference ToVolume(const char* key, PlanId id)
{
  return { key, id, IsAny<PlanVolume>, "a volume of the plan" };
}

PlanReference ToFragment(const std::string& key, PlanId id)
{
  return { key, id, IsAny<PlanFragment>, "a fragment of the plan" };
}

std::vector<PlanReference> ToFragments(const std::vector<PlanId>& fragments)
{
  std::vector<PlanReference> references;
  for (std::size_t n = 0; n < fragments.size(); ++n)
    references.push_back(ToFragment(ListKey("fragments", n), fragments[n]));
  return references;
}

void CheckHash(const ValueChecks& check, const char* key, const std::string& hash)
{
  const bool isHash = hash.size() == 64 && hash.find_first_not_of("0123456789abcdef") == hash.npos;
  if (!isHash)
    check.Refuse(key, "must be 64 hexadecimal digits in lower case, a SHA-256");
}

void CheckIds(const ValueChecks& check, const char* list, const std::vector<PlanId>& ids)
{
  if (ids.size() > MaxPlanObjects)
    check.Refuse(list, "has more than " + std::to_string(MaxPlanObjects) + " entries");
  if (std::set<PlanId>(ids.begin(), ids.end()).size() != ids.size())
    check.Refuse(list, "must name each once");
}

struct CheckSource
{
  const ValueChecks& check;
  PlanId self;

  void operator()(const LabelSource& source) const
  {
    this->check.Closed("source.label", source.label, 1, 65535);
  }
  void operator()(const ComponentSource& source) const
  {
    this->check.Closed("source.isovalue", source.isovalue, -1e6, 1e6);
    this->check.Point("source.seed", source.seed);
  }
  void operator()(const PieceSource& source) const
  {
    if (source.fragment >= this->self) // so that no fragment is a piece of itself
      this->check.Refuse("source.fragment", source.fragment, "older than the piece's id");
    this->check.Point("source.seed", source.seed);
  }
};

struct SourceReferences
{
  std::vector<PlanReference> operator()(const LabelSource& source) const
  {
    return { { "source.segmentation", source.segmentation, IsAny<PlanSegmentation>,
      "a segmentation of the plan" } };
  }
  std::vector<PlanReference> operator()(const ComponentSource& source) const
  {
    return { ToVolume("source.volume", source.volume) };
  }
  std::vector<PlanReference> operator()(const PieceSource& source) const
  {
    return { ToFragment("source.fragment", source.fragment) };
  }
};
} // namespace

std::vector<PlanReference> References(const PlanVolume&)
{
  return {};
}

std::vector<PlanReference> References(const PlanSegmentation& object)
{
  return { ToVolume("volume", object.volume) };
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
  return ToFragments(object.fragments);
}

std::vector<PlanReference> References(const PlanGuide& object)
{
  std::vector<PlanReference> references = { { "bone", object.bone, IsAny<PlanVolume, PlanFragment>,
    "a volume or fragment of the plan" } };
  for (std::size_t n = 0; n < object.cuts.size(); ++n)
    references.push_back(
      { ListKey("cuts", n), object.cuts[n], IsAny<PlanCut>, "a cut of the plan" });
  return references;
}

std::vector<PlanReference> References(const PlanMeasure& object)
{
  std::vector<PlanReference> references;
  for (std::size_t n = 0; n < object.points.size(); ++n)
    if (object.points[n].fragment != 0)
      references.push_back(ToFragment(ListKey("points", n, "fragment"), object.points[n].fragment));
  return references;
}

void CheckObject(const PlanVolume& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  CheckHash(check, "hash", object.hash);
}

void CheckObject(const PlanSegmentation& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  CheckHash(check, "labels", object.labels);
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
  ValidateOsteotomy(object.blade, subject + ".blade");
}

void CheckObject(const PlanGuide& object, const std::string& subject)
{
  const ValueChecks check(subject);
  check.Text("name", object.name);
  CheckIds(check, "cuts", object.cuts);
  try
  {
    ValidateGuideRecipe(object.recipe);
  }
  catch (const std::invalid_argument& error)
  {
    check.Refuse("recipe:", error.what());
  }
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
