// Label maps of a plan's segmentations: made of their steps, kept, and found again.
#include "RunFixture.h"

namespace
{

/// Bone 3 of volume 1, and the same bone as labels 2 (below) and 3 (above) of segmentation 2, which
/// are fragments 4 and 5.
class HaspRunLabels : public HaspRunTest
{
protected:
  void SetUp() override
  {
    ASSERT_EQ(RunHasp({ "phantom", "--anatomy", "fibula", "--spacing", "2,2,4", "--output",
                        this->Path("leg.mha") })
                .exitCode,
      0);
    ASSERT_EQ(this->Plan({ "--new" }).exitCode, 0);
    const json passport = json::parse(RunHasp({ "info", this->Path("leg.mha"), "--json" }).out);
    const json volume{ { "id", 1 }, { "name", "Erika" },
      { "hash", passport.at("passport").at("hash") } };
    const json bone{ { "volume", 1 }, { "isovalue", 226 }, { "seed", { 0, -5, 20 } },
      { "spacingMm", 2 } };
    ASSERT_EQ(this
                ->Apply({ Add("volume", volume), Add("segmentation", Segmentation(Split(-60))),
                  Fragment(3, bone), Fragment(4, LabelSource(2)), Fragment(5, LabelSource(3)) })
                .at("parts")
                .size(),
      3U);
  }

  static json LabelSource(int label)
  {
    return { { "segmentation", 2 }, { "label", label }, { "isovalue", 226 }, { "spacingMm", 2 } };
  }
  static json Stroke(int label, double x, double z)
  {
    return { { "label", label }, { "radiusMm", 3 }, { "points", { { x, -5, z } } } };
  }
  /// At the middle between the lower stroke and the upper one, at z = 100.
  static json Split(double lowerZ)
  {
    return { { { "step", "threshold" }, { "lowest", 226 }, { "highest", 1e6 }, { "smoothMm", 0 } },
      { { "step", "split" }, { "label", 1 }, { "beta", 0 }, { "crack", 0 }, { "norm", 2 },
        { "strokes", { Stroke(2, 0, lowerZ), Stroke(3, 80, 0), Stroke(3, 0, 100) } } } };
  }
  static json Segmentation(const json& steps, const std::string& labels = "")
  {
    const json recipe{ { "format", "hasp-segmentation-1" }, { "steps", steps },
      { "names", { { { "label", 2 }, { "name", "Erika" }, { "colour", "#ff0000" } } } } };
    return { { "id", 2 }, { "name", "Erika" }, { "volume", 1 }, { "labels", labels },
      { "recipe", recipe } };
  }
  void Change(const json& segmentation)
  {
    this->Apply(json::array({ { { "change", "segmentation" }, { "object", segmentation } } }));
  }

