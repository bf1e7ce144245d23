#include "SegmentFixture.h"

#include <cstdint>
#include <cstring>
#include <filesystem>

namespace
{

/// A .mha file of short samples as one of unsigned short, 2000 above them.
std::string Unsigned(std::string bytes)
{
  bytes.replace(bytes.find("MET_SHORT"), 9, "MET_USHORT");
  const std::size_t samples = bytes.find('\n', bytes.find("ElementDataFile")) + 1;
  for (std::size_t n = samples; n + 1 < bytes.size(); n += sizeof(std::uint16_t))
  {
    std::uint16_t value = 0;
    std::memcpy(&value, &bytes[n], sizeof value);
    value = static_cast<std::uint16_t>(value + 2000);
    std::memcpy(&bytes[n], &value, sizeof value);
  }
  return bytes;
}

TEST_F(HaspSegment, PartsTheBrokenJawByStrokesAndItsRecipeDoesSoAgain)
{
  this->Phantom({ "--truth", this->Path("truth.seg.nrrd") });
  const HaspRun run = this->Segment({ "--threshold", "226", "--seeds", Seeds(), "--write-recipe",
    this->Path("recipe.json"), "--explain" });
  const auto labels = LabelsOf(run);
  for (int label = 2; label <= 6; ++label)
    EXPECT_TRUE(labels.contains(label)) << label;
  EXPECT_LE(labels.size(), 6U); // and crumbs of label 1 that no stroke is connected to
  ExpectFailure(this->Segment({ "--threshold", "226", "--labels", this->Path("truth.seg.nrrd") }),
    1, "--recipe");
  EXPECT_EQ(ReadBytes(this->Path("case.seg.nrrd")).substr(0, 7), "NRRD000");
  EXPECT_NE(ReadBytes(this->Path("case.seg.nrrd")).find("Segment0_Name"), std::string::npos);
  const HaspRun again =
    this->Segment({ "--recipe", this->Path("recipe.json"), "--threads", "1" }, "again.seg.nrrd");
  EXPECT_EQ(LabelsOf(again), labels);
  EXPECT_EQ(ReadBytes(this->Path("case.seg.nrrd")), ReadBytes(this->Path("again.seg.nrrd")));
}

TEST_F(HaspSegment, IsReadBackAsTheLabelsThatItBeginsWith)
{
  this->Phantom({ "--truth", this->Path("truth.seg.nrrd") });
  this->WriteText("merge.json",
    R"({ "format": "hasp-segmentation-1", "steps": [{ "step": "merge", "from": 4, "into": 3 }],
         "names": [] })");
  const auto merged = LabelsOf(this->Segment(
    { "--recipe", this->Path("merge.json"), "--labels", this->Path("truth.seg.nrrd") }, "m.mha"));
  EXPECT_FALSE(merged.contains(4));
  EXPECT_TRUE(merged.contains(3));
  EXPECT_TRUE(std::filesystem::exists(this->Path("m.mha")));
}

TEST_F(HaspSegment, KeepsTheNamesOfTheLabelsThatItBeginsWith)
{
  this->Phantom();
  this->WriteText("bone.json",
    R"({ "format": "hasp-segmentation-1", "names": [{ "label": 1, "name": "jaw", "colour": "#ff0000" }],
         "steps": [{ "step": "threshold", "lowest": 226, "highest": 1000000, "smoothMm": 0 }] })");
  this->WriteText("fill.json",
    R"({ "format": "hasp-segmentation-1", "names": [], "steps": [{ "step": "fill", "label": 1 }] })");
  LabelsOf(this->Segment({ "--recipe", this->Path("bone.json") }, "bone.seg.nrrd"));
  LabelsOf(this->Segment(
    { "--recipe", this->Path("fill.json"), "--labels", this->Path("bone.seg.nrrd") }));
  const std::string header = ReadBytes(this->Path("case.seg.nrrd")).substr(0, 4000);
  EXPECT_NE(header.find("Segment0_Name:=jaw\n"), std::string::npos);
  EXPECT_NE(header.find("Segment0_Color:=1 0 0\n"), std::string::npos);
}

