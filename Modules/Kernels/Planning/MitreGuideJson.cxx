#include "Planning/MitreGuideJson.h"

namespace hasp
{

namespace
{
/// Each key with its place, once for both ways.
template <typename Choices, typename Visit>
void ForEachGuideKey(Choices& guide, const Visit& visit)
{
  visit("gapMm", guide.gapMm);
  visit("thicknessMm", guide.thicknessMm);
  visit("widthMm", guide.widthMm);
  visit("clearanceMm", guide.clearanceMm);
  visit("wallMm", guide.wallMm);
  visit("slotLengthMm", guide.slotLengthMm);
  visit("guidingHeightMm", guide.guidingHeightMm);
  visit("beyondMm", guide.beyondMm);
  visit("pinDiameterMm", guide.pinDiameterMm);
  visit("spacingMm", guide.spacingMm);
}
} // namespace

Json MitreGuideToJson(const MitreGuideChoices& choices)
{
  Json json;
  ForEachGuideKey(choices, [&](const char* key, double value) { json[key] = value; });
  return json;
}

MitreGuideChoices MitreGuideFromJson(
  const Json& json, const std::string& subject, const std::string& name)
{
  const StrictJson read(json, subject, name,
    { "gapMm", "thicknessMm", "widthMm", "clearanceMm", "wallMm", "slotLengthMm", "guidingHeightMm",
      "beyondMm", "pinDiameterMm", "spacingMm" });
  MitreGuideChoices choices;
  ForEachGuideKey(choices, [&](const char* key, double& value) { value = read.Number(key); });
  return choices;
}

} // namespace hasp