  HaspRun MakeJson(const std::string& output, std::vector<std::string> more = {})
  {
    more.insert(more.end(), { "--volume", this->Path("leg.mha"), "--json", "--explain" });
    return this->Make(output, more);
  }
  /// Of the segmentation: "made", "in date" or "not needed".
  static std::string LabelMap(const HaspRun& run)
  {
    const json maps = json::parse(run.out).at("label_maps");
    return maps.empty() ? "not needed" : maps.at(0).at("made").get<bool>() ? "made" : "in date";
  }
  static json Resource(const HaspRun& run)
  {
    const json document = json::parse(run.out);
    for (const json& use : document.at("resources"))
      if (use.at("resource") == "segmentation 2")
        return use;
    return {};
  }
  /// The blobs of the label maps that the plan keeps, oldest first.
  std::vector<std::string> KeptMaps() const
  {
    std::vector<std::string> blobs;
    const json document = json::parse(ReadBytes(this->Path("case.hasp/plan.json")));
    for (const json& part : document.at("parts"))
      if (part.at("format") == "nrrd")
        blobs.push_back(part.at("bytes"));
    return blobs;
  }
  void Damage(const std::string& hash) const { this->WriteText("case.hasp/blobs/" + hash, "bad"); }
  std::string HashOf(const std::string& output, std::size_t part) const
  {
    return json::parse(ReadBytes(this->Path(output + "/run.json"))).at("parts")[part].at("sha256");
  }
  /// Least and largest z of a part.
  std::pair<double, double> Reach(const std::string& output, const std::string& part) const
  {
    std::pair reach(1e9, -1e9);
    for (const auto& corner : CornersOf(this->Files(output).at(part)))
      reach = { std::min(reach.first, double(corner[2])),
        std::max(reach.second, double(corner[2])) };
    return reach;
  }
};

TEST_F(HaspRunLabels, AreMadeOnceAndFoundAgainAfterAnUndo)
{
  const HaspRun first = this->MakeJson("first");
  EXPECT_EQ(Made(first), (std::vector<int>{ 3, 4, 5 }));
  EXPECT_EQ(LabelMap(first), "made");
  EXPECT_GT(Resource(first).at("bytes"), 0);
  EXPECT_GT(Resource(first).at("ms"), 0.0);
  const std::string beside = "segmentation 2: steps[1].strokes[1] touches no voxel of label 1\n";
  EXPECT_NE(first.err.find(beside), std::string::npos) << first.err;
  // The middle between strokes at -60 and 100, within a slice and a voxel of the mesh.
  EXPECT_NEAR(this->Reach("first", "fragment-4.stl").second, 20.0, 6.0);
  EXPECT_NEAR(this->Reach("first", "fragment-5.stl").first, 20.0, 6.0);

  const HaspRun second = this->Make("second", { "--json", "--explain" }); // needs no scan
  EXPECT_EQ(Made(second), std::vector<int>{});
  EXPECT_EQ(LabelMap(second), "not needed");
  EXPECT_EQ(Resource(second).at("reason"), "no part that is made needs it");
  EXPECT_EQ(this->Files("second"), this->Files("first"));

  this->Change(Segmentation(Split(-20)));
  const HaspRun moved = this->MakeJson("moved");
  EXPECT_EQ(Made(moved), (std::vector<int>{ 4, 5 }));
  EXPECT_EQ(LabelMap(moved), "made");
  EXPECT_NEAR(this->Reach("moved", "fragment-4.stl").second, 40.0, 6.0);
  EXPECT_EQ(this->KeptMaps().size(), 2U);

  ASSERT_EQ(this->Plan({ "--undo" }).exitCode, 0);
  this->Damage(this->HashOf("first", 1)); // fragment 4 needs its label map again
  const HaspRun undone = this->MakeJson("undone");
  EXPECT_EQ(Made(undone), std::vector<int>{ 4 });
  EXPECT_EQ(LabelMap(undone), "in date");
  EXPECT_NE(undone.err.find(beside), std::string::npos) << undone.err; // it still is so
  EXPECT_EQ(this->Files("undone"), this->Files("first"));
}

TEST_F(HaspRunLabels, AnyNumberOfThreadsAndAnyRunMakeTheSameBytesAndAPlanAloneKeepsNone)
{
  EXPECT_EQ(LabelMap(this->MakeJson("one", { "--threads", "1" })), "made");
  const std::vector<std::string> maps = this->KeptMaps();
  ASSERT_EQ(maps.size(), 1U);
  const std::string bytes = ReadBytes(this->Path("case.hasp/blobs/" + maps[0]));
  const std::string header = bytes.substr(0, bytes.find("\n\n"));
  EXPECT_EQ(header.substr(0, 7), "NRRD000");
  EXPECT_NE(header.find("uint16"), std::string::npos) << header;
  EXPECT_EQ(bytes.find("Erika"), std::string::npos); // names of labels, and of the test's folder

  EXPECT_EQ(LabelMap(this->MakeJson("two", { "--threads", "2", "--rebuild" })), "made");
  EXPECT_EQ(this->KeptMaps(), maps);
  EXPECT_EQ(this->Files("two"), this->Files("one"));

  this->Damage(maps[0]);
  this->Damage(this->HashOf("one", 1));
  const HaspRun mended = this->MakeJson("mended");
  EXPECT_EQ(LabelMap(mended), "made");
  EXPECT_NE(
    mended.err.find("segmentation 2: its label map is made anew: blobs/"), std::string::npos)
    << mended.err;
  EXPECT_EQ(this->KeptMaps(), maps);
  EXPECT_EQ(ReadBytes(this->Path("case.hasp/blobs/" + maps[0])), bytes);
  EXPECT_EQ(this->Files("mended"), this->Files("one"));

  fs::copy_file(this->Path("case.hasp/plan.json"), this->Path("plan.json"));
  const std::string before = ReadBytes(this->Path("plan.json"));
  const HaspRun run = RunHasp({ "run", this->Path("plan.json"), "--volume", this->Path("leg.mha"),
    "--output", this->Path("alone"), "--json" });
  EXPECT_EQ(Made(run).size(), 3U);
  EXPECT_EQ(LabelMap(run), "made");
  EXPECT_EQ(this->Files("alone"), this->Files("one"));
  EXPECT_EQ(ReadBytes(this->Path("plan.json")), before);
  EXPECT_FALSE(fs::exists(this->Path("blobs")));
}

TEST_F(HaspRunLabels, AreShownWithWhatWasFoundOnThem)
{
  const auto show = [&] { return this->Plan({ "--show" }).out; };
  const auto shown = [&] {
    return json::parse(this->Plan({ "--show", "--json" }).out).at("label_maps");
  };
  EXPECT_NE(show().find("the label map of segmentation 2 has not been made\n"), std::string::npos);
  ASSERT_EQ(this->MakeJson("first").exitCode, 0);
  const std::string beside = "steps[1].strokes[1] touches no voxel of label 1";
  EXPECT_NE(
    show().find("the label map of segmentation 2 is in date\n  " + beside), std::string::npos);
  const json map = shown().at(0);
  EXPECT_EQ(map.at("segmentation"), 2);
  EXPECT_EQ(map.at("warnings").at(0), beside);

  json plan = json::parse(ReadBytes(this->Path("case.hasp/plan.json")));
  for (const json& part : plan.at("parts"))
    if (part.at("format") == "nrrd")
      this->Damage(part.at("report"));
  EXPECT_NE(show().find("hasp run makes the label map anew"), std::string::npos);
  this->Damage(this->HashOf("first", 1)); // fragment 4 needs its label map again
  EXPECT_EQ(LabelMap(this->MakeJson("mended")), "made");
  EXPECT_EQ(shown(), json::array({ map }));
  this->Change(Segmentation(Split(-20)));
  EXPECT_NE(show().find("the label map of segmentation 2 is out of date"), std::string::npos);
}

TEST_F(HaspRunLabels, NeedTheirScanAndStandIfPartsFail)
{
  ExpectFailure(this->Make("out", {}), 2, "volume 1: not among the files given");
  EXPECT_EQ(this->KeptMaps(), std::vector<std::string>{});
  json steps = Split(0);
  steps[1]["strokes"] = json::array();
  this->Change(Segmentation(steps));
  const HaspRun none = this->Make("out", this->Scan());
  ExpectFailure(none, 2, "fragment 4: ");
  const std::string left = " mm3) that no stroke is connected to keep label 1\n",
                    said = "segmentation 2: steps[1]: ";
  const auto from = none.err.find(said), to = none.err.find(left);
  ASSERT_LT(from, to) << none.err;
  ASSERT_NE(to, std::string::npos) << none.err;
  double voxels = 0.0, mm3 = 0.0;
  ASSERT_EQ(
    std::sscanf(none.err.c_str() + from + said.size(), "%lf voxels (%lf", &voxels, &mm3), 2);
  EXPECT_DOUBLE_EQ(mm3, voxels * 16.0);
  EXPECT_EQ(this->KeptMaps().size(), 1U);

  // The bone alone, which stands, and no threshold after it.
  const json split = json::array({ Split(-60)[1] });
  this->Change(Segmentation(split, this->KeptMaps().at(0)));
  EXPECT_EQ(Made(this->MakeJson("begun")), (std::vector<int>{ 4, 5 })); // 3 is kept, too
  EXPECT_NEAR(this->Reach("begun", "fragment-4.stl").second, 20.0, 6.0);
  EXPECT_NEAR(this->Reach("begun", "fragment-5.stl").first, 20.0, 6.0);

  this->WriteText("other.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\n"
                                "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) "
                                "(0,0,1)\nspace origin: (0,0,0)\nencoding: raw\n\nErikaXYZ");
  const std::string other = this->Plan({ "--blob", this->Path("other.nrrd") }).out.substr(0, 64);
  this->Change(Segmentation(split, other));
  const HaspRun run = this->Make("out", this->Scan());
  ExpectFailure(run, 2, "fragment 4: segmentation 2: labels");
  EXPECT_NE(run.err.find("fragment 5: segmentation 2: labels"), std::string::npos) << run.err;
  EXPECT_FALSE(fs::exists(this->Path("out")));
}

} // namespace
