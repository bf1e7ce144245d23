#include "Planning/SegmentationRecipeFile.h"

#include "Planning/RecipeFormat.h"
#include "Planning/SegmentationJson.h"

namespace hasp
{

namespace
{
constexpr const char* Subject = "segmentation recipe";
} // namespace

SegmentationRecipe ParseSegmentationRecipe(const std::string& text)
{
  return ReadJson(text, Subject, SegmentationRecipeFromJson);
}

std::string FormatSegmentationRecipe(const SegmentationRecipe& recipe)
{
  return FormatJson(SegmentationRecipeToJson(recipe), Subject);
}

SegmentationRecipe ReadSegmentationRecipe(const std::string& path)
{
  return ParseSegmentationRecipe(ReadRecipeText(path, Subject));
}

void WriteSegmentationRecipe(const std::string& path, const SegmentationRecipe& recipe)
{
  WriteRecipeText(path, FormatSegmentationRecipe(recipe), Subject);
}

} // namespace hasp
