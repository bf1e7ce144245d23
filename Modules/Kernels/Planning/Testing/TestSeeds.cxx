#include "Planning/SeedsFile.h"
#include "RandomSegmentation.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace
{
using namespace hasp;

/// The message; none may tell a text of the file.
template <typename Work>
std::string Fault(Work work)
{
  try
  {
    work();
    return "";
  }
  catch (const std::exception& error)
  {
    EXPECT_EQ(std::string(error.what()).find("rika"), std::string::npos) << error.what();
    return error.what();
  }
}

Seeds Valid()
{
  return { { { 2, "Erika", { 255, 0, 51 } }, { 7, "", { 1, 2, 3 } } },
    { { 2, 1.5, { { 1, 2, 3 }, { 4, 5, 6.25 } } }, { 2, 2.0, { { 0, 0, 0 } } },
      { 7, 2.0, { { -9, 0, 0 } } }, { 7, 2.0, { { 8, 0, 0 } } }, { 7, 1.0, { { 9, 0, 0 } } } } };
}

/// Labels in order, so that files keep the order of the strokes.
Seeds Random(RandomSegmentation& make, std::mt19937& random)
{
  Seeds seeds;
  std::uint16_t label = 0;
  for (int labels = int(random() % 4); labels > 0; --labels)
  {
    label = std::uint16_t(label + 1 + random() % 9);
    seeds.names.push_back({ label, "name " + std::to_string(label), make.Colour() });
    for (int n = 1 + int(random() % 4); n > 0; --n)
    {
      seeds.strokes.push_back(make.Stroke(1));
      seeds.strokes.back().label = label;
      for (glm::dvec3& point : seeds.strokes.back().points)
        point += 0.0; // -0 comes back as 0, which is equal
    }
  }
  return seeds;
}

/// A file of Slicer's with one markup, as 5.6 writes it but for what we do not look at.
std::string Markups(const std::string& type, const std::string& points,
  const std::string& more = R"("coordinateSystem": "LPS", "coordinateUnits": "mm")")
{
  return R"({"@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/)"
         R"(Markups/Resources/Schema/markups-schema-v1.0.3.json#", "markups": [{"type": ")" +
         type + "\", " + more + R"(, "locked": false, "labelFormat": "Erika-%d", "measurements": [],
         "controlPoints": [)" +
         points + "]}]}";
}

/// As 5.6 writes it; labels and descriptions are the user's words.
std::string Point(const std::string& position, const std::string& status = "defined",
  const std::string& description = "Erika")
{
  return R"({"id": "1", "label": "Erika Mustermann", "description": ")" + description +
         R"(", "associatedNodeID": "", "position": )" + position +
         R"(, "orientation": [-1.0, -0.0, -0.0, -0.0, -1.0, -0.0, 0.0, 0.0, 1.0],
         "selected": true, "locked": false, "visibility": true, "positionStatus": ")" +
         status + "\"}";
}

std::string Refusal(const std::string& text)
{
  return Fault([&] { ParseAnySeeds({ text }); });
}

std::string Changed(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Seeds, AThousandSurviveTheRoundTripThroughBothFormats)
{
  std::mt19937 random(4);
  RandomSegmentation make(random);
  for (int n = 0; n < 1000; ++n)
  {
    const Seeds seeds = Random(make, random);
    ASSERT_EQ(ParseSeeds(FormatSeeds(seeds)), seeds) << n;
    ASSERT_EQ(ParseAnySeeds({ FormatSeeds(seeds) }), seeds) << n;
    if (!seeds.strokes.empty())
    {
      ASSERT_EQ(ParseAnySeeds({ FormatMarkups(seeds) }), seeds) << n;
    }
  }
  EXPECT_EQ(ParseAnySeeds({ FormatMarkups(Valid()) }), Valid());
}

