#include "Planning/PartRecipeFile.h"

#include "Planning/GuideRecipeJson.h"
#include "Planning/ImplantRecipeJson.h"
#include "Planning/PlateRecipeJson.h"
#include "Planning/RecipeFormat.h"

namespace hasp
{

namespace
{
constexpr const char* Subject = "recipe";

PartRecipe PartRecipeFromJson(const Json& json)
{
  const bool says = json.is_object() && json.contains("format") && json["format"].is_string();
  const std::string format = says ? json["format"].get<std::string>() : "";
  if (format.starts_with("hasp-plate-recipe-"))
    return PlateRecipeFromJson(json);
  if (format.starts_with("hasp-implant-recipe-"))
    return ImplantRecipeFromJson(json);
  return GuideRecipeFromJson(json);
}
} // namespace

PartRecipe ParsePartRecipe(const std::string& json)
{
  return ReadJson(json, Subject, PartRecipeFromJson);
}

PartRecipe ReadPartRecipe(const std::string& path)
{
  return ParsePartRecipe(ReadRecipeText(path, Subject));
}

} // namespace hasp
