#pragma once
#include "Planning/StrictJson.h"
#include "Planning/TransplantRecipe.h"

namespace hasp
{

/// The choices of a mitre guide as JSON within another file, a transplant recipe's or a plan's: one
/// key for each, all of them there. Ranges are for ValidateMitreGuideChoices. `subject` and `name`
/// as StrictJson's. Internal.
Json MitreGuideToJson(const MitreGuideChoices& choices);
MitreGuideChoices MitreGuideFromJson(
  const Json& json, const std::string& subject, const std::string& name);

} // namespace hasp
