#include "Planning/SlicerMarkups.h"

#include "Planning/ValueChecks.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr const char* Schema =
  "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/"
  "Schema/markups-schema-v1.0.3.json#";
/// Slicer keeps descriptions of control points, and nothing else that it does not know.
const std::string LabelMark = "Hasp label ";
constexpr std::size_t MostMarkups = 10'000;

enum class MarkupType
{
  Fiducial,
  Line,
  Curve,
  ClosedCurve
};
constexpr std::pair<MarkupType, const char*> Types[] = { { MarkupType::Fiducial, "Fiducial" },
  { MarkupType::Line, "Line" }, { MarkupType::Curve, "Curve" },
  { MarkupType::ClosedCurve, "ClosedCurve" } };
/// What x and y are to be multiplied by; Slicer's numbers are those of its own enumeration.
constexpr std::pair<int, const char*> CoordinateSystems[] = { { 1, "LPS" }, { -1, "RAS" },
  { 1, "1" }, { -1, "0" } };
constexpr std::pair<double, const char*> Units[] = { { 1.0, "mm" }, { 1e-3, "um" } };
enum class PositionStatus
{
  Defined,
  Undefined,
  Preview,
  Missing
};
constexpr std::pair<PositionStatus, const char*> Statuses[] = {
  { PositionStatus::Defined, "defined" }, { PositionStatus::Undefined, "undefined" },
  { PositionStatus::Preview, "preview" }, { PositionStatus::Missing, "missing" }
};

void CheckSchema(const StrictJson& file)
{
  if (!file.Has("@schema"))
    return;
  std::string schema = file.Text("@schema");
  std::transform(schema.begin(), schema.end(), schema.begin(),
    [](unsigned char c) { return char(std::tolower(c)); });
  if (schema.find("markups-schema-v1.") == std::string::npos)
    file.Fail("@schema",
      "must be one of Slicer's markups-schema-v1.x: save the markups as .mrk.json "
      "again with Slicer 4.11 to 5");
}

/// mm, LPS per number of the file.
glm::dvec3 ScaleOf(const StrictJson& markup, const std::string& subject, const std::string& name)
{
  const int turn =
    markup.Has("coordinateSystem") ? markup.Named("coordinateSystem", CoordinateSystems) : 1;
  double unit = 1.0;
  if (markup.Has("coordinateUnits"))
  {
    const Json& units = markup.Get("coordinateUnits"); // a text, or [code, scheme, meaning]
    const bool coded = units.is_array() && units.size() == 3;
    const Json wrapped = { { "coordinateUnits", coded ? units[0] : units } };
    unit = StrictJson(wrapped, subject, name).Named("coordinateUnits", Units);
  }
  return glm::dvec3(turn, turn, 1.0) * unit;
}

std::uint8_t ReadShare(const StrictJson& display, const char* key, double share)
{
  if (!(share >= 0.0 && share <= 1.0))
    display.Fail(key, "must be three numbers in [0, 1]");
  return static_cast<std::uint8_t>(std::lround(share * 255.0));
}

void ReadDisplay(const StrictJson& display, SlicerMarkup& markup, double& radiusMm)
{
  for (const char* key : { "color", "selectedColor" })
    if (display.Has(key))
    {
      const glm::dvec3 colour = display.Vector(key);
      for (int c = 0; c < 3; ++c)
        markup.name.colour[std::size_t(c)] = ReadShare(display, key, colour[c]);
      markup.hasColour = true;
    }
  if (display.Has("useGlyphScale") && !display.Flag("useGlyphScale") && display.Has("glyphSize"))
  {
    const double size = display.Number("glyphSize");
    if (!(size > 0.0 && size <= 100.0))
      display.Fail("glyphSize", "must be in (0, 100] mm: it is the brush's diameter");
    radiusMm = 0.5 * size;
  }
}

