#pragma once
#include "PartFixture.h"

#include "Grid/Phantom.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// A phantom and a recipe that fits it.
class GuideRecipeTest : public PartTest
{
protected:
  GuideRecipeTest() : PartTest("guide", "recipe") {}
  /// A band over the phantom's left frontal bone.
  static nlohmann::json Recipe()
  {
    const hasp::PhantomSettings settings;
    nlohmann::json landmarks = nlohmann::json::array();
    glm::dvec3 outward(0.0);
    for (const double left : { 0.25, 0.40, 0.55 })
    {
      const glm::dvec3 direction = glm::normalize(glm::dvec3(left, -1.0, 0.6));
      const glm::dvec3 p = hasp::PhantomOuterTable(settings, direction);
      landmarks.push_back({ p.x, p.y, p.z });
      outward += direction;
    }
    outward = glm::normalize(outward);
    return { { "format", "hasp-guide-recipe-1" }, { "note", "" }, { "isovalue", 226 },
      { "landmarks", landmarks }, { "outline", "open" },
      { "withdrawal", { outward.x, outward.y, outward.z } }, { "gapMm", 0.4 },
      { "thicknessMm", 3.0 }, { "widthMm", 14.0 }, { "spacingMm", 0.7 },
      { "ignoreBelowMm3", 100.0 }, { "slots", nlohmann::json::array() },
      { "holes", nlohmann::json::array() } };
  }
  HaspRun Guide(const nlohmann::json& recipe, const std::vector<std::string>& more = {}) const
  {
    return this->Make(recipe, more);
  }
};
