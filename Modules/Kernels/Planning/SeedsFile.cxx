#include "Planning/SeedsFile.h"

#include "Planning/RecipeFormat.h"
#include "Planning/SegmentationJson.h"
#include "Planning/SlicerMarkups.h"
#include "Planning/ValueChecks.h"

#include <set>

namespace hasp
{

namespace
{
const std::string Subject = "seeds";
constexpr const char* Format = "hasp-seeds-1";

/// "file 2: " where there are several
std::string FileOf(std::size_t file, std::size_t files)
{
  return files == 1 ? "" : "file " + std::to_string(file + 1) + ": ";
}

/// "seeds", or "seeds: file 2"
std::string SubjectOf(std::size_t file, std::size_t files)
{
  return files == 1 ? Subject : Subject + ": file " + std::to_string(file + 1);
}

Seeds SeedsFromJson(const Json& json, const std::string& subject)
{
  CheckFormat(json, subject, { Format });
  const StrictJson top(json, subject, "", { "format", "labels" });
  Seeds seeds;
  for (const Json& value : top.List("labels", 65535))
  {
    const std::string place = ListKey("labels", seeds.names.size());
    const StrictJson label(value, subject, place, { "label", "name", "colour", "strokes" });
    seeds.names.push_back({ static_cast<std::uint16_t>(label.Count("label", 1, 65535)),
      label.Text("name"), label.Colour("colour") });
    std::size_t number = 0;
    for (const Json& entry : label.List("strokes", MostStrokes))
    {
      const std::string at = place + "." + ListKey("strokes", number++);
      const StrictJson stroke(entry, subject, at, { "radiusMm", "points" });
      seeds.strokes.push_back({ seeds.names.back().label, stroke.Number("radiusMm"),
        stroke.Vectors("points", MostStrokePoints) });
      ValidateBrushStroke(seeds.strokes.back(), subject + ": " + at);
      seeds.places.push_back(at);
    }
  }
  ValidateLabelNames(seeds.names, subject, "labels");
  ValidateSeeds(seeds);
  return seeds;
}

Json SeedsToJson(const Seeds& seeds)
{
  ValidateSeeds(seeds);
  Json labels = Json::array();
  for (const LabelName& name : seeds.names)
  {
    Json strokes = Json::array();
    for (const BrushStroke& stroke : seeds.strokes)
      if (stroke.label == name.label)
        strokes.push_back(
          { { "radiusMm", stroke.radiusMm }, { "points", PointsToJson(stroke.points) } });
    labels.push_back({ { "label", name.label }, { "name", name.name },
      { "colour", ColourText(name.colour) }, { "strokes", std::move(strokes) } });
  }
  return { { "format", Format }, { "labels", std::move(labels) } };
}
} // namespace

void ValidateSeeds(const Seeds& seeds)
{
  const ValueChecks check(Subject);
  ValidateLabelNames(seeds.names, Subject);
  check.Closed("the number of strokes", double(seeds.strokes.size()), 0.0, double(MostStrokes));
  std::set<std::uint16_t> named;
  for (const LabelName& name : seeds.names)
    named.insert(name.label);
  for (std::size_t n = 0; n < seeds.strokes.size(); ++n)
  {
    ValidateBrushStroke(seeds.strokes[n], Subject + ": " + ListKey("strokes", n));
    if (!named.contains(seeds.strokes[n].label))
      check.Refuse(ListKey("strokes", n, "label"), seeds.strokes[n].label, "one of the names'");
  }
}

Seeds ParseSeeds(const std::string& text)
{
  return ReadJson(text, Subject, [](const Json& json) { return SeedsFromJson(json, Subject); });
}

std::string FormatSeeds(const Seeds& seeds)
{
  return FormatJson(SeedsToJson(seeds), Subject);
}

void WriteSeeds(const std::string& path, const Seeds& seeds)
{
  WriteRecipeText(path, FormatSeeds(seeds), Subject);
}

Seeds ParseAnySeeds(const std::vector<std::string>& texts, const MarkupsChoices& choices)
{
  const ValueChecks check(Subject);
  check.AboveUpTo("radiusMm", choices.radiusMm, 0.0, 50.0);
  check.Closed("firstLabel", choices.firstLabel, 1, 65535);
  if (texts.empty())
    check.Refuse("the files", "are none; give one or more");
  std::vector<SlicerMarkup> markups;
  std::size_t notPlaced = 0;
  for (std::size_t n = 0; n < texts.size(); ++n)
  {
    const std::string subject = SubjectOf(n, texts.size());
    Seeds own;
    const bool isOwn = ReadJson(texts[n], subject,
      [&](const Json& json)
      {
        if (IsMarkups(json))
        {
          const std::size_t before = markups.size();
          ReadMarkups(json, subject, choices.radiusMm, markups, notPlaced);
          for (std::size_t m = before; m < markups.size(); ++m)
            for (std::string& place : markups[m].places)
              place.insert(0, FileOf(n, texts.size()));
        }
        else if (json.is_object() && !json.contains("format"))
          ValueChecks(subject).Refuse(
            "the file", std::string("is of no kind that is known: it has neither a format, '") +
                          Format + "', nor markups, as Slicer's .mrk.json");
        else
          own = SeedsFromJson(json, subject);
        return !IsMarkups(json);
      });
    if (isOwn && texts.size() > 1)
      ValueChecks(subject).Refuse(
        "format", std::string("is '") + Format + "', which holds all labels: give it alone");
    if (isOwn)
      return own;
  }
  Seeds seeds = SeedsOfMarkups(std::move(markups), choices.firstLabel);
  seeds.notPlaced = notPlaced;
  ValidateSeeds(seeds);
  return seeds;
}

Seeds ReadSeeds(const std::vector<std::string>& paths, const MarkupsChoices& choices)
{
  std::vector<std::string> texts;
  texts.reserve(paths.size());
  for (const std::string& path : paths)
    texts.push_back(ReadRecipeText(path, SubjectOf(texts.size(), paths.size())));
  return ParseAnySeeds(texts, choices);
}

std::string FormatMarkups(const Seeds& seeds)
{
  return FormatJson(MarkupsToJson(seeds), Subject);
}

void WriteMarkups(const std::string& path, const Seeds& seeds)
{
  WriteRecipeText(path, FormatMarkups(seeds), Subject);
}

} // namespace hasp