/// The number in "Hasp label 3", 0 in any other text.
std::uint16_t MarkedLabel(const std::string& description)
{
  std::uint16_t label = 0;
  if (!description.starts_with(LabelMark))
    return 0;
  const char *first = description.data() + LabelMark.size(),
             *last = description.data() + description.size();
  const auto [end, error] = std::from_chars(first, last, label);
  return error == std::errc() && end == last ? label : 0;
}

/// The markup's control points that have a place, mm, LPS, and how they are called.
struct PlacedPoints
{
  std::vector<glm::dvec3> points;
  std::vector<std::string> places;
};

PlacedPoints ReadPoints(const StrictJson& read, const std::string& subject, const std::string& name,
  SlicerMarkup& markup, std::size_t& notPlaced)
{
  const glm::dvec3 scale = ScaleOf(read, subject, name);
  PlacedPoints placed;
  std::size_t number = 0;
  for (const Json& value : read.List("controlPoints", MostStrokePoints))
  {
    const std::string place = name + "." + ListKey("controlPoints", number++);
    const StrictJson point(value, subject, place);
    if (markup.label == 0 && point.Has("description"))
      markup.label = MarkedLabel(point.Text("description"));
    const PositionStatus status = point.Has("positionStatus")
                                    ? point.Named("positionStatus", Statuses)
                                    : PositionStatus::Defined;
    if (status != PositionStatus::Defined || !point.Has("position"))
      ++notPlaced;
    else
    {
      placed.points.push_back(point.Vector("position") * scale + 0.0); // no -0
      placed.places.push_back(place);
    }
  }
  if (placed.points.empty())
    read.Fail("controlPoints", "has no point with a place; place one, or take the markup out");
  return placed;
}

SlicerMarkup ReadMarkup(const Json& json, const std::string& subject, const std::string& name,
  double radiusMm, std::size_t& notPlaced)
{
  const StrictJson read(json, subject, name);
  SlicerMarkup markup;
  const MarkupType type = read.Named("type", Types);
  if (read.Has("name"))
    markup.name.name = read.Text("name");
  if (read.Has("display"))
    ReadDisplay(StrictJson(read.Get("display"), subject, name + ".display"), markup, radiusMm);
  auto [points, places] = ReadPoints(read, subject, name, markup, notPlaced);
  if (type == MarkupType::Fiducial)
  {
    for (const glm::dvec3& point : points)
      markup.strokes.push_back({ 0, radiusMm, { point } });
    markup.places = std::move(places);
  }
  else
  {
    if (type == MarkupType::ClosedCurve && points.size() > 1)
      points.push_back(points.front());
    markup.strokes.push_back({ 0, radiusMm, std::move(points) });
    markup.places.push_back(name);
  }
  // Said here, where the markup is known, and not of the seeds that are made of it.
  ValueChecks(subject).Text(name + ".name", markup.name.name);
  for (const BrushStroke& stroke : markup.strokes)
    ValidateBrushStroke(stroke, subject + ": " + name + ".controlPoints", 0);
  return markup;
}

/// One label's colour and its strokes' width, as Slicer has them.
Json DisplayJson(const std::array<std::uint8_t, 3>& colour, double radiusMm)
{
  const Json shares = { colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0 };
  return { { "visibility", true }, { "opacity", 1.0 }, { "color", shares },
    { "selectedColor", shares }, { "propertiesLabelVisibility", false },
    { "pointLabelsVisibility", false }, { "glyphType", "Sphere3D" },
    { "glyphSize", 2.0 * radiusMm }, { "useGlyphScale", false }, { "lineThickness", 1.0 } };
}

Json PointJson(const glm::dvec3& point, std::size_t number, std::uint16_t label)
{
  return { { "id", std::to_string(number) }, { "label", "" },
    { "description", LabelMark + std::to_string(label) }, { "position", ToJson(point) },
    { "selected", true }, { "locked", false }, { "visibility", true },
    { "positionStatus", "defined" } };
}
} // namespace

