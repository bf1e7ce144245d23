#include "Planning/SegmentationRecipe.h"
#include "Planning/SegmentationRecipeFile.h"
#include "RandomSegmentation.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
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

/// A step of each kind, in the order of the variant, and a name.
SegmentationRecipe Valid()
{
  const BrushStroke stroke{ 2, 1.5, { { 1, 2, 3 }, { 4, 5, 6.25 } } };
  SegmentationRecipe recipe;
  recipe.steps = { GaussianStep{}, MedianStep{}, EdgePreservingStep{}, ConeBeamStep{},
    ThresholdStep{}, SplitStep{ 1, { stroke, { 3, 2.0, { { 0, 0, 0 } } } } }, PaintStep{ stroke },
    MergeStep{}, ComponentsStep{}, FillStep{}, MorphologyStep{} };
  recipe.names = { { 2, "Erika", { 1, 2, 255 } } };
  return recipe;
}

/// What the recipe is refused with when the step of kind T is changed so.
template <typename T, typename Change>
std::string Spoilt(Change change)
{
  SegmentationRecipe recipe = Valid();
  for (SegmentationStep& step : recipe.steps)
    if (T* found = std::get_if<T>(&step))
      change(*found);
  return Fault([&] { ValidateSegmentationRecipe(recipe); });
}

const double nan = std::numeric_limits<double>::quiet_NaN(),
             infinite = std::numeric_limits<double>::infinity();

TEST(SegmentationRecipe, EveryNumberOfAFilterOutOfItsRangeIsNamed)
{
  const std::string begin = "segmentation recipe: steps[";
  EXPECT_EQ(Fault([] { ValidateSegmentationRecipe(Valid()); }), "");
  EXPECT_EQ(Fault([] { ValidateSegmentationRecipe({}); }), "");
  EXPECT_EQ(Spoilt<GaussianStep>([](auto& s) { s.sigmaMm = 0; }),
    begin + "0]: sigmaMm is 0, must be in (0, 10]");
  EXPECT_EQ(Spoilt<GaussianStep>([](auto& s) { s.sigmaMm = nan; }),
    begin + "0]: sigmaMm is nan, must be in (0, 10]");
  EXPECT_EQ(Spoilt<MedianStep>([](auto& s) { s.radiusMm = 10.1; }),
    begin + "1]: radiusMm is 10.1, must be in (0, 10]");
  EXPECT_EQ(Spoilt<EdgePreservingStep>([](auto& s) { s.edge = infinite; }),
    begin + "2]: edge is inf, must be in (0, 1e+06]");
  EXPECT_EQ(Spoilt<EdgePreservingStep>([](auto& s) { s.iterations = 101; }),
    begin + "2]: iterations is 101, must be in [1, 100]");
  EXPECT_EQ(Spoilt<ConeBeamStep>([](auto& s) { s.fieldMm = 9; }),
    begin + "3]: fieldMm is 9, must be in [10, 500]");
  for (const double bad : { -1.0, 4.9, 101.0, nan })
    EXPECT_NE(Spoilt<ConeBeamStep>([=](auto& s) { s.contrastMm = bad; })
                .find("3]: contrastMm is " + std::string(std::isnan(bad) ? "nan" : "")),
      std::string::npos);
  EXPECT_EQ(Spoilt<ConeBeamStep>([](auto& s) { s.contrastMm = 5; }), "");
  EXPECT_EQ(Spoilt<ConeBeamStep>([](auto& s) { s.insideAbove = -2e6; }),
    begin + "3]: insideAbove is -2e+06, must be in [-1e+06, 1e+06]");
}