TEST(Seeds, StrokesAreKeptInTheOrderOfTheirLabels)
{
  Seeds seeds = Valid();
  std::swap(seeds.strokes[0], seeds.strokes[2]);
  const Seeds back = ParseSeeds(FormatSeeds(seeds));
  std::stable_sort(seeds.strokes.begin(), seeds.strokes.end(),
    [](const BrushStroke& a, const BrushStroke& b) { return a.label < b.label; });
  EXPECT_EQ(back, seeds);
}

TEST(Seeds, EachStrokeSaysWhereItStandsInItsFile)
{
  using Places = std::vector<std::string>;
  EXPECT_EQ(ParseSeeds(FormatSeeds(Valid())).places,
    (Places{ "labels[0].strokes[0]", "labels[0].strokes[1]", "labels[1].strokes[0]",
      "labels[1].strokes[1]", "labels[1].strokes[2]" }));
  const std::string points =
    Point("[1, 2, 3]") + "," + Point("[0, 0, 0]", "undefined") + "," + Point("[4, 5, 6]");
  EXPECT_EQ(ParseAnySeeds({ Markups("Fiducial", points) }).places,
    (Places{ "markups[0].controlPoints[0]", "markups[0].controlPoints[2]" }));
  EXPECT_EQ(ParseAnySeeds({ Markups("Curve", points), Markups("Line", points) }).places,
    (Places{ "file 1: markups[0]", "file 2: markups[0]" }));
  EXPECT_TRUE(Valid().places.empty());
}

TEST(Seeds, OurOwnFileIsReadStrictly)
{
  const std::string text = FormatSeeds(Valid());
  const auto fault = [&](const std::string& from, const std::string& to)
  { return Refusal(Changed(text, from, to)); };
  EXPECT_EQ(fault("\"radiusMm\"", "\"Erika\"")
              .find("seeds: a key of labels[0].strokes[0] is unknown, the nearest known is "),
    0U);
  EXPECT_EQ(fault("1.5", "\"Erika\""), "seeds: labels[0].strokes[0].radiusMm must be a number");
  EXPECT_EQ(fault("1.5", "51"), "seeds: labels[0].strokes[0]: radiusMm is 51, must be in (0, 50]");
  EXPECT_EQ(fault("1.5", "nan").find("seeds: no JSON: a mistake at byte"), 0U);
  EXPECT_EQ(fault("6.25", "1e999"), "seeds: no JSON: a number is too large for any double");
  EXPECT_EQ(fault("6.25", "1e9"),
    "seeds: labels[0].strokes[0]: points[1][2] is 1e+09, must be in [-4000, 4000] mm");
  EXPECT_EQ(
    fault("\"label\": 7", "\"label\": 2"), "seeds: labels[1].label is 2, must be named once");
  EXPECT_EQ(fault("\"label\": 7", "\"label\": 0"),
    "seeds: labels[1].label must be a whole number in [1, 65535]");
  EXPECT_EQ(fault("#ff0033", "Erika"),
    "seeds: labels[0].colour must be # and six hexadecimal digits in lower case");
  EXPECT_EQ(fault("hasp-seeds-1", "hasp-segmentation-1"),
    "seeds: format is of another kind: the file is a segmentation recipe, which hasp segment "
    "--recipe takes; here it must be 'hasp-seeds-1'");
  EXPECT_EQ(Refusal("{\"Erika\": 1}"),
    "seeds: the file is of no kind that is known: it has neither a format, 'hasp-seeds-1', nor "
    "markups, as Slicer's .mrk.json");
  EXPECT_EQ(Refusal("[]"), "seeds: the whole must be an object");
  for (std::size_t size = 0; size + 1 < text.size(); ++size)
    ASSERT_NE(Refusal(text.substr(0, size)), "") << size;
}

TEST(Seeds, WhatCouldNotBeReadAgainIsNotWritten)
{
  Seeds seeds = Valid();
  seeds.strokes[2].label = 3;
  EXPECT_EQ(
    Fault([&] { FormatSeeds(seeds); }), "seeds: strokes[2].label is 3, must be one of the names'");
  seeds = Valid();
  seeds.strokes[0].radiusMm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(
    Fault([&] { FormatMarkups(seeds); }), "seeds: strokes[0]: radiusMm is nan, must be in (0, 50]");
  seeds = Valid();
  seeds.names[0].name = "Erika\n";
  EXPECT_EQ(Fault([&] { FormatSeeds(seeds); }),
    "seeds: names[0].name holds a control character or is not UTF-8");
}