bool IsMarkups(const Json& json)
{
  return json.is_object() && json.contains("markups");
}

void ReadMarkups(const Json& json, const std::string& subject, double radiusMm,
  std::vector<SlicerMarkup>& markups, std::size_t& notPlaced)
{
  const StrictJson file(json, subject, "");
  CheckSchema(file);
  std::size_t number = 0;
  for (const Json& markup : file.List("markups", MostMarkups))
    markups.push_back(
      ReadMarkup(markup, subject, ListKey("markups", number++), radiusMm, notPlaced));
  if (number == 0)
    file.Fail("markups", "must have at least one entry");
}

Seeds SeedsOfMarkups(std::vector<SlicerMarkup> markups, std::uint16_t firstLabel)
{
  std::set<std::uint16_t> given;
  std::map<std::string, std::uint16_t> named;
  for (const SlicerMarkup& markup : markups)
    if (markup.label != 0)
    {
      given.insert(markup.label);
      if (!markup.name.name.empty())
        named.emplace(markup.name.name, markup.label);
    }
  Seeds seeds;
  std::uint32_t next = firstLabel;
  for (SlicerMarkup& markup : markups)
  {
    const auto same = named.find(markup.name.name);
    if (markup.label == 0 && !markup.name.name.empty() && same != named.end())
      markup.label = same->second;
    if (markup.label == 0)
    {
      while (given.contains(std::uint16_t(next)) && next <= 65535)
        ++next;
      if (next > 65535)
        throw std::invalid_argument("markups: there are no numbers left below 65536; begin with a "
                                    "smaller label, or give fewer markups");
      markup.label = std::uint16_t(next++);
      if (!markup.name.name.empty())
        named.emplace(markup.name.name, markup.label);
    }
    markup.name.label = markup.label;
    const auto known = std::find_if(seeds.names.begin(), seeds.names.end(),
      [&](const LabelName& name) { return name.label == markup.label; });
    if (known == seeds.names.end())
      seeds.names.push_back(markup.name);
    else if (known->name.empty())
      known->name = markup.name.name;
    for (BrushStroke& stroke : markup.strokes)
    {
      stroke.label = markup.label;
      seeds.strokes.push_back(std::move(stroke));
    }
    std::move(markup.places.begin(), markup.places.end(), std::back_inserter(seeds.places));
  }
  return seeds;
}

Json MarkupsToJson(const Seeds& seeds)
{
  ValidateSeeds(seeds);
  Json markups = Json::array();
  for (std::size_t n = 0; n < seeds.strokes.size();)
  {
    const BrushStroke& stroke = seeds.strokes[n];
    const bool dots = stroke.points.size() == 1;
    const auto name = std::find_if(seeds.names.begin(), seeds.names.end(),
      [&](const LabelName& one) { return one.label == stroke.label; });
    Json points = Json::array();
    const auto add = [&](const BrushStroke& from)
    {
      for (const glm::dvec3& point : from.points)
        points.push_back(PointJson(point, points.size() + 1, from.label));
      ++n;
    };
    add(stroke);
    while (dots && n < seeds.strokes.size() && seeds.strokes[n].points.size() == 1 &&
           seeds.strokes[n].label == stroke.label && seeds.strokes[n].radiusMm == stroke.radiusMm)
      add(seeds.strokes[n]);
    Json markup = { { "type", dots ? "Fiducial" : "Curve" } };
    if (!name->name.empty())
      markup["name"] = name->name;
    markup.update({ { "coordinateSystem", "LPS" }, { "coordinateUnits", "mm" }, { "locked", false },
      { "controlPoints", std::move(points) },
      { "display", DisplayJson(name->colour, stroke.radiusMm) } });
    markups.push_back(std::move(markup));
  }
  return { { "@schema", Schema }, { "markups", std::move(markups) } };
}

} // namespace hasp