TEST(SegmentationRecipe, EveryNumberOfAStepOutOfItsRangeIsNamed)
{
  const std::string begin = "segmentation recipe: steps[";
  EXPECT_EQ(Spoilt<ThresholdStep>([](auto& s) { s.highest = 225; }),
    begin + "4]: highest is 225, must be in [226, 1e+06]");
  EXPECT_EQ(Spoilt<ThresholdStep>([](auto& s) { s.lowest = nan; }),
    begin + "4]: lowest is nan, must be in [-1e+06, 1e+06]");
  EXPECT_EQ(Spoilt<ThresholdStep>([](auto& s) { s.smoothMm = -1; }),
    begin + "4]: smoothMm is -1, must be in [0, 10]");
  EXPECT_EQ(Spoilt<SplitStep>([](auto& s) { s.label = 0; }),
    begin + "5]: label is 0, must be in [1, 65535]");
  EXPECT_EQ(Spoilt<SplitStep>([](auto& s) { s.beta = -1; }),
    begin + "5]: beta is -1, must be in [0, 1e+12]");
  EXPECT_EQ(Spoilt<SplitStep>([](auto& s) { s.crack = 1.5; }),
    begin + "5]: crack is 1.5, must be in [0, 1]");
  EXPECT_EQ(
    Spoilt<SplitStep>([](auto& s) { s.norm = 2.5; }), begin + "5]: norm is 2.5, must be in [1, 2]");
  EXPECT_EQ(Spoilt<SplitStep>([](auto& s) { s.strokes[1].label = 0; }),
    begin + "5].strokes[1]: label is 0, must be in [1, 65535]");
  EXPECT_EQ(Spoilt<SplitStep>([](auto& s) { s.strokes[1].radiusMm = 51; }),
    begin + "5].strokes[1]: radiusMm is 51, must be in (0, 50]");
  EXPECT_EQ(Spoilt<SplitStep>([](auto& s) { s.strokes[0].points.clear(); }),
    begin + "5].strokes[0]: the number of points is 0, must be in [1, 100000]");
  EXPECT_EQ(Spoilt<SplitStep>([](auto& s) { s.strokes[0].points.resize(100'001); }),
    begin + "5].strokes[0]: the number of points is 100001, must be in [1, 100000]");
  EXPECT_EQ(Spoilt<SplitStep>([](auto& s) { s.strokes[0].points[1].y = nan; }),
    begin + "5].strokes[0]: points[1][1] is nan, must be in [-4000, 4000] mm");
  EXPECT_EQ(Spoilt<SplitStep>([](auto& s) { s.strokes.resize(10'001, s.strokes[0]); }),
    begin + "5]: the number of strokes is 10001, must be in [0, 10000]");
  EXPECT_EQ(Spoilt<SplitStep>([](auto& s) { s.strokes.clear(); }), "");
  EXPECT_EQ(Spoilt<PaintStep>([](auto& s) { s.stroke.label = 0; }), ""); // erases
  EXPECT_EQ(Spoilt<PaintStep>([](auto& s) { s.stroke.points[0].z = -4001; }),
    begin + "6].stroke: points[0][2] is -4001, must be in [-4000, 4000] mm");
  EXPECT_EQ(
    Spoilt<MergeStep>([](auto& s) { s.from = 0; }), begin + "7]: from is 0, must be in [1, 65535]");
  EXPECT_EQ(Spoilt<MergeStep>([](auto& s) { s.into = 2; }),
    begin + "7]: into is 2, must be another label than from");
  EXPECT_EQ(Spoilt<MergeStep>([](auto& s) { s.into = 0; }), "");
  EXPECT_EQ(Spoilt<ComponentsStep>([](auto& s) { s.leastMm3 = 2e9; }),
    begin + "8]: leastMm3 is 2e+09, must be in [0, 1e+09]");
  EXPECT_EQ(Spoilt<ComponentsStep>([](auto& s) { s.label = 0; }),
    begin + "8]: label is 0, must be in [1, 65535]");
  EXPECT_EQ(Spoilt<FillStep>([](auto& s) { s.label = 0; }),
    begin + "9]: label is 0, must be in [1, 65535]");
  EXPECT_EQ(Spoilt<MorphologyStep>([](auto& s) { s.label = 0; }),
    begin + "10]: label is 0, must be in [1, 65535]");
  EXPECT_EQ(Spoilt<MorphologyStep>([](auto& s) { s.radiusMm = 0; }),
    begin + "10]: radiusMm is 0, must be in (0, 50]");
  EXPECT_EQ(Spoilt<MorphologyStep>([](auto& s) { s.operation = Morphology(4); }),
    begin + "10]: operation is 4, must be one of the four that there are");
}

TEST(SegmentationRecipe, FiltersStandFirstAndLabelsAreNamedOnce)
{
  SegmentationRecipe recipe = Valid();
  const auto fault = [&] { return Fault([&] { ValidateSegmentationRecipe(recipe); }); };
  recipe.steps.emplace_back(MedianStep{});
  EXPECT_EQ(
    fault(), "segmentation recipe: steps[11] is a filter, which must stand before all other steps");
  recipe.steps.resize(10'001, FillStep{});
  EXPECT_EQ(fault(), "segmentation recipe: the number of steps is 10001, must be in [0, 10000]");
  recipe.steps.clear();
  recipe.names.push_back({ 2, "Erika", {} });
  EXPECT_EQ(fault(), "segmentation recipe: names[1].label is 2, must be named once");
  recipe.names[1].label = 0;
  EXPECT_EQ(fault(), "segmentation recipe: names[1].label is 0, must be in [1, 65535]");
  recipe.names[1] = { 3, "Erika\n", {} };
  EXPECT_EQ(
    fault(), "segmentation recipe: names[1].name holds a control character or is not UTF-8");
}

TEST(SegmentationRecipe, StepsSayWhatTheyDo)
{
  std::string labels;
  for (const SegmentationStep& step : Valid().steps)
    labels += StepLabel(step) + "; ";
  EXPECT_EQ(labels,
    "Gaussian filter; Median filter; Edge-preserving filter; Cone-beam correction; Threshold; "
    "Split label 1; Paint label 2; Merge label 2 into 1; Pieces of label 1; Fill cavities of label "
    "1; Dilate label 1; ");
  EXPECT_EQ(StepLabel(PaintStep{ { 0, 1.0, {} } }), "Erase");
  EXPECT_EQ(StepLabel(MergeStep{ 2, 0 }), "Remove label 2");
  EXPECT_EQ(StepLabel(ComponentsStep{ 2, 0, true }), "Keep the largest piece of label 2");
  EXPECT_EQ(StepLabel(MorphologyStep{ 2, Morphology::Close }), "Close label 2");
}

TEST(SegmentationRecipe, AThousandRandomRecipesSurviveTheRoundTrip)
{
  std::mt19937 random(1);
  RandomSegmentation make(random);
  for (int n = 0; n < 1000; ++n)
  {
    const SegmentationRecipe recipe = make.Recipe(8, "a \"name\" \xc3\xa4");
    ASSERT_EQ(Fault([&] { ValidateSegmentationRecipe(recipe); }), "") << n;
    const std::string text = FormatSegmentationRecipe(recipe);
    const SegmentationRecipe back = ParseSegmentationRecipe(text);
    ASSERT_EQ(back, recipe) << n;
    ASSERT_EQ(FormatSegmentationRecipe(back), text) << n;
  }
}

TEST(SegmentationRecipe, AFileIsReadStrictly)
{
  const std::string text = FormatSegmentationRecipe(Valid());
  EXPECT_EQ(ParseSegmentationRecipe(text), Valid());
  EXPECT_NE(text.find("[4.0, 5.0, 6.25]"), std::string::npos) << text; // a point is a line
  const auto fault = [&](const std::string& from, const std::string& to)
  {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    return Fault([&] { ParseSegmentationRecipe(changed); });
  };
  const std::string begin = "segmentation recipe: ";
  EXPECT_EQ(fault("sigmaMm", "sigmaErikaMm"),
    begin + "a key of steps[0] is unknown, the nearest known is 'sigmaMm'; mend its spelling or "
            "take it out (line 6)");
  EXPECT_EQ(fault("0.5", "\"Erika\""), begin + "steps[0].sigmaMm must be a number");
  EXPECT_EQ(fault("0.5", "null"), begin + "steps[0].sigmaMm must be a number");
  EXPECT_EQ(fault("0.5", "NaN").find(begin + "no JSON: a mistake at byte"), 0U);
  EXPECT_EQ(fault("0.5", "1e999"), begin + "no JSON: a number is too large for any double");
  EXPECT_EQ(fault("0.5", "1e300"), begin + "steps[0]: sigmaMm is 1e+300, must be in (0, 10]");
  EXPECT_EQ(fault("\"gaussian\"", "\"Erika\""),
    begin + "steps[0].step must be gaussian, median, edge-preserving, cone-beam-correction, "
            "threshold, split, paint, merge, components, fill or morphology");
  EXPECT_EQ(fault("\"step\": \"gaussian\",", ""), begin + "steps[0].step is missing");
  EXPECT_EQ(fault("\"gaussian\"", "7"), begin + "steps[0].step must be text");
  EXPECT_EQ(fault("\"dilate\"", "\"Erika\""),
    begin + "steps[10].operation must be dilate, erode, open or close");
  EXPECT_EQ(fault("\"iterations\": 4", "\"iterations\": 4.5"),
    begin + "steps[2].iterations must be a whole number in [1, 100]");
  EXPECT_EQ(fault("\"label\": 1", "\"label\": 65536"),
    begin + "steps[5].label must be a whole number in [1, 65535]");
  EXPECT_EQ(fault("\"only\": 0", "\"only\": -1"),
    begin + "steps[6].only must be a whole number in [0, 65535]");
  EXPECT_EQ(fault("[4.0, 5.0, 6.25]", "[4.0, 5.0]"),
    begin + "steps[5].strokes[0].points[1] must be three numbers");
  EXPECT_EQ(fault("[4.0, 5.0, 6.25]", "[4.0, 5.0, null]"),
    begin + "steps[5].strokes[0].points[1] must be a number");
  EXPECT_EQ(fault("\"keepLargestAlone\": false", "\"keepLargestAlone\": 0"),
    begin + "steps[8].keepLargestAlone must be true or false");
  EXPECT_EQ(fault("#0102ff", "#Erika!"),
    begin + "names[0].colour must be # and six hexadecimal digits in lower case");
  EXPECT_EQ(fault("hasp-segmentation-1", "hasp-segmentation-2"),
    begin + "format is of another version, must be 'hasp-segmentation-1'");
  EXPECT_EQ(fault("hasp-segmentation-1", "hasp-cut-recipe-1"),
    begin + "format is of another kind: the file is a cut recipe, which hasp cut --cuts takes; "
            "here it must be 'hasp-segmentation-1'");
  EXPECT_EQ(
    Fault([] { ParseSegmentationRecipe("[\"Erika\"]"); }), begin + "the whole must be an object");
}

TEST(SegmentationRecipe, NoPartOfAFileIsTakenForTheWhole)
{
  const std::string text = FormatSegmentationRecipe(Valid());
  for (std::size_t size = 0; size + 1 < text.size(); ++size) // the last byte is a line feed
    ASSERT_EQ(Fault([&] { ParseSegmentationRecipe(text.substr(0, size)); })
                .find("segmentation recipe: no JSON: a mistake at byte"),
      0U)
      << size;
}

TEST(SegmentationRecipe, AWrongByteIsReadOrRefusedWithoutATextOfTheFile)
{
  const std::string sound = FormatSegmentationRecipe(Valid());
  std::mt19937 random(3);
  int refused = 0;
  for (int n = 0; n < 2000; ++n)
  {
    std::string text = sound;
    text[random() % text.size()] = char(random());
    std::string fault;
    try
    {
      ValidateSegmentationRecipe(ParseSegmentationRecipe(text));
    }
    catch (const std::exception& error)
    {
      fault = error.what();
      ++refused;
    }
    ASSERT_EQ(fault.find("rika"), std::string::npos) << fault;
  }
  EXPECT_GT(refused, 1000);
}

TEST(SegmentationRecipe, MoreThanThereIsRoomForIsRefusedBeforeItIsRead)
{
  const auto fault = [](const std::string& steps)
  {
    return Fault(
      [&]
      {
        ParseSegmentationRecipe(
          R"({"format":"hasp-segmentation-1","steps":[)" + steps + R"(],"names":[]})");
      });
  };
  std::string steps = "1", points = "1";
  for (int n = 0; n < 10'000; ++n)
    steps += ",1";
  for (int n = 0; n < 100'000; ++n)
    points += ",1";
  const std::string begin = "segmentation recipe: ";
  EXPECT_EQ(fault(steps), begin + "steps has 10001 entries, at most 10000 are read");
  EXPECT_EQ(
    fault(R"({"step":"split","label":1,"beta":1,"crack":0,"norm":1,"strokes":[)" + steps + "]}"),
    begin + "steps[0].strokes has 10001 entries, at most 10000 are read");
  EXPECT_EQ(fault(R"({"step":"paint","only":0,"stroke":{"label":1,"radiusMm":1,"points":[)" +
                  points + "]}}"),
    begin + "steps[0].stroke.points has 100001 entries, at most 100000 are read");
}

TEST(SegmentationRecipe, ComesBackFromTheDisk)
{
  const std::filesystem::path folder =
    std::filesystem::path(testing::TempDir()) / ("Erika-recipe-" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const std::string file = folder / "recipe.json";
  WriteSegmentationRecipe(file, {});
  WriteSegmentationRecipe(file, Valid());
  EXPECT_EQ(ReadSegmentationRecipe(file), Valid());
  EXPECT_EQ(std::distance(
              std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()),
    1);
  EXPECT_EQ(Fault([&] { WriteSegmentationRecipe(folder / "no" / "recipe.json", {}); }),
    "segmentation recipe: the file cannot be written: No such file or directory");
  EXPECT_EQ(Fault([&] { ReadSegmentationRecipe(folder / "no.json"); }),
    "segmentation recipe: the file is not there");
  std::ofstream(file) << std::string((16 << 20) + 1, ' ');
  EXPECT_EQ(Fault([&] { ReadSegmentationRecipe(file); }),
    "segmentation recipe: the file has 16777217 bytes, at most 16777216 are read");
  // What could not be read again is not written.
  SegmentationRecipe large = Valid();
  const glm::dvec3 digits(100.0 / 3.0, 200.0 / 3.0, 100.0 / 7.0);
  large.steps = { PaintStep{ { 2, 1.0, std::vector<glm::dvec3>(100'000, digits) } } };
  large.steps.resize(3, large.steps[0]);
  EXPECT_EQ(Fault([&] { WriteSegmentationRecipe(file, large); })
              .find("segmentation recipe: the file would have "),
    0U);
  std::filesystem::remove_all(folder);
}

} // namespace
