// What a plan keeps of runs: edits made meanwhile, reports, recipes; and what is said of it.
#include "RunFixture.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace
{

/// A plan's file, its JSON changed, its seal made anew.
class HaspRunKept : public HaspRunTest
{
protected:
  /// `--blob` hashes and keeps any bytes.
  std::string Keep(const std::string& bytes)
  {
    this->WriteText("blob", bytes);
    return this->Plan({ "--blob", this->Path("blob") }).out.substr(0, 64);
  }
  /// Takes this for the report on an object's part.
  void ForgeReport(int object, const json& report)
  {
    const std::string plan = this->Path("case.hasp/plan.json"), hash = this->Keep(report.dump());
    std::string text = ReadBytes(plan);
    const json document = json::parse(text);
    for (const json& part : document.at("parts"))
      if (part.at("object") == object)
      {
        const std::string old = part.at("report");
        text.replace(text.find(old), old.size(), hash);
      }
    text.resize(text.rfind(",\n  \"sha256\""));
    const std::string seal = this->Keep(text);
    this->WriteText("case.hasp/plan.json", text + ",\n  \"sha256\": \"" + seal + "\"\n}\n");
  }
};

TEST_F(HaspRunKept, EditsThatAreMadeMeanwhileStay)
{
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  const std::size_t before = this->Names().size();
  const pid_t child = StartHasp({ "run", this->Path("case.hasp"), "--volume", this->Path("leg.mha"),
                                  "--output", this->Path("out") },
    ends[1]);
  close(ends[1]);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (this->Names().size() == before && std::chrono::steady_clock::now() < end)
    std::this_thread::yield(); // until the folder is under way: the plan has been read
  EXPECT_EQ(this->Names().size(), before + 1);
  const json edited = this->Apply(json::array({ { { "caseLabel", "K-18" } } }));
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  close(ends[0]);
  EXPECT_EQ(status, 0);
  const json now = json::parse(this->Plan({ "--json" }).out);
  EXPECT_EQ(now.at("hash"), edited.at("hash"));
  EXPECT_FALSE(now.at("undo").is_null());
  EXPECT_EQ(this->OutOfDate(), std::vector<int>{});
}

TEST_F(HaspRunKept, ReportsAreNotSaidAsTheyStand)
{
  ASSERT_EQ(this->Make("first", this->Scan()).exitCode, 0);
  json report{ { "verdict", "green" }, { "volume_mm3", 1 }, { "faults", json::array() },
    { "object", "Erika" }, { "file", "Erika" }, { "sha256", "Erika" }, { "other", "Erika" } };
  this->ForgeReport(9, report);
  const std::string other = this->Path("other.stl");
  this->WriteText("other.stl", "of somebody else");
  report["certificate"] = { { "verdict", "Erika" }, { "Erika", 1 }, { "file", other },
    { "sha256", "" }, { "planned", { { "file", other }, { "sha256", "" } } } };
  report["segments"] = { { { "triangles", 1 }, { "position_mm", { 0, 0, 0 } },
    { "orientation", { 1, 0, 0, 0 } }, { "on_donor", report["certificate"] } } };
  report["faults"] = { "Erika" };
  this->ForgeReport(9, report);
  ASSERT_EQ(this->Make("forged", {}).exitCode, 0); // looks for Erika in what is said
  const std::string run = this->Files("forged").at("run.json");
  ASSERT_EQ(this->Make("ply", { "--format", "ply" }).exitCode, 0);
  EXPECT_EQ(ReadBytes(other), "of somebody else");
  EXPECT_EQ(this->Files("ply").at("run.json").find("Erika"), std::string::npos);
  EXPECT_EQ(run.find("Erika"), std::string::npos);
  EXPECT_EQ(json::parse(run).at("parts")[4].at("file"), "guide-9.stl");

  report["verdict"] = "red";
  report["faults"] = { "Erika" };
  report["certificate"]["faults"] = { { { "kind", "Erika" }, { "text", "Erika" },
                                        { "at", nullptr } },
    { { "kind", "slot" }, { "text", "slots[3] of Erika" }, { "at", { 1, 2, 3 } } } };
  this->ForgeReport(9, report);
  const HaspRun red = this->Make("red", {});
  ExpectFailure(red, 3, "guide 9: it does not hold");
  EXPECT_NE(red.err.find("guide 9: slots[3]: a slot is not as claimed at (1.0, 2.0, 3.0) mm"),
    std::string::npos)
    << red.err;
  const HaspRun shown = this->Plan({ "--show" }),
                exported = this->Plan({ "--export", "9", "--output", this->Path("part.stl") });
  EXPECT_NE(shown.out.find("DOES NOT HOLD:\n  it does not hold"), std::string::npos) << shown.out;
  ExpectFailure(exported, 3, "guide 9 does not hold; --force exports it");
  EXPECT_EQ((shown.out + exported.err).find("Erika"), std::string::npos);

  report["verdict"] = "Erika";
  this->ForgeReport(9, report);
  ExpectFailure(this->Plan({ "--export", "9", "--output", this->Path("part.stl") }), 2,
    "the report on it is none that Hasp wrote");
  const HaspRun anew = this->Make("anew", this->Scan());
  EXPECT_EQ(anew.exitCode, 0) << anew.err;
  EXPECT_NE(
    anew.err.find("guide 9 is made anew: the report on it is none that"), std::string::npos);
  EXPECT_EQ(this->Files("anew"), this->Files("first"));
}

TEST_F(HaspRunKept, ACutThatPartsNothingIsNamed)
{
  json narrow = Cut(20);
  narrow["blade"]["widthMm"] = 6;
  this->Apply(json::array({ { { "change", "cut" }, { "object", narrow } } }));
  const std::string warning = "cut 3 does not part the bone: fragment 4 has what is on both";
  const HaspRun run = this->Make("out", this->Scan());
  EXPECT_NE(run.err.find(warning), std::string::npos) << run.err;
  EXPECT_NE(this->Plan({}).out.find(warning), std::string::npos);
}

TEST_F(HaspRunKept, PartsCanBeHeldToTheirRecipesByHand)
{
  const HaspRun run = this->Make("first", this->Scan());
  ASSERT_EQ(run.exitCode, 0);
  EXPECT_NE(run.out.find(" mm3, green\n"), std::string::npos) << run.out;
  EXPECT_LT(run.out.find(" mm3") - run.out.find("made, "), 16U) << run.out; // one decimal
  const HaspRun held = RunHasp({ "certify", this->Path("first/guide-6.stl"), "--bone",
    this->Path("leg.mha"), "--recipe", this->Path("first/guide-6.json"), "--json" });
  EXPECT_EQ(held.exitCode, 0) << held.err;
  EXPECT_EQ(json::parse(held.out).at("certificate").at("slots").size(), 1U); // of the plan's cut
  ASSERT_EQ(this
              ->Plan({ "--export", "6", "--output", this->Path("part.stl"), "--recipe",
                this->Path("part.json") })
              .exitCode,
    0);
  EXPECT_EQ(ReadBytes(this->Path("part.json")), ReadBytes(this->Path("first/guide-6.json")));
  ExpectFailure(this->Plan({ "--export", "4", "--output", this->Path("4.stl"), "--recipe",
                  this->Path("4.json") }),
    1, "fragment 4: it has no recipe");
  EXPECT_FALSE(fs::exists(this->Path("4.stl")));
  ExpectFailure(this->Plan({ "--recipe", this->Path("a.json") }), 1, "--recipe goes with --export");
}

TEST_F(HaspRunKept, PagesAreMadeOfAllThatIsCertified)
{
  std::vector<std::string> words = this->Scan();
  ASSERT_EQ(this->Make("first", words).exitCode, 0);
  words.insert(words.end(), { "--html", this->Path("pages"), "--json" });
  EXPECT_EQ(Made(this->Make("second", words)), (std::vector<int>{ 6, 9, 7 })); // they need the bone
  EXPECT_EQ(this->Files("second"), this->Files("first"));
  const auto pages = this->Files("pages");
  ASSERT_EQ(pages.size(), 3U);
  const std::string hash =
    json::parse(ReadBytes(this->Path("first/run.json"))).at("parts")[3].at("sha256");
  EXPECT_NE(pages.at("guide-6.html").find(hash), std::string::npos);
  EXPECT_TRUE(pages.contains("plate-7.html") && pages.contains("guide-9.html"));
}

TEST_F(HaspRunKept, WarningsOfScansAreSaid)
{
  std::string text = ReadBytes(this->Path("leg.mha"));
  const auto from = text.find("Offset = "), to = text.find('\n', from);
  ASSERT_LT(to, text.find("ElementDataFile"));
  this->WriteText("leg.mha", text.erase(from, to + 1 - from));
  const json passport = json::parse(RunHasp({ "info", this->Path("leg.mha"), "--json" }).out);
  const json volume{ { "id", 1 }, { "name", "" }, { "hash", passport.at("passport").at("hash") } };
  this->Apply(json::array({ { { "change", "volume" }, { "object", volume } } }));
  const HaspRun run = this->Make("out", this->Scan());
  EXPECT_NE(run.err.find("The file says no position"), std::string::npos) << run.err;
}

TEST_F(HaspRunKept, OldDamageIsPruned)
{
  ASSERT_EQ(this->Make("first", this->Scan()).exitCode, 0);
  this->Apply(json::array({ { { "change", "cut" }, { "object", Cut(18) } } }));
  ASSERT_EQ(this->Make("moved", this->Scan()).exitCode, 0);
  const json old = json::parse(ReadBytes(this->Path("first/run.json"))).at("parts")[0];
  const std::string blob = old.at("sha256");
  this->WriteText("case.hasp/blobs/" + blob, "damaged");
  ExpectFailure(this->Plan({ "--check" }), 3, "--prune mends it");
  const HaspRun pruned = this->Plan({ "--prune" });
  EXPECT_EQ(pruned.exitCode, 0) << pruned.err;
  EXPECT_EQ(pruned.out.substr(0, 8), "5 parts ") << pruned.out;
  EXPECT_FALSE(fs::exists(this->Path("case.hasp/blobs/" + blob)));
  EXPECT_EQ(this->Plan({ "--check" }).exitCode, 0);
  EXPECT_EQ(this->OutOfDate(), std::vector<int>{});
}

} // namespace
