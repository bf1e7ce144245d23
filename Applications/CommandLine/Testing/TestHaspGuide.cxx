#include "HaspProcess.h"

#include "Grid/Phantom.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

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

class HaspGuide : public HaspTest
{
protected:
  /// A band over the phantom's left frontal bone.
  static json Recipe()
  {
    const hasp::PhantomSettings settings;
    json landmarks = json::array();
    glm::dvec3 outward(0.0);
    for (const double left : { 0.25, 0.40, 0.55 })
    {
      const glm::dvec3 direction = glm::normalize(glm::dvec3(left, -1.0, 0.6));
      const glm::dvec3 p = hasp::PhantomOuterTable(settings, direction);
      landmarks.push_back({ p.x, p.y, p.z });
      outward += direction;
    }
    outward = glm::normalize(outward);
    return { { "format", "hasp-guide-recipe-1" }, { "note", "" }, { "isovalue", 226 },
      { "landmarks", landmarks }, { "outline", "open" },
      { "withdrawal", { outward.x, outward.y, outward.z } }, { "gapMm", 0.4 },
      { "thicknessMm", 3.0 }, { "widthMm", 14.0 }, { "spacingMm", 0.7 },
      { "ignoreBelowMm3", 100.0 }, { "slots", json::array() }, { "holes", json::array() } };
  }
  HaspRun Guide(const json& recipe, const std::vector<std::string>& more = {})
  {
    this->WriteText("recipe.json", recipe.dump());
    std::vector<std::string> words{ "guide", this->Path("head.mha"), "--recipe",
      this->Path("recipe.json"), "--output", this->Path("guide.stl") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  void FinePhantom()
  {
    ASSERT_EQ(
      RunHasp({ "phantom", "--spacing", "2,2,2", "--output", this->Path("head.mha") }).exitCode, 0);
  }
};

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
  EXPECT_EQ(certificate.at("closed"), true);
  EXPECT_EQ(certificate.at("manifold"), true);
  EXPECT_EQ(certificate.at("self_intersections"), 0);
  EXPECT_GE(certificate.at("share_within"), 0.95);
  EXPECT_TRUE(certificate.at("faults").empty());
  // 80 bytes, a count, and 50 bytes a triangle.
  EXPECT_EQ(ReadBytes(this->Path("guide.stl")).size(),
    84u + 50u * certificate.at("triangles").get<std::size_t>());
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
  const json& resources = document.at("resources");
  const auto skipped = std::find_if(resources.begin(), resources.end(),
    [](const json& resource) { return resource.at("resource") == "certificate"; });
  ASSERT_NE(skipped, resources.end());
  EXPECT_EQ(skipped->at("ms"), 0.0);
}

} // namespace
