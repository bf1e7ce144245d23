#pragma once
#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// A head, and a verb that makes a part of it by a recipe.
class PartTest : public HaspTest
{
protected:
  /// `part` is the verb; its recipe is written to `recipe`.json.
  PartTest(const std::string& part, const std::string& recipe)
    : Part(part),
      RecipeFile(recipe + ".json")
  {
  }
  HaspRun Make(const nlohmann::json& recipe, const std::vector<std::string>& more = {}) const
  {
    this->WriteText(this->RecipeFile, recipe.dump());
    return this->Run(
      { this->Part, "head.mha", "--recipe", this->RecipeFile, "--output", this->Part + ".stl" },
      more);
  }
  HaspRun CertifyMade(const std::vector<std::string>& more = {}) const
  {
    return this->Run(
      { "certify", this->Part + ".stl", "--bone", "head.mha", "--recipe", this->RecipeFile }, more);
  }
  void FinePhantom() const
  {
    ASSERT_EQ(
      RunHasp({ "phantom", "--spacing", "2,2,2", "--output", this->Path("head.mha") }).exitCode, 0);
  }

private:
  HaspRun Run(std::vector<std::string> words, const std::vector<std::string>& more) const
  {
    for (std::string& word : words)
      if (word.find('.') != std::string::npos)
        word = this->Path(word);
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  std::string Part, RecipeFile;
};
