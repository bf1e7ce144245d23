#include "Planning/DerivedPart.h"

#include "Planning/PlanJson.h"
#include "Planning/PlanLists.h"
#include "Planning/Sha256.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
/// -0 and 0 are equal and must be one text.
void DropSigns(Json& json)
{
  if (json.is_number_float() && json.get<double>() == 0.0)
    json = 0.0;
  else if (json.is_structured())
    for (Json& value : json)
      DropSigns(value);
}

std::string HashOf(Json json)
{
  DropSigns(json);
  return Sha256(json.dump());
}

using InputHashes = std::map<std::pair<PlanId, PartFacet>, std::string>;

/// Adds an object and all that its shape comes from.
class Gathering
{
public:
  explicit Gathering(const Plan& of) : Of(of) {}

  void Shape(PlanId id)
  {
    ForEachPlanList(
      [&]<typename T>(const PlanList<T>&)
      {
        if (const T* object = FindPlanObject<T>(this->Of, id))
          this->ShapeOf(*object);
      });
  }
  InputHashes Found;

private:
  template <typename T>
  bool Add(const T& object, std::initializer_list<const char*> without)
  {
    if (this->Found.contains({ object.id, PartFacet::Shape })) // a recipe may be long
      return false;
    Json json = ObjectToJson(object);
    json.erase("id");
    json.erase("name");
    for (const char* key : without)
      json.erase(key);
    this->Found.emplace(std::pair(object.id, PartFacet::Shape), HashOf(std::move(json)));
    return true;
  }
  void ShapeOf(const PlanVolume& object) { this->Add(object, {}); }
  void ShapeOf(const PlanSegmentation& object)
  {
    if (object.recipe.steps.empty()) // what was made before there were recipes stays in date
      this->Add(object, { "recipe" });
    else
    {
      PlanSegmentation nameless = object;
      nameless.recipe.names.clear();
      this->Add(nameless, {});
    }
    this->Shape(object.volume);
  }
  void ShapeOf(const PlanSurface& object) { this->Add(object, {}); }
  void ShapeOf(const PlanFragment& object)
  {
    if (!this->Add(object, { "colour", "state", "scanToPlanned", "locked" }))
      return;
    if (const auto* label = std::get_if<LabelSource>(&object.source))
      this->Shape(label->segmentation);
    if (const auto* component = std::get_if<ComponentSource>(&object.source))
      this->Shape(component->volume);
    if (const auto* surface = std::get_if<SurfaceSource>(&object.source))
      this->Shape(surface->surface);
    if (const auto* piece = std::get_if<PieceSource>(&object.source))
    {
      this->Shape(piece->fragment);
      for (const PlanId cut : CutsThrough(this->Of, piece->fragment))
        this->Shape(cut);
    }
  }
  void ShapeOf(const PlanGroup& object)
  {
    this->Add(object, {});
    for (const PlanId id : object.fragments)
    {
      this->Shape(id);
      this->Place(id);
    }
  }
  void ShapeOf(const PlanCut& object) { this->Add(object, { "fragments" }); } // the blade alone
  void ShapeOf(const PlanGuide& object)
  {
    this->Add(object, {});
    if (HasCaseLabel(object.recipe))
      this->Found[{ 0, PartFacet::CaseLabel }] = HashOf(this->Of.caseLabel);
    this->Shape(object.bone);
    for (const PlanId cut : object.cuts)
      this->Shape(cut);
  }
  void ShapeOf(const PlanPlate& object)
  {
    this->Add(object, {});
    this->Shape(object.volume); // or nothing: 0 names none
    for (const PlanId id : object.fragments)
    {
      this->Shape(id);
      this->Place(id);
    }
  }
  void ShapeOf(const PlanImplant& object)
  {
    this->Add(object, {});
    this->Shape(object.volume);
  }
  void ShapeOf(const PlanTransplant& object)
  {
    this->Add(object, {});
    this->LayOut(object);
    for (const JawFace& face : { object.first, object.last })
      this->Shape(face.fragment); // that the joint's fit is measured to
  }
  void ShapeOf(const PlanMitreGuide& object)
  {
    this->Add(object, {});
    if (const auto* transplant = FindPlanObject<PlanTransplant>(this->Of, object.transplant))
      this->LayOut(*transplant);
  }
  void ShapeOf(const PlanMeasure&) {}
  void ShapeOf(const PlanMirror&) {}
  /// Where a donor is cut: without the bones that its segments come to.
  void LayOut(const PlanTransplant& object)
  {
    this->Add(object, { "mostGapMm", "mostOverlapMm" }); // unless it is there as a whole
    this->Shape(object.donor);
    for (const JawFace& face : { object.first, object.last })
    {
      this->Shape(face.cut);
      this->Place(face.fragment);
    }
  }
  void Place(PlanId id)
  {
    const PlanFragment* found = FindPlanObject<PlanFragment>(this->Of, id);
    if (!found)
      return;
    const Json fragment = ObjectToJson(*found);
    this->Found[{ id, PartFacet::Place }] =
      HashOf({ { "pose", fragment["scanToPlanned"] }, { "state", fragment["state"] } });
  }