TEST(SlicerMarkups, AListOfPointsIsADotEach)
{
  const Seeds seeds = ParseAnySeeds(
    { Markups("Fiducial", Point("[1, 2, 3]") + "," + Point("\"\"", "undefined") + "," +
                            Point("[4, 5, 6]") + "," + Point("[7, 8, 9]", "preview")) });
  EXPECT_EQ(seeds.names, (std::vector<LabelName>{ { 2, "" } }));
  EXPECT_EQ(seeds.strokes,
    (std::vector<BrushStroke>{ { 2, 2.0, { { 1, 2, 3 } } }, { 2, 2.0, { { 4, 5, 6 } } } }));
  EXPECT_EQ(seeds.notPlaced, 2U);
}

TEST(SlicerMarkups, LinesAndCurvesAreAStrokeEach)
{
  const std::string points =
    Point("[0, 0, 0]") + "," + Point("[10, 0, 0]") + "," + Point("[10, 10, 0]");
  MarkupsChoices choices;
  choices.radiusMm = 1.25;
  choices.firstLabel = 5;
  const std::vector<glm::dvec3> open = { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 10, 0 } };
  std::vector<glm::dvec3> closed = open;
  closed.emplace_back(0, 0, 0);
  for (const char* type : { "Line", "Curve", "ClosedCurve" })
  {
    const Seeds seeds = ParseAnySeeds({ Markups(type, points) }, choices);
    ASSERT_EQ(seeds.strokes.size(), 1U);
    EXPECT_EQ(seeds.strokes[0],
      (BrushStroke{ 5, 1.25, std::string(type) == "ClosedCurve" ? closed : open }));
  }
  for (const char* type : { "Angle", "Plane", "ROI", "Erika" })
    EXPECT_EQ(Refusal(Markups(type, points)),
      "seeds: markups[0].type must be Fiducial, Line, Curve or ClosedCurve");
}

TEST(SlicerMarkups, SpaceAndUnitAreTurnedIntoLpsAndMm)
{
  const auto place = [](const std::string& more) {
    return ParseAnySeeds({ Markups("Fiducial", Point("[1, -2, 3]"), more) }).strokes[0].points[0];
  };
  const glm::dvec3 same(1, -2, 3), turned(-1, 2, 3);
  EXPECT_EQ(place(R"("coordinateSystem": "LPS")"), same);
  EXPECT_EQ(place(R"("coordinateSystem": "1")"), same);
  EXPECT_EQ(place(R"("display": {})"), same); // Slicer takes it for LPS, too
  EXPECT_EQ(place(R"("coordinateSystem": "RAS")"), turned);
  EXPECT_EQ(place(R"("coordinateSystem": "0", "coordinateUnits": "mm")"), turned);
  EXPECT_EQ(place(R"("coordinateUnits": ["mm", "UCUM", "millimeter"])"), same);
  EXPECT_EQ(place(R"("coordinateUnits": "um")"), same * 1e-3);
  const auto refused = [](const std::string& more)
  { return Refusal(Markups("Fiducial", Point("[1, -2, 3]"), more)); };
  EXPECT_EQ(refused(R"("coordinateSystem": "Erika")"),
    "seeds: markups[0].coordinateSystem must be LPS, RAS, 1 or 0");
  EXPECT_EQ(
    refused(R"("coordinateUnits": "Erika")"), "seeds: markups[0].coordinateUnits must be mm or um");
  EXPECT_EQ(refused(R"("coordinateUnits": ["cm", "UCUM", "Erika"])"),
    "seeds: markups[0].coordinateUnits must be mm or um");
  EXPECT_EQ(refused(R"("coordinateUnits": 1)"), "seeds: markups[0].coordinateUnits must be text");
}

