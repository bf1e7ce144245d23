#include "HaspProcess.h"

#include "Grid/AnalyticSolid.h"
#include "Grid/Phantom.h"

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

/// A plan on the phantom's fibula: volume 1, bone 2, cut 3 through its shaft, its pieces 4 (above)
/// and 5 (below, moved 2 mm), guide 6 for the cut, plate 7 on both pieces as planned, group 8 of
/// both, and guide 9 far from the cut.
class HaspRunTest : public HaspTest
{
protected:
  void SetUp() override
  {
    ASSERT_EQ(RunHasp({ "phantom", "--anatomy", "fibula", "--spacing", "1,1,2", "--output",
                        this->Path("leg.mha") })
                .exitCode,
      0);
    ASSERT_EQ(this->Plan({ "--new" }).exitCode, 0);
    const json passport = json::parse(RunHasp({ "info", this->Path("leg.mha"), "--json" }).out);
    const std::string hash = passport.at("passport").at("hash");
    const json applied =
      this->Apply({ Add("volume", { { "id", 1 }, { "name", "Erika" }, { "hash", hash } }),
        Fragment(2, { { "volume", 1 }, { "isovalue", 226 }, { "seed", { 0, -5, 20 } },
                      { "spacingMm", 1.5 } }),
        { { "add", "cut" }, { "object", Cut(20) } },
        Fragment(4, { { "fragment", 2 }, { "seed", { 0, -5, 40 } } }),
        Fragment(5, { { "fragment", 2 }, { "seed", { 0, -5, 0 } } }), Move(-2), Guide(6, 20, { 3 }),
        Plate(), Add("group", { { "id", 8 }, { "name", "" }, { "fragments", { 4, 5 } } }),
        Guide(9, -60, json::array()) });
    ASSERT_EQ(applied.at("parts").size(), 6U);
  }

  static json Add(const char* kind, const json& object)
  {
    return { { "add", kind }, { "object", object } };
  }
  static json Pose(double z)
  {
    return { { "position", { 0, 0, z } }, { "orientation", { 1, 0, 0, 0 } } };
  }
  static json Fragment(int id, const json& source)
  {
    return Add(
      "fragment", { { "id", id }, { "name", "" }, { "source", source }, { "colour", "#ffffff" },
                    { "state", "kept" }, { "scanToPlanned", Pose(0) }, { "locked", false } });
  }
  static json Cut(double z)
  {
    return { { "id", 3 }, { "name", "" },
      { "blade", { { "point", { 0, -5, z } }, { "normal", { 0, 0, 1 } }, { "along", { 1, 0, 0 } },
                   { "widthMm", 22 }, { "depthMm", 40 }, { "kerfMm", 1.5 } } },
      { "fragments", { 2 } }, { "reachMm", 8 } };
  }
  /// Of the lower piece, along z.
  static json Move(double z)
  {
    return { { "pose", { { { "fragment", 5 }, { "scanToPlanned", Pose(z) } } } } };
  }
  /// On the shaft's front, and on its left side, from the closed form.
  static json Front(double z) { return Surface(z, { 0, -1, 0 }); }
  static json Side(double z) { return Surface(z, { 1, 0, 0 }); }
  static json Surface(double z, const glm::dvec3& way)
  {
    hasp::PhantomSettings settings;
    settings.anatomy = hasp::PhantomAnatomy::Fibula;
    const hasp::AnalyticSolid bone = hasp::PhantomSolid(settings);
    glm::dvec3 place(0.0, -5.0, z);
    while (bone.Distance(place).mm < 0.0)
      place += 0.02 * way;
    return { place.x, place.y, place.z };
  }
  static json Guide(int id, double z, const json& cuts)
  {
    const json recipe{ { "format", "hasp-guide-recipe-2" }, { "isovalue", 226 },
      { "landmarks", { Front(z - 12), Front(z), Front(z + 12) } }, { "outline", "open" },
      { "strokes", json::array() }, { "withdrawal", { 0, -1, 0 } }, { "axisSearchDeg", 0 },
      { "gapMm", 0.3 }, { "thicknessMm", 3 }, { "widthMm", 12 }, { "edgeRadiusMm", 0 },
      { "clearanceMm", 0.25 }, { "wallMm", 3 }, { "sleeveWallMm", 2 }, { "spacingMm", 0.9 },
      { "ignoreBelowMm3", 100 }, { "slots", json::array() }, { "flanges", json::array() },
      { "holes", json::array() }, { "labels", json::array() } };
    return Add("guide",
      { { "id", id }, { "name", "" }, { "bone", 2 }, { "recipe", recipe }, { "cuts", cuts } });
  }
  static json Plate()
  {
    const json recipe{ { "format", "hasp-plate-recipe-1" }, { "isovalue", 226 },
      { "ignoreBelowMm3", 100 }, { "landmarks", { Side(45), Side(35) } }, { "gapMm", 0.3 },
      { "thicknessMm", 2.5 }, { "widthMm", 6 }, { "bevelMm", 0 }, { "bridgeMm", 0 },
      { "edgeDistanceMm", 1 }, { "holeDistanceMm", 1 }, { "spacingMm", 0.9 },
      { "screws", json::array() }, { "fragments", json::array() } };
    return Add("plate", { { "id", 7 }, { "name", "" }, { "volume", 0 }, { "fragments", { 4, 5 } },
                          { "recipe", recipe } });
  }