TEST_F(HaspSegment, SaysWhichStepsOfARecipeChangeNothing)
{
  this->Phantom();
  this->WriteText("idle.json",
    R"({ "format": "hasp-segmentation-1", "names": [],
         "steps": [{ "step": "threshold", "lowest": 226, "highest": 1000000, "smoothMm": 0 },
                   { "step": "merge", "from": 4, "into": 3 }] })");
  const HaspRun run = this->Segment({ "--recipe", this->Path("idle.json") });
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_NE(run.err.find("steps[1]: changes nothing: no voxel has label 4"), std::string::npos)
    << run.err;
  EXPECT_EQ(run.err.find("steps[0]"), std::string::npos) << run.err;
}

TEST_F(HaspSegment, LabelsWithoutVoxelsAreSaidAndOnlyARecipeNamesThemInTheFile)
{
  this->Phantom();
  this->WriteText("seeds.json",
    R"({ "format": "hasp-seeds-1", "labels": [
         { "label": 1, "name": "rest", "colour": "#010203",
           "strokes": [{ "radiusMm": 9, "points": [[0, -60, -60], [0, -90, -60]] }] },
         { "label": 2, "name": "covered", "colour": "#010203",
           "strokes": [{ "radiusMm": 3, "points": [[0, -80, -75]] }] },
         { "label": 3, "name": "chin", "colour": "#010203",
           "strokes": [{ "radiusMm": 9, "points": [[0, -60, -75], [0, -90, -75]] }] }] })");
  const HaspRun run = this->Segment(
    { "--seeds", this->Path("seeds.json"), "--write-recipe", this->Path("recipe.json") });
  const auto labels = LabelsOf(run);
  EXPECT_FALSE(labels.contains(2));
  EXPECT_TRUE(labels.contains(3));
  for (const std::string said :
    { "strokes of label 1 keep bone that nobody has named", "steps[1]: label 2 gets no voxel",
      "label 2 has no voxel in the end; it becomes no segment" })
    EXPECT_NE(run.err.find(said), std::string::npos) << said << "\n" << run.err;
  EXPECT_EQ(ReadBytes(this->Path("case.seg.nrrd")).find("Segment2_"), std::string::npos);
  const HaspRun again = this->Segment({ "--recipe", this->Path("recipe.json") }, "again.seg.nrrd");
  EXPECT_EQ(LabelsOf(again), labels);
  EXPECT_EQ(ReadBytes(this->Path("case.seg.nrrd")), ReadBytes(this->Path("again.seg.nrrd")));

  this->WriteText("named.json",
    R"({ "format": "hasp-segmentation-1", "names": [{ "label": 9, "name": "tooth", "colour": "#ff0000" }],
         "steps": [{ "step": "threshold", "lowest": 226, "highest": 1000000, "smoothMm": 0 }] })");
  const HaspRun named = this->Segment({ "--recipe", this->Path("named.json") });
  EXPECT_NE(named.err.find("names[0]: label 9 has no voxel in the end; its segment is empty"),
    std::string::npos)
    << named.err;
  EXPECT_NE(ReadBytes(this->Path("case.seg.nrrd")).find(":=tooth"), std::string::npos);
}

TEST_F(HaspSegment, TellsAScanFromALabelMap)
{
  this->Phantom({ "--truth", this->Path("truth.seg.nrrd") });
  const auto segment = [&](const std::string& in, std::vector<std::string> more)
  {
    more.insert(
      more.begin(), { "segment", this->Path(in), "--output", this->Path("case.seg.nrrd") });
    return RunHasp(more);
  };
  ExpectFailure(segment("truth.seg.nrrd", {}), 2, "is a segmentation; give the scan as IN");
  EXPECT_FALSE(std::filesystem::exists(this->Path("case.seg.nrrd")));
  ASSERT_EQ(
    RunHasp({ "convert", this->Path("truth.seg.nrrd"), this->Path("mask.nrrd") }).exitCode, 0);
  const HaspRun mask = segment("mask.nrrd", { "--threshold", "2" });
  EXPECT_EQ(mask.exitCode, 0);
  EXPECT_NE(mask.err.find("as a label map has"), std::string::npos) << mask.err;
  EXPECT_EQ(segment("jaw.mha", {}).err.find("label map"), std::string::npos);

  this->WriteText("fill.json",
    R"({ "format": "hasp-segmentation-1", "names": [], "steps": [{ "step": "fill", "label": 1 }] })");
  this->WriteText("grey.mha", Unsigned(ReadBytes(this->Path("jaw.mha"))));
  const auto begin = [&](const std::string& labels)
  {
    return this->Segment(
      { "--recipe", this->Path("fill.json"), "--labels", this->Path(labels) }, "x.nrrd");
  };
  ExpectFailure(begin("grey.mha"), 2, "is a scan by its values");
  ExpectFailure(begin("jaw.mha"), 1, "--labels and IN");
  EXPECT_EQ(begin("mask.nrrd").exitCode, 0);
}