TEST(SlicerMarkups, ColourAndSizeAreTheDisplays)
{
  const auto read = [](const std::string& display)
  {
    return ParseAnySeeds(
      { Markups("Fiducial", Point("[0, 0, 0]"), "\"display\": {" + display + "}") });
  };
  Seeds seeds = read(R"("color": [0.4, 1, 0], "glyphSize": 5, "useGlyphScale": true)");
  EXPECT_EQ(seeds.names[0].colour, (std::array<std::uint8_t, 3>{ 102, 255, 0 }));
  EXPECT_EQ(seeds.strokes[0].radiusMm, 2.0); // glyphs are as large as the window says
  seeds = read(R"("color": [0.4, 1, 0], "selectedColor": [0, 0.2, 1], "glyphSize": 5,
    "useGlyphScale": false)");
  EXPECT_EQ(seeds.names[0].colour, (std::array<std::uint8_t, 3>{ 0, 51, 255 }));
  EXPECT_EQ(seeds.strokes[0].radiusMm, 2.5);
  EXPECT_EQ(read("").names[0].colour, LabelName{}.colour);
  const auto refused = [&](const std::string& display) { return Fault([&] { read(display); }); };
  EXPECT_EQ(refused(R"("color": [0.4, 1.1, 0])"),
    "seeds: markups[0].display.color must be three numbers in [0, 1]");
  EXPECT_EQ(
    refused(R"("color": "Erika")"), "seeds: markups[0].display.color must be three numbers");
  EXPECT_EQ(refused(R"("glyphSize": 101, "useGlyphScale": false)"),
    "seeds: markups[0].display.glyphSize must be in (0, 100] mm: it is the brush's diameter");
}

/// The markups of files, their labels, and their names.
TEST(SlicerMarkups, EachIsALabelUnlessItSaysWhich)
{
  const auto file = [](const std::string& description, const std::string& name = "")
  {
    return Markups("Fiducial", Point("[0, 0, 0]", "defined", description),
      name.empty() ? "\"opacity\": 1" : "\"name\": \"" + name + "\"");
  };
  const auto labels = [](const std::vector<std::string>& files)
  {
    std::string text;
    const Seeds seeds = ParseAnySeeds(files);
    for (const BrushStroke& stroke : seeds.strokes)
      text += std::to_string(stroke.label) + " ";
    for (const LabelName& name : seeds.names)
      text += "(" + std::to_string(name.label) + " " + name.name + ")";
    return text;
  };
  EXPECT_EQ(labels({ file(""), file(""), file("") }), "2 3 4 (2 )(3 )(4 )");
  EXPECT_EQ(labels({ file("Hasp label 3"), file(""), file("Hasp label 3"), file("") }),
    "3 2 3 4 (3 )(2 )(4 )");
  EXPECT_EQ(labels({ file("", "ramus"), file("", "condyle"), file("", "ramus") }),
    "2 3 2 (2 ramus)(3 condyle)");
  EXPECT_EQ(labels({ file("", "ramus"), file("Hasp label 9", "ramus") }), "9 9 (9 ramus)");
  for (const char* none : { "Hasp label 65536", "Hasp label ", "Hasp label 3x", "hasp label 3" })
    EXPECT_EQ(labels({ file(none) }), "2 (2 )") << none;
  MarkupsChoices last;
  last.firstLabel = 65535;
  EXPECT_EQ(Fault(
              [&] {
                ParseAnySeeds({ file(""), file("") }, last);
              }),
    "markups: there are no numbers left below 65536; begin with a smaller label, or give fewer "
    "markups");
}

