#include "RunFixture.h"

namespace
{

/// The plan without all that a transplant out of bone 2 does not need, and with it: transplant 10
/// and its mitre guide 11.
class HaspRunTransplant : public HaspRunTest
{
protected:
  void SetUp() override
  {
    HaspRunTest::SetUp();
    json edits = json::array();
    for (const int id : { 9, 8, 7, 6, 5, 4, 3 })
      edits.push_back({ { "remove", id } });
    edits.push_back(Transplant(5));
    edits.push_back(MitreGuide(14));
    this->Apply(edits);
  }
  static json MitreGuide(double widthMm)
  {
    return Add("mitre-guide",
      { { "id", 11 }, { "name", "Erika" }, { "transplant", 10 },
        { "choices",
          { { "gapMm", 0.3 }, { "thicknessMm", 4 }, { "widthMm", widthMm }, { "clearanceMm", 0.25 },
            { "wallMm", 3 }, { "slotLengthMm", 20 }, { "guidingHeightMm", 15 }, { "beyondMm", 15 },
            { "pinDiameterMm", 3 }, { "spacingMm", 0.5 } } } });
  }
  static json Changed(json edit)
  {
    edit["change"] = edit["add"];
    edit.erase("add");
    return edit;
  }
  HaspRun Scanned(const std::string& output, std::vector<std::string> more)
  {
    more.insert(more.end(), { "--volume", this->Path("leg.mha"), "--json" });
    return this->Make(output, more);
  }
  /// As the plan names its blobs.
  std::string Sha256(const std::string& file)
  {
    return this->Plan({ "--blob", file }).out.substr(0, 64);
  }
};

TEST_F(HaspRunTransplant, ItsMitreGuideIsMadeCertifiedAndRecut)
{
  ASSERT_EQ(Made(this->Scanned("one", { "--threads", "1" })), (std::vector<int>{ 2, 10, 11 }));
  const auto one = this->Files("one");
  ASSERT_TRUE(one.contains("mitre-guide-11.stl"));
  EXPECT_EQ(one.at("mitre-guide-11.stl").find("DOES NOT HOLD"), std::string::npos);
  const json part = json::parse(one.at("run.json")).at("parts")[2];
  EXPECT_EQ(part.at("kind"), "mitre-guide");
  EXPECT_EQ(part.at("verdict"), "green");
  EXPECT_EQ(part.at("held_to_fragment"), 2);                // the leg has other bone
  EXPECT_EQ(part.at("certificate").at("slots").size(), 4U); // two a segment
  EXPECT_EQ(part.at("certificate").at("holes").size(), 4U); // at both ends, and in each segment
  for (const char* threads : { "2", "4" })
  {
    ASSERT_EQ(Made(this->Scanned(threads, { "--rebuild", "--threads", threads })).size(), 3U);
    EXPECT_EQ(this->Files(threads), one) << threads;
  }
  this->Apply(json::array({ Changed(MitreGuide(12)) }));
  EXPECT_EQ(this->OutOfDate(), std::vector<int>{ 11 }); // and not what it is for
  json longer = Changed(Transplant(5));
  longer["object"]["transplant"]["joints"][2]["point"][0] = 124;
  this->Apply(json::array({ longer }));
  EXPECT_EQ(this->OutOfDate(), (std::vector<int>{ 10, 11 }));
  const std::string file = this->Path("guide.stl");
  ExpectFailure(this->Plan({ "--export", "11", "--output", file }), 2,
    "mitre-guide 11 is out of date: transplant 10 has changed");
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(HaspRunTransplant, FilesAreOfTheFormatThatIsAskedFor)
{
  this->Apply(json::array({ { { "remove", 11 } } }));
  ASSERT_EQ(Made(this->Scanned("stl", {})).size(), 2U);
  const auto asStl = this->Files("stl");
  std::vector<std::string> formats{ "ply", "obj" };
#if HASP_WITH_LIB3MF
  formats.emplace_back("3mf");
#endif
  for (const std::string& format : formats)
  {
    const HaspRun run = this->Make(format, { "--format", format, "--json" });
    EXPECT_EQ(Made(run), std::vector<int>{}); // of what the plan keeps
    EXPECT_EQ(json::parse(run.out).at("parts")[0].at("file"), "fragment-2." + format);
    const auto files = this->Files(format);
    ASSERT_EQ(files.size(), asStl.size());
    for (const auto& [name, bytes] : files)
      EXPECT_TRUE(name == "run.json" || name.ends_with("." + format)) << name;
    const json transplant = json::parse(files.at("run.json")).at("parts")[1];
    const json& segment = transplant.at("segments")[1].at("on_donor");
    EXPECT_EQ(segment.at("file"), "transplant-10-donor-segment-2." + format);
    for (const json& said : { transplant, segment })
    {
      const std::string name = said.at("file"), stem = name.substr(0, name.find('.'));
      const std::string path = this->Path(format + "/" + name);
      EXPECT_EQ(said.at("sha256"), this->Sha256(path));
      ASSERT_EQ(RunHasp({ "convert", path, this->Path("back.stl") }).exitCode, 0);
      const std::string back = ReadBytes(this->Path("back.stl")), was = asStl.at(stem + ".stl");
      EXPECT_EQ(back.size(), was.size()) << name;
      if (format != "3mf") // which rounds
      {
        EXPECT_TRUE(CornersOf(back) == CornersOf(was)) << name; // normals are of rounded corners
      }
    }
    const std::string part = this->Path("part." + format);
    ASSERT_EQ(this->Plan({ "--export", "10", "--output", part }).exitCode, 0);
    EXPECT_EQ(ReadBytes(part), files.at("transplant-10." + format));
  }
  ExpectFailure(this->Make("other", { "--format", "vtp" }), 1, "--format");
  ExpectFailure(this->Plan({ "--export", "10", "--output", this->Path("a.vtp") }), 1, ".vtp");
  for (const std::string& name : this->Names()) // nothing that was only on the way
    EXPECT_FALSE(name.starts_with(".")) << name;
}

TEST_F(HaspRunTransplant, ARedPartSaysSoInEveryFormat)
{
  this->Apply(json::array({ { { "remove", 11 } }, { { "remove", 10 } } }));
  json thin = Guide(12, -60, json::array());
  thin["object"]["recipe"]["holes"] = { { { "point", Front(-60) }, { "axis", { 0, -1, 0 } },
    { "diameterMm", 11.2 }, { "depthMm", 20 }, { "sleeveHeightMm", 0 } } };
  this->Apply(json::array({ thin }));
  ASSERT_EQ(this->Scanned("out", { "--force", "--format", "obj" }).exitCode, 0);
  const auto said = [&](const std::string& file)
  { return ReadBytes(this->Path(file)).find("DOES NOT HOLD") != std::string::npos; };
  EXPECT_TRUE(said("out/guide-12.obj"));
  EXPECT_FALSE(said("out/fragment-2.obj"));
  const std::string part = this->Path("part.ply");
  ExpectFailure(this->Plan({ "--export", "12", "--output", part }), 3, "guide 12 does not hold");
  ASSERT_EQ(this->Plan({ "--export", "12", "--output", part, "--force" }).exitCode, 0);
  EXPECT_TRUE(said("part.ply"));
}

} // namespace
