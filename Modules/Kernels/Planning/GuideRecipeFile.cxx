#include "Planning/GuideRecipeFile.h"

#include "Planning/GuideRecipeJson.h"
#include "Planning/RecipeFormat.h"

namespace hasp
{

namespace
{
constexpr const char* Subject = "guide recipe";
} // namespace

GuideRecipe ParseGuideRecipe(const std::string& json)
{
  return ReadJson(json, Subject, GuideRecipeFromJson);
}

std::string FormatGuideRecipe(const GuideRecipe& recipe)
{
  return FormatJson(GuideRecipeToJson(recipe), Subject);
}

GuideRecipe ReadGuideRecipe(const std::string& path)
{
  return ParseGuideRecipe(ReadRecipeText(path, Subject));
}

void WriteGuideRecipe(const std::string& path, const GuideRecipe& recipe)
{
  WriteDurably(path, FormatGuideRecipe(recipe), std::string(Subject) + ": the file");
}

} // namespace hasp
