#include "GuideRecipeFixture.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

namespace
{

using nlohmann::json;

using HaspGuide = GuideRecipeTest;

TEST_F(HaspGuide, OptionsThatWouldDoNothingAreRefused)
{
  this->Phantom();
  this->WriteText("recipe.json", Recipe().dump());
  const auto preview = [this](const std::vector<std::string>& more)
  {
    std::vector<std::string> words{ "guide", this->Path("head.mha"), "--recipe",
      this->Path("recipe.json"), "--preview", this->Path("field.mha") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  };
  ExpectFailure(preview({ "--check" }), 1, "--check excludes --preview");
  ExpectFailure(preview({ "--force" }), 1, "--force excludes --preview");
  ExpectFailure(preview({ "--html", this->Path("a.html") }), 1, "--html excludes --preview");
  ExpectFailure(this->Guide(Recipe(), { "--least-share", "0.9" }), 1, "--check");
  ExpectFailure(this->Guide(Recipe(), { "--case-label", "Erika" }), 1, "the recipe has none");
  ExpectFailure(this->Guide(Recipe(), { "--side", "left" }), 1, "the recipe has none");
  ExpectFailure(RunHasp({ "certify", this->Path("guide.stl"), "--bone", this->Path("head.mha"),
                  "--insertion-axis", "0,0,1" }),
    1, "--recipe");
  EXPECT_EQ(this->Names(), (std::vector<std::string>{ "head.mha", "recipe.json" }));
}

#if !HASP_WITH_LIB3MF
TEST_F(HaspGuide, WithoutLib3mfA3mfFileIsRefusedBeforeTheWork)
{
  this->WriteText("recipe.json", Recipe().dump());
  ExpectFailure(RunHasp({ "guide", this->Path("none.mha"), "--recipe", this->Path("recipe.json"),
                  "--output", this->Path("guide.3mf") }),
    1, "HASP_ENABLE_LIB3MF");
}
#endif

TEST_F(HaspGuide, AMistakeInARecipeIsToldByItsLineAndARecipeOfAnotherKindByItsVerb)
{
  this->Phantom();
  json recipe = Recipe();
  recipe["thicknessmm"] = recipe["thicknessMm"];
  recipe.erase("thicknessMm");
  this->WriteText("recipe.json", recipe.dump(1));
  const std::vector<std::string> words{ "guide", this->Path("head.mha"), "--recipe",
    this->Path("recipe.json"), "--output", this->Path("guide.stl") };
  const std::string text = recipe.dump(1);
  const auto line =
    1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(text.find("thicknessmm")), '\n');
  ExpectFailure(
    RunHasp(words), 2, "guide recipe: a key is unknown, the nearest known is 'thicknessMm'");
  ExpectFailure(RunHasp(words), 2, "(line " + std::to_string(line) + ")");
  this->WriteText("recipe.json", R"({ "format": "hasp-implant-recipe-1" })");
  ExpectFailure(RunHasp(words), 2, "the file is an implant recipe, which hasp implant takes");
}

TEST_F(HaspGuide, BadRecipesAreTwoAndLeaveNothing)
{
  this->Phantom();
  ExpectFailure(RunHasp({ "guide", this->Path("head.mha"), "--recipe", this->Path("no.json"),
                  "--output", this->Path("g.stl") }),
    2, "the .json file: no such file");
  this->WriteText("bad.json", "{");
  ExpectFailure(RunHasp({ "guide", this->Path("head.mha"), "--recipe", this->Path("bad.json"),
                  "--output", this->Path("g.stl") }),
    2, "the .json file: guide recipe: no JSON");
  json recipe = Recipe();
  recipe["gapMm"] = -1;
  ExpectFailure(this->Guide(recipe), 2, "gapMm");
  ExpectFailure(this->Guide(Recipe(), { "--check", "--least-share", "nan" }), 1, "least-share");
  recipe = Recipe();
  recipe["landmarks"][1] = { 900, 900, 900 };
  ExpectFailure(this->Guide(recipe), 2, "landmark");
  EXPECT_EQ(this->Names(), (std::vector<std::string>{ "bad.json", "head.mha", "recipe.json" }));
}

#if HASP_WITH_CGAL
TEST_F(HaspGuide, TheCertificateIsOfTheFileAsWritten)
{
  this->FinePhantom();
  const HaspRun run = this->Guide(Recipe(), { "--check", "--json", "--explain" });
  ASSERT_EQ(run.exitCode, 0) << run.err << run.out;
  const json document = json::parse(run.out);
  const json& certificate = document.at("certificate");
  const json& mesh = certificate.at("mesh");
  EXPECT_EQ(mesh.at("closed"), true);
  EXPECT_EQ(mesh.at("manifold"), true);
  EXPECT_EQ(mesh.at("self_intersections"), 0);
  EXPECT_GE(certificate.at("gap").at("share_within"), 0.95);
  EXPECT_TRUE(certificate.at("faults").empty());
  // 80 bytes, a count, and 50 bytes a triangle.
  EXPECT_EQ(
    ReadBytes(this->Path("guide.stl")).size(), 84u + 50u * mesh.at("triangles").get<std::size_t>());
}
#else
TEST_F(HaspGuide, WithoutCGALNoGuideIsCertified)
{
  this->FinePhantom();
  ExpectFailure(this->Guide(Recipe(), { "--check" }), 3, "self-intersections were not measured");
  EXPECT_FALSE(std::filesystem::exists(this->Path("guide.stl")));
}
#endif

TEST_F(HaspGuide, AGuideThatDoesNotHoldIsThreeAndNotKept)
{
  this->FinePhantom();
  this->WriteText("guide.stl", "old");
  // Nothing on a grid of 1.5 mm is within 0.2 mm everywhere.
  json recipe = Recipe();
  recipe["spacingMm"] = 1.5;
  const HaspRun run = this->Guide(recipe, { "--check", "--json", "--least-share", "1" });
  ExpectFailure(run, 3, "was not kept");
  // Without CGAL there is another fault: that self-intersections were not looked for.
  EXPECT_EQ(json::parse(run.out).at("certificate").at("faults").size(), HASP_WITH_CGAL ? 1u : 2u);
  EXPECT_EQ(ReadBytes(this->Path("guide.stl")), "old");
  EXPECT_EQ(this->Names().size(), 3u);
}

TEST_F(HaspGuide, AGuideThatIsForcedSaysSoInItsFile)
{
  this->FinePhantom();
  ExpectFailure(this->Guide(Recipe(), { "--force" }), 1, "--force is for parts that --check");
  const HaspRun run =
    this->Guide(Recipe(), { "--check", "--force", "--json", "--least-share", "1" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json certificate = json::parse(run.out).at("certificate");
  EXPECT_EQ(certificate.at("passed"), false);
  EXPECT_EQ(certificate.at("forced"), true);
  const std::string stl = ReadBytes(this->Path("guide.stl"));
  EXPECT_NE(stl.substr(0, 80).find("SPACE=LPS; UNIT=mm; DOES NOT HOLD"), std::string::npos);
  EXPECT_EQ(stl.size(), 84u + 50u * certificate.at("mesh").at("triangles").get<std::size_t>());
}

TEST_F(HaspGuide, EveryFormatIsReadBackAndSaysWhatItIs)
{
  this->FinePhantom();
  this->WriteText("recipe.json", Recipe().dump());
  std::vector<std::string> endings{ ".stl", ".ply", ".obj" };
  if (HASP_WITH_LIB3MF)
    endings.push_back(".3mf");
  json first;
  for (const std::string& ending : endings)
  {
    SCOPED_TRACE(ending);
    const std::string file = this->Path("guide" + ending);
    const HaspRun run =
      RunHasp({ "guide", this->Path("head.mha"), "--recipe", this->Path("recipe.json"), "--output",
        file, "--check", "--force", "--json", "--least-share", "1" });
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json mesh = json::parse(run.out).at("certificate").at("mesh");
    if (first.is_null())
      first = mesh;
    EXPECT_EQ(mesh.at("triangles"), first.at("triangles"));
    EXPECT_NEAR(mesh.at("volume_mm3"), first.at("volume_mm3").get<double>(), 0.01);
    const HaspRun info = RunHasp({ "info", file, "--json" });
    ASSERT_EQ(info.exitCode, 0) << info.err;
    const json part = json::parse(info.out).at("passport").at("part");
    EXPECT_EQ(part.at("does_not_hold"), true);
    EXPECT_EQ(part.at("name"), "guide");
    EXPECT_EQ(part.at("hash").get<std::string>().size(),
      HASP_WITH_OPENSSL ? (ending == ".stl" ? 16U : 64U) : 0U);
  }
}

TEST_F(HaspGuide, AnInterruptedCheckLeavesNothing)
{
  this->FinePhantom();
  this->WriteText("recipe.json", Recipe().dump());
  // A pipe with room for the first two steps only: hasp waits in the middle of the third.
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  const int capacity = fcntl(ends[1], F_SETPIPE_SZ, 4096);
  ASSERT_GT(capacity, 0);
  const std::string steps = "hasp: reading the .mha file\nhasp: making the guide\nhasp: ";
  const std::string full(static_cast<std::size_t>(capacity) - steps.size(), '.');
  ASSERT_EQ(write(ends[1], full.data(), full.size()), static_cast<ssize_t>(full.size()));
  const pid_t child =
    StartHasp({ "guide", this->Path("head.mha"), "--recipe", this->Path("recipe.json"), "--output",
                this->Path("guide.stl"), "--check" },
      ends[1]);
  close(ends[1]);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (this->Names().size() < 3 && std::chrono::steady_clock::now() < end)
    std::this_thread::yield();
  EXPECT_EQ(this->Names().size(), 3u); // head.mha, recipe.json and the guide under way
  kill(child, SIGTERM);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  close(ends[0]);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM) << status;
  EXPECT_EQ(this->Names(), (std::vector<std::string>{ "head.mha", "recipe.json" }));
}

TEST_F(HaspGuide, WithoutACheckNoneIsPaidFor)
{
  this->FinePhantom();
  const HaspRun run = this->Guide(Recipe(), { "--json", "--explain" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json document = json::parse(run.out);
  EXPECT_FALSE(document.contains("certificate"));
  EXPECT_NE(run.err.find("the guide is not certified; use --check"), std::string::npos) << run.err;
  const json& resources = document.at("resources");
  const auto skipped = std::find_if(resources.begin(), resources.end(),
    [](const json& resource) { return resource.at("resource") == "certificate"; });
  ASSERT_NE(skipped, resources.end());
  EXPECT_EQ(skipped->at("ms"), 0.0);
}

} // namespace
