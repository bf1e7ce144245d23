#include "Planning/DerivedPart.h"

#include "Planning/PlanJson.h"
#include "Planning/PlanLists.h"
#include "Planning/Sha256.h"

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
    Json json = ObjectToJson(object);
    json.erase("id");
    json.erase("name");
    for (const char* key : without)
      json.erase(key);
    return this->Found.emplace(std::pair(object.id, PartFacet::Shape), HashOf(std::move(json)))
      .second;
  }
  void ShapeOf(const PlanVolume& object) { this->Add(object, {}); }
  void ShapeOf(const PlanSegmentation& object)
  {
    this->Add(object, {});
    this->Shape(object.volume);
  }
  void ShapeOf(const PlanFragment& object)
  {
    if (!this->Add(object, { "colour", "state", "scanToPlanned", "locked" }))
      return;
    if (const auto* label = std::get_if<LabelSource>(&object.source))
      this->Shape(label->segmentation);
    if (const auto* component = std::get_if<ComponentSource>(&object.source))
      this->Shape(component->volume);
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
      const Json fragment = ObjectToJson(*FindPlanObject<PlanFragment>(this->Of, id));
      this->Found[{ id, PartFacet::Place }] =
        HashOf({ { "pose", fragment["scanToPlanned"] }, { "state", fragment["state"] } });
    }
  }
  void ShapeOf(const PlanCut& object) { this->Add(object, { "fragments" }); } // the blade alone
  void ShapeOf(const PlanGuide& object)
  {
    this->Add(object, {});
    this->Shape(object.bone);
    for (const PlanId cut : object.cuts)
      this->Shape(cut);
  }
  void ShapeOf(const PlanMeasure&) {}

  const Plan& Of;
};

InputHashes Gather(const Plan& plan, PlanId object)
{
  Gathering gathering(plan);
  gathering.Shape(object);
  return std::move(gathering.Found);
}

std::string Called(const Plan& plan, PlanId id)
{
  const char* noun = PlanNoun(plan, id);
  return std::string(noun ? noun : "object") + " " + std::to_string(id);
}
} // namespace

std::vector<PartInput> PartInputs(const Plan& plan, PlanId object)
{
  if (!FindPlanObject<PlanFragment>(plan, object) && !FindPlanObject<PlanGroup>(plan, object) &&
      !FindPlanObject<PlanGuide>(plan, object))
    throw std::invalid_argument(
      Called(plan, object) + ": nothing is made of it, only of a fragment, group or guide");
  std::vector<PartInput> inputs;
  for (auto& [key, hash] : Gather(plan, object))
    inputs.push_back({ key.first, key.second, hash });
  return inputs;
}

std::string WhyOutOfDate(const Plan& plan, const DerivedPart& part)
{
  const std::string outOfDate = Called(plan, part.object) + " is out of date: ";
  if (!PlanNoun(plan, part.object))
    return outOfDate + "the plan has no such object any more";
  InputHashes now = Gather(plan, part.object);
  for (const PartInput& input : part.inputs)
  {
    const auto found = now.find({ input.id, input.facet });
    const std::string called = Called(plan, input.id);
    if (found == now.end())
      return outOfDate + "it is not made from " + called + " any more";
    if (found->second != input.hash)
      return outOfDate + called +
             (input.facet == PartFacet::Shape ? " has changed"
                                              : " has been moved, resected or kept");
    now.erase(found);
  }
  if (!now.empty())
    return outOfDate + "it is now made from " + Called(plan, now.begin()->first.first) + ", too";
  return {};
}

std::string PlanHash(const Plan& plan)
{
  return HashOf(PlanToJson(plan));
}

} // namespace hasp