  HaspRun Plan(const std::vector<std::string>& more)
  {
    std::vector<std::string> words{ "plan", this->Path("case.hasp") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  json Apply(const json& edits)
  {
    this->WriteText("edits.json", json{ { "format", "hasp-edits-2" }, { "edits", edits } }.dump());
    const HaspRun run = this->Plan({ "--apply", this->Path("edits.json"), "--json" });
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return json::parse(run.exitCode == 0 ? run.out : "{}");
  }
  HaspRun Make(const std::string& output, const std::vector<std::string>& more)
  {
    std::vector<std::string> words{ "run", this->Path("case.hasp"), "--output",
      this->Path(output) };
    words.insert(words.end(), more.begin(), more.end());
    const HaspRun run = RunHasp(words);
    EXPECT_EQ((run.out + run.err).find("Erika"), std::string::npos) << run.out << run.err;
    return run;
  }
  std::vector<std::string> Scan() const { return { "--volume", this->Path("leg.mha") }; }
  /// The ids of the objects that were made, not taken from the plan.
  static std::vector<int> Made(const HaspRun& run)
  {
    EXPECT_EQ(run.exitCode, 0) << run.err;
    std::vector<int> made;
    const json document = json::parse(run.exitCode == 0 ? run.out : "{\"parts\":[]}");
    for (const json& part : document.at("parts"))
      if (part.at("made").get<bool>())
        made.push_back(part.at("object"));
    return made;
  }
  std::map<std::string, std::string> Files(const std::string& folder) const
  {
    std::map<std::string, std::string> files;
    for (const auto& file : fs::directory_iterator(this->Path(folder)))
      files[file.path().filename().string()] = ReadBytes(file.path().string());
    return files;
  }
  std::vector<int> OutOfDate()
  {
    std::vector<int> objects;
    const json shown = json::parse(this->Plan({ "--json" }).out);
    for (const json& part : shown.at("parts"))
      if (!part.at("in_date").get<bool>())
        objects.push_back(part.at("object"));
    return objects;
  }
};

TEST_F(HaspRunTest, AnyNumberOfThreadsAndASecondRunWriteTheSameBytes)
{
  std::vector<std::string> words = this->Scan();
  words.insert(words.end(), { "--json", "--explain", "--threads", "1" });
  EXPECT_EQ(Made(this->Make("one", words)), (std::vector<int>{ 4, 5, 8, 6, 9, 7 }));
  const auto one = this->Files("one");
  std::vector<std::string> names;
  for (const auto& [name, bytes] : one)
    names.push_back(name);
  EXPECT_EQ(
    names, (std::vector<std::string>{ "fragment-4.stl", "fragment-5-planned.stl", "fragment-5.stl",
             "group-8.stl", "guide-6.stl", "guide-9.stl", "plate-7.stl", "run.json" }));
  const json run = json::parse(one.at("run.json"));
  EXPECT_EQ(run.at("parts").size(), 6U);
  EXPECT_EQ(run.at("parts")[0].at("cuts")[0].at("parted"), true);
  EXPECT_EQ(run.at("parts")[3].at("verdict"), "green");
  EXPECT_EQ(run.at("parts")[3].at("certificate").at("slots").size(), 1U); // of the cut
  EXPECT_EQ(run.at("parts")[4].at("certificate").at("slots").size(), 0U);
  EXPECT_EQ(this->OutOfDate(), std::vector<int>{});

  const HaspRun second = this->Make("second", { "--json" }); // needs no scan
  EXPECT_EQ(Made(second), std::vector<int>{});
  EXPECT_EQ(this->Files("second"), one);
  for (const char* threads : { "2", "4" })
  {
    std::vector<std::string> again = this->Scan();
    again.insert(again.end(), { "--json", "--rebuild", "--threads", threads });
    EXPECT_EQ(Made(this->Make(threads, again)).size(), 6U);
    EXPECT_EQ(this->Files(threads), one) << threads;
  }
}

TEST_F(HaspRunTest, OnlyWhatHangsOnAChangeIsMadeAnew)
{
  std::vector<std::string> words = this->Scan();
  words.push_back("--json");
  ASSERT_EQ(Made(this->Make("first", words)).size(), 6U);
  this->Apply(json::array({ { { "change", "cut" }, { "object", Cut(18) } } }));
  EXPECT_EQ(this->OutOfDate(), (std::vector<int>{ 4, 5, 8, 6, 7 })); // and not guide 9
  const std::string part = this->Path("part.stl");
  ExpectFailure(this->Plan({ "--export", "6", "--output", part }), 2,
    "guide 6 is out of date: cut 3 has changed");
  EXPECT_FALSE(fs::exists(part));
  ASSERT_EQ(this->Plan({ "--undo" }).exitCode, 0);
  EXPECT_EQ(this->OutOfDate(), std::vector<int>{});
  ASSERT_EQ(this->Plan({ "--export", "6", "--output", part }).exitCode, 0);
  EXPECT_EQ(ReadBytes(part), ReadBytes(this->Path("first/guide-6.stl")));
  ASSERT_EQ(this->Plan({ "--redo" }).exitCode, 0);
  EXPECT_EQ(Made(this->Make("moved", words)), (std::vector<int>{ 4, 5, 8, 6, 7 }));
  EXPECT_NE(this->Files("moved").at("fragment-4.stl"), this->Files("first").at("fragment-4.stl"));
  EXPECT_EQ(this->Files("moved").at("guide-9.stl"), this->Files("first").at("guide-9.stl"));
  ASSERT_EQ(this->Plan({ "--undo" }).exitCode, 0); // what was made before is still there
  EXPECT_EQ(Made(this->Make("undone", { "--json" })), std::vector<int>{});
  EXPECT_EQ(this->Files("undone"), this->Files("first"));
  this->Apply(json::array({ Move(-3) })); // guides and pieces lie in the scan
  EXPECT_EQ(this->OutOfDate(), (std::vector<int>{ 8, 7 }));
}

TEST_F(HaspRunTest, ScansThatAreMissingOrOthersAreRefused)
{
  this->Phantom("other.mha");
  ExpectFailure(this->Make("out", {}), 2, "volume 1: not among the files given");
  const HaspRun other = this->Make("out", { "--volume", this->Path("other.mha") });
  ExpectFailure(other, 2, "volume 1: not among the files given");
  EXPECT_NE(other.err.find("--volume number 1 is none that the plan"), std::string::npos);
  ExpectFailure(this->Make("out", { "--volume", this->Path("no.mha") }), 2, "no such file");
  EXPECT_EQ(
    this->Names(), (std::vector<std::string>{ "case.hasp", "edits.json", "leg.mha", "other.mha" }));
  ASSERT_EQ(this->Plan({ "--undo" }).exitCode, 0);
  ExpectFailure(this->Make("out", {}), 2, "nothing is made of it");
}

TEST_F(HaspRunTest, WhatCannotBeMadeIsNamedByIds)
{
  this->Apply(json::array({ { { "change", "cut" }, { "object", Cut(700) } } }));
  ExpectFailure(this->Make("out", this->Scan()), 2, "fragment 4: cut 3 does not meet bone");
  this->Apply(
    json::array({ { { "change", "cut" }, { "object", Cut(60) } } })); // above the seed of 4
  ExpectFailure(this->Make("out", this->Scan()), 2, "fragment 5: it is one piece with fragment 4");
  EXPECT_FALSE(fs::exists(this->Path("out")));
  EXPECT_TRUE(this->OutOfDate().size() == 6U);
}

TEST_F(HaspRunTest, RedPartsAreRefusedOrSaySo)
{
  json thin = Guide(9, -60, json::array()).at("object");
  thin["recipe"]["holes"] = { { { "point", Front(-60) }, { "axis", { 0, -1, 0 } },
    { "diameterMm", 11.2 }, { "depthMm", 20 }, { "sleeveHeightMm", 0 } } };
  this->Apply(json::array({ { { "change", "guide" }, { "object", thin } } }));
  const HaspRun red = this->Make("out", this->Scan());
  ExpectFailure(red, 3, "guide 9: ");
  EXPECT_FALSE(fs::exists(this->Path("out")));
  std::vector<std::string> words = this->Scan();
  words.push_back("--force");
  const HaspRun forced = this->Make("out", words);
  ASSERT_EQ(forced.exitCode, 0) << forced.err;
  EXPECT_NE(forced.err.find("guide 9: "), std::string::npos);
  EXPECT_NE(ReadBytes(this->Path("out/guide-9.stl")).substr(0, 80).find("DOES NOT HOLD"),
    std::string::npos);
  EXPECT_EQ(ReadBytes(this->Path("out/guide-6.stl")).substr(0, 80).find("DOES NOT HOLD"),
    std::string::npos);
  ExpectFailure(this->Make("again", {}), 3, "guide 9: "); // kept, and red it stays
  const std::string part = this->Path("part.stl");
  ExpectFailure(this->Plan({ "--export", "9", "--output", part }), 3, "guide 9 does not hold");
  EXPECT_EQ(this->Plan({ "--export", "9", "--output", part, "--force" }).exitCode, 0);
}

TEST_F(HaspRunTest, DamageIsMendedAndAPlanAloneIsOnlyRead)
{
  ASSERT_EQ(this->Make("first", this->Scan()).exitCode, 0);
  const std::string before = ReadBytes(this->Path("case.hasp/plan.json"));
  const json run = json::parse(ReadBytes(this->Path("first/run.json")));
  const std::string blob = run.at("parts")[0].at("sha256");
  this->WriteText("case.hasp/blobs/" + blob, "damaged");
  ExpectFailure(this->Plan({ "--export", "4", "--output", this->Path("part.stl") }), 2,
    "blobs/" + blob.substr(0, 12) + " is damaged");
  std::vector<std::string> words = this->Scan();
  words.push_back("--json");
  const HaspRun mended = this->Make("mended", words);
  EXPECT_EQ(Made(mended), std::vector<int>{ 4 });
  EXPECT_NE(mended.err.find("fragment 4 is made anew: blobs/"), std::string::npos) << mended.err;
  EXPECT_EQ(this->Files("mended"), this->Files("first"));
  EXPECT_EQ(this->Plan({ "--check" }).exitCode, 0);

  fs::copy_file(this->Path("case.hasp/plan.json"), this->Path("plan.json"));
  const auto files = fs::file_size(this->Path("plan.json"));
  std::vector<std::string> alone{ "run", this->Path("plan.json"), "--volume", this->Path("leg.mha"),
    "--output", this->Path("alone"), "--json" };
  EXPECT_EQ(Made(RunHasp(alone)).size(), 6U); // its blobs are elsewhere
  EXPECT_EQ(this->Files("alone"), this->Files("first"));
  EXPECT_EQ(fs::file_size(this->Path("plan.json")), files);
  EXPECT_FALSE(fs::exists(this->Path("blobs")));
}

} // namespace