TEST(SlicerMarkups, WhatIsNoMarkupsFileIsRefusedByItsKey)
{
  const std::string sound = Markups("Curve", Point("[1, 2, 3]") + "," + Point("[4, 5, 6]"));
  const auto fault = [&](const std::string& from, const std::string& to)
  { return Refusal(Changed(sound, from, to)); };
  EXPECT_EQ(Refusal(sound), "");
  EXPECT_EQ(fault("markups-schema-v1.0.3", "markups-schema-v2.0.0"),
    "seeds: @schema must be one of Slicer's markups-schema-v1.x: save the markups as .mrk.json "
    "again with Slicer 4.11 to 5");
  EXPECT_EQ(fault("[4, 5, 6]", "[4, 5]"),
    "seeds: markups[0].controlPoints[1].position must be three numbers");
  EXPECT_EQ(fault("[4, 5, 6]", "[4, 5, \"Erika\"]"),
    "seeds: markups[0].controlPoints[1].position must be a number");
  EXPECT_EQ(fault("[4, 5, 6]", "[4, 5, 6e9]"),
    "seeds: markups[0].controlPoints: points[1][2] is 6e+09, must be in [-4000, 4000] mm");
  EXPECT_EQ(fault("\"defined\"", "\"Erika\""),
    "seeds: markups[0].controlPoints[0].positionStatus must be defined, undefined, preview or "
    "missing");
  EXPECT_EQ(fault("\"type\"", "\"Erika\""), "seeds: markups[0].type is missing");
  EXPECT_EQ(fault("\"controlPoints\"", "\"Erika\""), "seeds: markups[0].controlPoints is missing");
  EXPECT_EQ(Refusal(Markups("Curve", Point("\"\"", "undefined"))),
    "seeds: markups[0].controlPoints has no point with a place; place one, or take the markup out");
  EXPECT_EQ(Refusal(R"({"markups": []})"), "seeds: markups must have at least one entry");
  EXPECT_EQ(Refusal(R"({"markups": "Erika"})"), "seeds: markups must be a list");
  EXPECT_EQ(Refusal(R"({"markups": ["Erika"]})"), "seeds: markups[0] must be an object");
  EXPECT_EQ(Refusal(Markups("Curve", Point("[1, 2, 3]"), R"("name": "Erika\n")")),
    "seeds: markups[0].name holds a control character or is not UTF-8");
  for (std::size_t size = 0; size < sound.size(); ++size)
    ASSERT_NE(Refusal(sound.substr(0, size)), "") << size;
}

TEST(SlicerMarkups, SeveralFilesAreToldApartByTheirNumbers)
{
  const std::string sound = Markups("Curve", Point("[1, 2, 3]"));
  EXPECT_EQ(Fault([&] { ParseAnySeeds({ sound, "{" }); }).find("seeds: file 2: no JSON"), 0U);
  EXPECT_EQ(Fault(
              [&] {
                ParseAnySeeds({ sound, FormatSeeds(Valid()) });
              }),
    "seeds: file 2: format is 'hasp-seeds-1', which holds all labels: give it alone");
  EXPECT_EQ(Fault([] { ParseAnySeeds({}); }), "seeds: the files are none; give one or more");
  EXPECT_EQ(Fault(
              [&] {
                ParseAnySeeds({ sound }, { 0.0, 2 });
              }),
    "seeds: radiusMm is 0, must be in (0, 50]");
  EXPECT_EQ(Fault(
              [&] {
                ParseAnySeeds({ sound }, { 1.0, 0 });
              }),
    "seeds: firstLabel is 0, must be in [1, 65535]");
}

TEST(Seeds, ComeBackFromTheDisk)
{
  const std::filesystem::path folder =
    std::filesystem::path(testing::TempDir()) / ("Erika-seeds-" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const std::string own = folder / "seeds.json", slicer = folder / "Erika.mrk.json";
  WriteSeeds(own, Valid());
  WriteMarkups(slicer, Valid());
  EXPECT_EQ(ReadSeeds({ own }), Valid());
  EXPECT_EQ(ReadSeeds({ slicer }), Valid());
  EXPECT_EQ(Fault(
              [&] {
                ReadSeeds({ slicer, folder / "no.json" });
              }),
    "seeds: file 2: the file is not there");
  EXPECT_EQ(Fault([&] { WriteSeeds(folder / "no" / "seeds.json", Valid()); }),
    "seeds: the file cannot be written: No such file or directory");
  std::filesystem::remove_all(folder);
}

} // namespace
