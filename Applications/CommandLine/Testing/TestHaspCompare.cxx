// Label maps against each other, and what is in one.
#include "HaspProcess.h"

#include <nlohmann/json.hpp>

namespace
{

using nlohmann::json;

/// Eight voxels in a row, 0.5 x 2 x 3 mm each; at x = 10 + first.
std::string Row(const std::string& labels, int first = 0, const std::string& pairs = "")
{
  std::string text =
    "NRRD0004\ntype: uint8\ndimension: 3\nsizes: " + std::to_string(labels.size()) +
    " 1 1\nspace: left-posterior-superior\nspace directions: (0.5,0,0) (0,2,0) "
    "(0,0,3)\nspace origin: (" +
    std::to_string(10.0 + 0.5 * first) + ",20,30)\nencoding: raw\n" + pairs + "\n";
  for (const char label : labels)
    text += char(label - '0');
  return text;
}

class HaspCompare : public HaspTest
{
protected:
  HaspRun Compare(std::vector<std::string> more = {})
  {
    more.insert(more.begin(), { "compare", this->Path("a.nrrd"), this->Path("truth.nrrd") });
    return RunHasp(more);
  }
};

TEST_F(HaspCompare, SaysDiceLabelByLabel)
{
  this->WriteText("truth.nrrd", Row("02222333"));
  this->WriteText("a.nrrd", Row("02233334"));
  const HaspRun run = this->Compare({ "--json", "--tolerance", "0" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json found = json::parse(run.out);
  ASSERT_EQ(found.at("labels").size(), 2U);
  EXPECT_DOUBLE_EQ(found.at("labels")[0].at("dice"), 2.0 * 2 / (4 + 2));
  EXPECT_DOUBLE_EQ(found.at("labels")[1].at("dice"), 2.0 * 2 / (3 + 4));
  EXPECT_EQ(found.at("labels")[0].at("voxels"), 2);
  // Of label 2 one of two faces is where the truth's is; the row's sides are the grid's border.
  EXPECT_DOUBLE_EQ(found.at("labels")[0].at("surface_dice"), 0.5);
  EXPECT_DOUBLE_EQ(found.at("worst_dice"), 4.0 / 7);
  EXPECT_EQ(found.at("stray_voxels"), 1);
  const HaspRun text = this->Compare();
  EXPECT_NE(text.out.find("label     2  Dice 0.6667"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("within 3 mm"), std::string::npos) << text.out; // the largest spacing
  ExpectFailure(this->Compare({ "--least-dice", "0.6" }), 3, "label 3: Dice 0.5714");
  EXPECT_EQ(this->Compare({ "--least-dice", "0.57" }).exitCode, 0);
}

TEST_F(HaspCompare, OneMayBeCroppedAndLabelsCanBeMatched)
{
  this->WriteText("truth.nrrd", Row("22", 1));
  this->WriteText("a.nrrd", Row("07700005"));
  const HaspRun number = this->Compare({ "--json" });
  ASSERT_EQ(number.exitCode, 0) << number.err;
  EXPECT_EQ(json::parse(number.out).at("worst_dice"), 0.0);
  const json matched = json::parse(this->Compare({ "--json", "--match" }).out);
  EXPECT_EQ(matched.at("labels")[0].at("label"), 7);
  EXPECT_EQ(matched.at("worst_dice"), 1.0);
  EXPECT_EQ(matched.at("stray_voxels"), 1);
}

TEST_F(HaspCompare, BadInputIsTwo)
{
  this->WriteText("truth.nrrd", Row("0220"));
  ExpectFailure(this->Compare(), 2, "no such file");
  this->WriteText("a.nrrd", Row("0220", 4000));
  ExpectFailure(this->Compare(), 2, "lie apart from each other");
  std::string shifted = Row("0220");
  shifted.replace(shifted.find("(10.0"), 5, "(10.2");
  this->WriteText("a.nrrd", shifted);
  ExpectFailure(this->Compare(), 2, "of another grid");
  this->WriteText("a.nrrd", Row("0220"));
  this->WriteText("truth.nrrd", Row("0000"));
  ExpectFailure(this->Compare(), 2, "truth");
  ExpectFailure(this->Compare({ "--least-dice", "2" }), 1, "--least-dice");
}

TEST_F(HaspCompare, InfoListsSegmentsAndNamesThemForWhoAsks)
{
  const std::string segment =
    "Segment0_ID:=a\nSegment0_Name:=Erika\x1b[2J\nSegment0_LabelValue:=2\n"
    "Segment0_Layer:=0\nSegment0_Color:=1 0.5 0\n";
  this->WriteText("a.seg.nrrd", Row("02224000", 0, segment));
  const HaspRun run = RunHasp({ "info", this->Path("a.seg.nrrd") });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(
    run.out.find("label     2  #ff8000           3 voxels           9.0 mm3\n"), std::string::npos)
    << run.out;
  EXPECT_NE(run.out.find("label     4  no name           1 voxel "), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("Erika"), std::string::npos);
  const HaspRun named = RunHasp({ "info", this->Path("a.seg.nrrd"), "--json", "--show-names" });
  const json segments = json::parse(named.out).at("segments");
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_EQ(segments[0].at("name"), "Erika\x1b[2J");
  EXPECT_NE(RunHasp({ "info", this->Path("a.seg.nrrd"), "--show-names" }).out.find("  Erika?[2J\n"),
    std::string::npos); // a terminal would obey it
  EXPECT_EQ(segments[0].at("voxels"), 3);
  EXPECT_DOUBLE_EQ(segments[1].at("volume_mm3"), 3.0);
  EXPECT_FALSE(json::parse(RunHasp({ "info", this->Path("a.seg.nrrd"), "--json" }).out)
                 .at("segments")[0]
                 .contains("name"));
}

} // namespace
