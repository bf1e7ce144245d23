#pragma once
#include "Planning/SegmentationRecipe.h"
#include "Planning/StrictJson.h"

#include <string>

namespace hasp
{

/// A segmentation recipe as JSON within another file, as a plan's; otherwise as in
/// SegmentationRecipeFile.h. What ValidateSegmentationRecipe refuses both refuse. Internal.
Json SegmentationRecipeToJson(const SegmentationRecipe& recipe);
SegmentationRecipe SegmentationRecipeFromJson(const Json& json);

/// One step or stroke, as an edit holds it, `name` is where it stands. Its values are not checked,
/// but for what the types cannot hold.
Json StepToJson(const SegmentationStep& step);
SegmentationStep StepFromJson(
  const Json& json, const std::string& subject, const std::string& name);
Json StrokeToJson(const BrushStroke& stroke);
BrushStroke StrokeFromJson(const Json& json, const std::string& subject, const std::string& name);
/// Points as [[x, y, z], …].
Json PointsToJson(const std::vector<glm::dvec3>& points);

} // namespace hasp