TEST_F(HaspSegment, WithoutSeedsBoneIsOneLabelOrItsPieces)
{
  this->Phantom();
  const auto bone = LabelsOf(this->Segment({}));
  ASSERT_EQ(bone.size(), 1U);
  const auto adult = LabelsOf(this->Segment({ "--preset", "adult compact bone" }));
  EXPECT_LT(adult.at(1), bone.at(1));
  const auto pieces = LabelsOf(this->Segment({ "--threshold", "400", "--components", "1000" }));
  EXPECT_GE(pieces.size(), 2U);
  EXPECT_LE(pieces.at(1), bone.at(1));
}

TEST_F(HaspSegment, ProposesAThresholdWhereValuesAreNoHU)
{
  this->Phantom({ "--cbct" });
  const HaspRun run = this->Segment({ "--cone-beam", "--gaussian", "0.5" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(run.err.find("proposed from the histogram"), std::string::npos);
  const json steps = json::parse(run.out).at("steps");
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_GT(steps[2].at("lowest"), 240.0); // grey values, that the CT's 226 is none of
  ExpectFailure(
    this->Segment({ "--preset", "bone", "--quiet", "--threshold", "3" }), 1, "--preset");
}

TEST_F(HaspSegment, BadInputIsTwoWrongUseIsOneAndNothingIsLeft)
{
  this->Phantom();
  this->WriteText("bad.json", R"({ "format": "hasp-seeds-1", "labels": [], "patient": 1 })");
  this->WriteText("far.json",
    R"({ "format": "hasp-seeds-1", "labels": [{ "label": 2, "name": "a", "colour": "#010203",
         "strokes": [{ "radiusMm": 2, "points": [[900, 0, 0]] }] }] })");
  const std::vector<std::string> before = this->Names();
  ExpectFailure(this->Segment({ "--seeds", this->Path("no.json") }), 2, "no such file");
  ExpectFailure(this->Segment({ "--seeds", this->Path("bad.json") }), 2, "is unknown");
  ExpectFailure(this->Segment({ "--threshold", "nan" }), 1, "--threshold");
  ExpectFailure(this->Segment({ "--threshold", "9000" }), 2, "no voxel has a label");
  ExpectFailure(this->Segment({ "--recipe", this->Path("bad.json"), "--beta", "1" }), 1, "--");
  ExpectFailure(this->Segment({ "--recipe", this->Path("bad.json") }), 2, "is");
  ExpectFailure(this->Segment({ "--seeds", this->Path("far.json") }, "x.stl"), 1, ".nrrd");
  const std::string scan = ReadBytes(this->Path("jaw.mha"));
  ExpectFailure(this->Segment({}, "jaw.mha"), 1, "--output and IN");
  EXPECT_EQ(ReadBytes(this->Path("jaw.mha")), scan);
  ExpectFailure(
    this->Segment({ "--seeds", this->Path("far.json"), "--write-recipe", this->Path("far.json") }),
    1, "--write-recipe and --seeds");
  EXPECT_EQ(this->Names(), before);
  ExpectFailure(this->Segment({ "--seeds", this->Path("far.json") }), 2, "points are LPS in mm");
  EXPECT_EQ(this->Names(), before);
  this->WriteText("two.json",
    R"({ "format": "hasp-seeds-1", "labels": [{ "label": 2, "name": "a", "colour": "#010203",
         "strokes": [{ "radiusMm": 2, "points": [[900, 0, 0]] },
                     { "radiusMm": 9, "points": [[0, -60, -60], [0, -90, -60]] }] }] })");
  const HaspRun beside = this->Segment({ "--seeds", this->Path("two.json") });
  EXPECT_EQ(beside.exitCode, 0) << beside.err;
  EXPECT_NE(beside.err.find("labels[0].strokes[0] touches no voxel of label 1"), std::string::npos)
    << beside.err;
}

} // namespace