  const Plan& Of;
};

InputHashes Gather(const Plan& plan, PlanId object)
{
  Gathering gathering(plan);
  gathering.Shape(object);
  return std::move(gathering.Found);
}

std::vector<PartInput> InputsOf(const Plan& plan, PlanId object)
{
  std::vector<PartInput> inputs;
  for (auto& [key, hash] : Gather(plan, object))
    inputs.push_back({ key.first, key.second, hash });
  return inputs;
}

const PlanSegmentation& Segmentation(const Plan& plan, PlanId id)
{
  const auto* found = FindPlanObject<PlanSegmentation>(plan, id);
  if (!found)
    throw std::invalid_argument(
      CalledObject(plan, id) + ": it is no segmentation, and has no label map");
  return *found;
}

std::string Called(const Plan& plan, const std::pair<PlanId, PartFacet>& input)
{
  return input.second == PartFacet::CaseLabel ? "the case label" : CalledObject(plan, input.first);
}

/// Whether meshes are made of a kind; a new kind is a line here.
template <typename T>
constexpr bool MakesParts = false;
template <>
constexpr bool MakesParts<PlanFragment> = true;
template <>
constexpr bool MakesParts<PlanGroup> = true;
template <>
constexpr bool MakesParts<PlanGuide> = true;
template <>
constexpr bool MakesParts<PlanPlate> = true;
template <>
constexpr bool MakesParts<PlanImplant> = true;
template <>
constexpr bool MakesParts<PlanTransplant> = true;
template <>
constexpr bool MakesParts<PlanMitreGuide> = true;

/// A surface's fragment, or a group with one: the surface's file is there already, and the scan's
/// parts are made of voxels.
bool HoldsSurface(const Plan& plan, PlanId object)
{
  if (const PlanGroup* group = FindPlanObject<PlanGroup>(plan, object))
    return std::any_of(group->fragments.begin(), group->fragments.end(),
      [&](PlanId id) { return !IsOfScan(plan, id); });
  return FindPlanObject<PlanFragment>(plan, object) && !IsOfScan(plan, object);
}
} // namespace

bool IsPartObject(const Plan& plan, PlanId object)
{
  if (HoldsSurface(plan, object))
    return false;
  bool is = false;
  ForEachPlanList([&]<typename T>(const PlanList<T>&)
    { is = is || (MakesParts<T> && FindPlanObject<T>(plan, object) != nullptr); });
  return is;
}

std::vector<PlanId> PartObjects(const Plan& plan)
{
  std::vector<PlanId> objects;
  ForEachPlanObject(plan,
    [&]<typename T>(const T& object)
    {
      if (MakesParts<T> && !IsDivided(plan, object.id) && !HoldsSurface(plan, object.id))
        objects.push_back(object.id);
    });
  return objects;
}

