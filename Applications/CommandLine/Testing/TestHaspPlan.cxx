#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

class HaspPlan : public HaspTest
{
protected:
  HaspRun Plan(const std::vector<std::string>& more)
  {
    std::vector<std::string> words{ "plan", this->Path("case.hasp") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  HaspRun Apply(const json& edits)
  {
    this->WriteText("edits.json", json{ { "format", "hasp-edits-2" }, { "edits", edits } }.dump());
    return this->Plan({ "--apply", this->Path("edits.json"), "--json" });
  }
  static json Volume(int id)
  {
    return { { "add", "volume" },
      { "object", { { "id", id }, { "name", "Erika" }, { "hash", std::string(64, 'a') } } } };
  }
  static json Fragment(int id)
  {
    const json source{ { "volume", 1 }, { "isovalue", 226 }, { "seed", { 0, 0, 0 } },
      { "spacingMm", 0.5 } };
    return { { "add", "fragment" },
      { "object",
        { { "id", id }, { "name", "Erika" }, { "source", source }, { "colour", "#ffffff" },
          { "state", "kept" },
          { "scanToPlanned", { { "position", { 0, 0, 0 } }, { "orientation", { 1, 0, 0, 0 } } } },
          { "locked", false } } } };
  }
  /// What happened, in one document.
  static json Shown(const HaspRun& run)
  {
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ((run.out + run.err).find("Erika"), std::string::npos) << run.out << run.err;
    return json::parse(run.out);
  }
};

TEST_F(HaspPlan, EditsAreMadeUndoneAndRedone)
{
  ASSERT_EQ(this->Plan({ "--new", "--case", "K-17" }).exitCode, 0);
  const json empty = Shown(this->Plan({ "--show", "--json" }));
  EXPECT_TRUE(empty.at("objects").empty());
  EXPECT_TRUE(empty.at("undo").is_null());
  const json made = Shown(this->Apply({ Volume(1), Fragment(2) }));
  ASSERT_EQ(made.at("objects").size(), 2U);
  EXPECT_EQ(made.at("objects")[1], (json{ { "kind", "fragment" }, { "id", 2 } }));
  EXPECT_EQ(made.at("undo"), "Add volume 1 and 1 more");
  EXPECT_EQ(made.at("parts")[0].at("why"), "fragment 2 has not been made");
  EXPECT_EQ(made.at("next_id"), 3);
  const json undone = Shown(this->Plan({ "--undo", "--json" }));
  EXPECT_EQ(undone.at("hash"), empty.at("hash"));
  EXPECT_EQ(undone.at("redo"), "Add volume 1 and 1 more");
  EXPECT_EQ(undone.at("next_id"), 3);
  EXPECT_EQ(Shown(this->Plan({ "--redo", "--json" })).at("hash"), made.at("hash"));
  const HaspRun named = this->Plan({ "--show", "--show-names" });
  EXPECT_NE(named.out.find("fragment 2  Erika"), std::string::npos) << named.out;
  const HaspRun alone = RunHasp({ "plan", this->Path("case.hasp/plan.json"), "--json" });
  EXPECT_EQ(Shown(alone).at("hash"), made.at("hash"));
}

TEST_F(HaspPlan, FragmentsAndGroupsAreMovedLockedAndUngrouped)
{
  ASSERT_EQ(this->Plan({ "--new" }).exitCode, 0);
  json locked = Fragment(4);
  locked["object"]["locked"] = true;
  const auto group = [](int id, const json& members)
  {
    return json{ { "add", "group" },
      { "object", { { "id", id }, { "name", "Erika" }, { "fragments", members } } } };
  };
  Shown(this->Apply(
    { Volume(1), Fragment(2), Fragment(3), locked, group(5, { 2, 3 }), group(6, { 3, 4 }) }));
  const auto position = [](const json& shown, int n)
  { return shown.at("fragments")[std::size_t(n)].at("position"); };
  json shown = Shown(this->Plan({ "--move", "5", "--shift", "1,2,3", "--json" }));
  EXPECT_EQ(shown.at("undo"), "Move fragments 2 and 3");
  EXPECT_EQ(position(shown, 0), (json{ 1.0, 2.0, 3.0 }));
  EXPECT_EQ(position(shown, 1), (json{ 1.0, 2.0, 3.0 }));
  shown = Shown(this->Plan({ "--move", "2", "--turn", "0,0,90", "--about", "1,2,0", "--json" }));
  EXPECT_NEAR(position(shown, 0)[0].get<double>(), 1.0, 1e-12); // it stands on the axis
  EXPECT_NEAR(shown.at("fragments")[0].at("orientation")[3].get<double>(), std::sqrt(0.5), 1e-12);
  ExpectFailure(this->Plan({ "--move", "6", "--shift", "1,0,0" }), 2, "fragment 4: is locked");
  ExpectFailure(this->Plan({ "--move", "4", "--shift", "1,0,0" }), 2, "is locked");
  ExpectFailure(this->Plan({ "--move", "1", "--shift", "1,0,0" }), 2, "the plan has none");
  EXPECT_EQ(this->Plan({ "--shift", "1,0,0" }).exitCode, 1);
  EXPECT_EQ(this->Plan({ "--move", "2", "--undo" }).exitCode, 1);
  const json before = Shown(this->Plan({ "--json" })).at("fragments");
  shown = Shown(this->Apply({ { { "remove", 5 } } }));
  EXPECT_EQ(shown.at("fragments"), before); // taken apart, nothing moves
}

TEST_F(HaspPlan, RefusedEditsLeaveThePlanAsItWas)
{
  ASSERT_EQ(this->Plan({ "--new" }).exitCode, 0);
  ASSERT_EQ(this->Apply(json::array({ Volume(1) })).exitCode, 0);
  const std::string before = ReadBytes(this->Path("case.hasp/plan.json"));
  ExpectFailure(this->Apply({ Fragment(2), Volume(1) }), 2, "history: id 1 was given before");
  ExpectFailure(this->Apply(json::array()), 2, "it holds no edits");
  ExpectFailure(
    this->Apply(json::array({ { { "remove", 7 } } })), 2, "object 7: the plan has none");
  json wrong = Fragment(2);
  wrong["object"]["Erika"] = 1;
  ExpectFailure(
    this->Apply(json::array({ wrong })), 2, "plan: a key of edits[0].object is unknown");
  this->WriteText("edits.json", "{");
  ExpectFailure(this->Plan({ "--apply", this->Path("edits.json") }), 2, "edits: no JSON");
  ExpectFailure(this->Plan({ "--apply", this->Path("no.json") }), 2, "no such file");
  EXPECT_EQ(ReadBytes(this->Path("case.hasp/plan.json")), before);
}

TEST_F(HaspPlan, WrongUseIsOneAndSaysWhatToDo)
{
  ExpectFailure(this->Plan({}), 2, "no such file or folder");
  ExpectFailure(this->Plan({ "--new", "--case", std::string("a\nb") }), 1, "caseLabel holds");
  EXPECT_FALSE(fs::exists(this->Path("case.hasp")));
  ASSERT_EQ(this->Plan({ "--new" }).exitCode, 0);
  ExpectFailure(this->Plan({ "--new" }), 1, "the plan is there already");
  ExpectFailure(this->Plan({ "--case", "K-17" }), 1, "--case goes with --new");
  ExpectFailure(this->Plan({ "--undo", "--redo" }), 1, "one at a time");
  ExpectFailure(this->Plan({ "--undo" }), 1, "the plan has no step to undo");
  ExpectFailure(this->Plan({ "--redo" }), 1, "the plan has no step to redo");
  ExpectFailure(this->Plan({ "--export", "1" }), 1, "--export needs --output");
  ExpectFailure(
    this->Plan({ "--export", "1", "--output", this->Path("a.stl") }), 1, "nothing is made of it");
  ExpectFailure(RunHasp({ "plan", this->Path("case.hasp/plan.json"), "--undo" }), 1,
    "plan.json alone is only read");
  ExpectFailure(RunHasp({ "plan", this->Path("no/case.hasp"), "--new" }), 1,
    "the plan's folder cannot be made");
}

TEST_F(HaspPlan, DamageIsFoundAndNamed)
{
  ASSERT_EQ(this->Plan({ "--new" }).exitCode, 0);
  this->WriteText("labels.nrrd", "labels");
  const HaspRun kept = this->Plan({ "--blob", this->Path("labels.nrrd") });
  const std::string hash = kept.out.substr(0, 64);
  ASSERT_TRUE(fs::exists(this->Path("case.hasp/blobs/" + hash))) << kept.out << kept.err;
  const json segmentation{ { "id", 2 }, { "name", "" }, { "volume", 1 }, { "labels", hash } };
  ASSERT_EQ(
    this->Apply({ Volume(1), { { "add", "segmentation" }, { "object", segmentation } } }).exitCode,
    0);
  EXPECT_EQ(this->Plan({ "--check" }).exitCode, 0);
  this->WriteText("case.hasp/blobs/" + hash, "labelz");
  ExpectFailure(this->Plan({ "--check" }), 3, "blobs/" + hash.substr(0, 12) + " is damaged");
  std::string text = ReadBytes(this->Path("case.hasp/plan.json"));
  text[text.size() / 2] ^= 1;
  this->WriteText("case.hasp/plan.json", text);
  ExpectFailure(this->Plan({ "--check" }), 3, "plan.json is damaged");
  ExpectFailure(this->Plan({}), 2, "plan.json is damaged");
}

/// The README's plan: of the phantom that it says, and one that can be made.
TEST_F(HaspPlan, ThePhantomsEditsAreForThatPhantom)
{
  ASSERT_EQ(
    RunHasp({ "phantom", "--spacing", "1,1,1", "--output", this->Path("head.mha") }).exitCode, 0);
  const json passport = json::parse(RunHasp({ "info", this->Path("head.mha"), "--json" }).out);
  const json edits = json::parse(ReadBytes(HASP_PLAN_EDITS));
  EXPECT_EQ(edits.at("edits")[0].at("object").at("hash"), passport.at("passport").at("hash"));
  ASSERT_EQ(this->Plan({ "--new" }).exitCode, 0);
  const json made = Shown(this->Plan({ "--apply", HASP_PLAN_EDITS, "--json" }));
  ExpectFailure(
    RunHasp({ "info", this->Path("case.hasp") }), 2, "it is a plan, all that is decided");
  EXPECT_EQ(made.at("objects").size(), 9U);
  EXPECT_EQ(made.at("parts").size(), 5U);
}

/// Likewise of head and leg, each a scan of its own.
TEST_F(HaspPlan, TheTransplantsEditsAreForThosePhantoms)
{
  const json edits = json::parse(ReadBytes(HASP_TRANSPLANT_EDITS));
  const auto isOf = [&](std::size_t volume, const std::vector<std::string>& more)
  {
    std::vector<std::string> words{ "phantom", "--spacing", "1,1,1", "--output",
      this->Path("scan.mha") };
    words.insert(words.end(), more.begin(), more.end());
    ASSERT_EQ(RunHasp(words).exitCode, 0);
    const json passport = json::parse(RunHasp({ "info", this->Path("scan.mha"), "--json" }).out);
    EXPECT_EQ(
      edits.at("edits")[volume].at("object").at("hash"), passport.at("passport").at("hash"));
  };
  isOf(0, {});
  isOf(1, { "--anatomy", "fibula" });
  ASSERT_EQ(this->Plan({ "--new" }).exitCode, 0);
  const json made = Shown(this->Plan({ "--apply", HASP_TRANSPLANT_EDITS, "--json" }));
  EXPECT_EQ(made.at("objects").size(), 11U);
  ASSERT_EQ(made.at("parts").size(), 6U);
  EXPECT_EQ(made.at("parts")[5].at("kind"), "mitre-guide");
}

} // namespace
