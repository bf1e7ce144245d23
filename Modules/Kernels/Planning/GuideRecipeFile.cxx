#include "Planning/GuideRecipeFile.h"

#include "Planning/GuideRecipeJson.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr const char* Subject = "guide recipe";
} // namespace

GuideRecipe ParseGuideRecipe(const std::string& json)
{
  return GuideRecipeFromJson(ParseJson(json, Subject));
}

std::string FormatGuideRecipe(const GuideRecipe& recipe)
{
  return FormatJson(GuideRecipeToJson(recipe), Subject);
}

GuideRecipe ReadGuideRecipe(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file)
    throw std::runtime_error("guide recipe: the file cannot be read");
  return ParseGuideRecipe(text.str());
}

void WriteGuideRecipe(const std::string& path, const GuideRecipe& recipe)
{
  const std::string text = FormatGuideRecipe(recipe), temporary = path + ".part";
  {
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file << text;
    if (!file.flush())
    {
      std::remove(temporary.c_str());
      throw std::runtime_error("guide recipe: the file cannot be written");
    }
  }
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error)
  {
    std::remove(temporary.c_str());
    throw std::runtime_error("guide recipe: the file cannot be put in place: " + error.message());
  }
}

} // namespace hasp