std::vector<PartInput> PartInputs(const Plan& plan, PlanId object)
{
  if (HoldsSurface(plan, object))
    throw std::invalid_argument(CalledObject(plan, object) +
                                ": nothing is made of a surface's fragment, nor of a group with "
                                "one; the surface's own file is its part");
  if (!IsPartObject(plan, object))
    throw std::invalid_argument(
      CalledObject(plan, object) +
      ": nothing is made of it, only of a fragment, group, guide, plate, implant, transplant or "
      "mitre guide");
  return InputsOf(plan, object);
}

std::vector<PartInput> LabelInputs(const Plan& plan, PlanId segmentation)
{
  return InputsOf(plan, Segmentation(plan, segmentation).id);
}

std::string LabelMapOf(const Plan& plan, std::span<const DerivedPart> parts, PlanId segmentation)
{
  const PlanSegmentation& found = Segmentation(plan, segmentation);
  const std::string called = CalledObject(plan, segmentation) + ": ";
  if (found.recipe.steps.empty())
  {
    if (found.labels.empty())
      throw std::invalid_argument(called + "it has neither labels nor steps yet");
    return found.labels;
  }
  const DerivedPart* made = PartInDate(plan, parts, segmentation, PartFormat::Nrrd);
  if (!made)
    throw std::invalid_argument(called + "its label map must be made first: " +
                                WhyNoPart(plan, parts, segmentation, PartFormat::Nrrd));
  return made->bytes;
}

std::string WhyOutOfDate(const Plan& plan, const DerivedPart& part)
{
  const std::string outOfDate = CalledObject(plan, part.object) + " is out of date: ";
  if (!PlanNoun(plan, part.object))
    return outOfDate + "the plan has no such object any more";
  InputHashes now = Gather(plan, part.object);
  for (const PartInput& input : part.inputs)
  {
    const std::pair key(input.id, input.facet);
    const auto found = now.find(key);
    const std::string called = Called(plan, key);
    if (found == now.end())
      return outOfDate + "it is not made from " + called + " any more";
    if (found->second != input.hash)
      return outOfDate + called +
             (input.facet == PartFacet::Place ? " has been moved, resected or kept"
                                              : " has changed");
    now.erase(found);
  }
  if (!now.empty())
    return outOfDate + "it is now made from " + Called(plan, now.begin()->first) + ", too";
  return {};
}

const DerivedPart* PartInDate(
  const Plan& plan, std::span<const DerivedPart> parts, PlanId object, PartFormat format)
{
  for (std::size_t n = parts.size(); n-- > 0;)
    if (parts[n].object == object && parts[n].format == format &&
        WhyOutOfDate(plan, parts[n]).empty())
      return &parts[n];
  return nullptr;
}

std::string WhyNoPart(
  const Plan& plan, std::span<const DerivedPart> parts, PlanId object, PartFormat format)
{
  if (PartInDate(plan, parts, object, format))
    return {};
  for (std::size_t n = parts.size(); n-- > 0;)
    if (parts[n].object == object && parts[n].format == format)
      return WhyOutOfDate(plan, parts[n]);
  return CalledObject(plan, object) + " has not been made";
}

void KeepPart(std::vector<DerivedPart>& parts, DerivedPart part)
{
  std::erase_if(parts,
    [&](const DerivedPart& other)
    {
      return other.object == part.object && other.format == part.format &&
             other.inputs == part.inputs;
    });
  const auto same = [&](const DerivedPart& other)
  { return other.object == part.object && other.format == part.format; };
  if (std::size_t(std::count_if(parts.begin(), parts.end(), same)) >= MaxPartsOfObject)
    parts.erase(std::find_if(parts.begin(), parts.end(), same));
  parts.push_back(std::move(part));
}

std::string PlanHash(const Plan& plan)
{
  return HashOf(PlanToJson(plan));
}

} // namespace hasp
