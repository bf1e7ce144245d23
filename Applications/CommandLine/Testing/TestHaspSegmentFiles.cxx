// Seeds and recipes that go along with a segmentation, and the examples of the page of formats.
#include "SegmentFixture.h"

#include <filesystem>

namespace
{

/// The JSON of a page that stands behind a heading.
std::string Example(const std::string& page, const std::string& heading)
{
  const std::string begin = "```json\n";
  const std::size_t first = page.find(begin, page.find("\n" + heading + "\n")) + begin.size();
  return page.substr(first, page.find("```", first) - first);
}

TEST_F(HaspSegment, TheExamplesOfTheFormatsPageAreWholeFiles)
{
  this->Phantom();
  const std::string page = ReadBytes(HASP_FORMATS_PAGE);
  this->WriteText("recipe.json", Example(page, "## Segmentation recipes"));
  this->WriteText("seeds.json", Example(page, "## Seeds"));
  const HaspRun recipe = this->Segment({ "--recipe", this->Path("recipe.json") });
  EXPECT_TRUE(LabelsOf(recipe).contains(7));
  EXPECT_EQ(recipe.err.find("changes nothing"), std::string::npos) << recipe.err;
  EXPECT_EQ(recipe.err.find("no voxel"), std::string::npos) << recipe.err;
  const HaspRun seeds =
    this->Segment({ "--threshold", "226", "--seeds", this->Path("seeds.json") });
  for (const int label : { 2, 3, 6 })
    EXPECT_TRUE(LabelsOf(seeds).contains(label)) << label;
  EXPECT_EQ(seeds.err.find("touches no voxel"), std::string::npos) << seeds.err;
}

TEST_F(HaspSegment, WritesItsSeedsForSlicerAndBack)
{
  this->Phantom();
  const std::string slicer = this->Path("seeds.mrk.json"), own = this->Path("seeds.json");
  const auto first = LabelsOf(
    this->Segment({ "--threshold", "226", "--seeds", Seeds(), "--write-seeds", slicer }, "a.nrrd"));
  const json markups = json::parse(ReadBytes(slicer)).at("markups");
  EXPECT_EQ(
    markups.size(), 8U); // of ten strokes: dots of a label that follow each other are one list
  const auto second = LabelsOf(
    this->Segment({ "--threshold", "226", "--seeds", slicer, "--write-seeds", own }, "b.nrrd"));
  EXPECT_EQ(second, first);
  EXPECT_EQ(json::parse(ReadBytes(own)), json::parse(ReadBytes(Seeds())));
  ExpectFailure(this->Segment({ "--write-seeds", own }), 1, "--seeds");
  ExpectFailure(this->Segment({ "--seeds", own, "--write-seeds", own }), 1, "--write-seeds and");
  ExpectFailure(
    this->Segment({ "--seeds", own, "--write-seeds", this->Path("x.csv") }), 1, ".json");
  EXPECT_FALSE(std::filesystem::exists(this->Path("x.csv")));
}

TEST_F(HaspSegment, BoneIsOpenedClosedFilledAndItsLargestPieceKept)
{
  this->Phantom();
  const auto bone = LabelsOf(this->Segment({ "--threshold", "226" })).at(1);
  const auto with = [&](std::vector<std::string> more)
  {
    more.insert(more.begin(), { "--threshold", "226" });
    return LabelsOf(this->Segment(more)).at(1);
  };
  EXPECT_LT(with({ "--open", "2" }), bone);
  EXPECT_GT(with({ "--close", "3" }), bone);
  EXPECT_LT(with({ "--keep-largest" }), bone);
  const HaspRun all = this->Segment({ "--threshold", "226", "--keep-largest", "--fill", "--close",
    "2", "--open", "2", "--write-recipe", this->Path("recipe.json") });
  LabelsOf(all);
  const json recipe = json::parse(ReadBytes(this->Path("recipe.json")));
  std::vector<std::string> steps;
  for (const json& step : recipe.at("steps"))
    steps.push_back(step.at("step"));
  EXPECT_EQ(steps,
    (std::vector<std::string>{ "threshold", "morphology", "morphology", "fill", "components" }));
  ExpectFailure(this->Segment({ "--recipe", this->Path("recipe.json"), "--fill" }), 1, "--recipe");
}

} // namespace
