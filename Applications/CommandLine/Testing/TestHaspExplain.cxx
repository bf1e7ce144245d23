#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <map>

namespace
{

using nlohmann::json;

class HaspExplain : public HaspTest
{
protected:
  /// The resources of one picture by name.
  std::map<std::string, json> Resources(const std::vector<std::string>& more)
  {
    return this->Resources(more, { this->Phantom(), "--isovalue", "226" });
  }
  std::map<std::string, json> Resources(
    const std::vector<std::string>& more, const std::vector<std::string>& input)
  {
    std::vector<std::string> words{ "render", "--resolution", "60,60", "--output",
      this->Path("x.png"), "--explain", "--json" };
    words.insert(words.end(), input.begin(), input.end());
    words.insert(words.end(), more.begin(), more.end());
    const HaspRun run = RunHasp(words);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    std::map<std::string, json> byName;
    const json document = json::parse(run.out);
    for (const json& resource : document.at("resources"))
    {
      EXPECT_TRUE(byName.emplace(resource.at("resource"), resource).second) << "listed twice";
      EXPECT_FALSE(resource.at("reason").get<std::string>().empty());
    }
    return byName;
  }
  static void ExpectSkipped(const std::map<std::string, json>& resources, const std::string& name)
  {
    ASSERT_TRUE(resources.contains(name)) << name;
    EXPECT_EQ(resources.at(name).at("bytes"), 0) << name;
    EXPECT_EQ(resources.at(name).at("ms"), 0.0) << name;
  }
  static void ExpectBuilt(const std::map<std::string, json>& resources, const std::string& name)
  {
    ASSERT_TRUE(resources.contains(name)) << name;
    EXPECT_GT(resources.at(name).at("bytes"), 0) << name;
    EXPECT_GT(resources.at(name).at("ms"), 0.0) << name;
  }
};

TEST_F(HaspExplain, MonoHasNoSecondEye)
{
  const auto resources = this->Resources({});
  ExpectSkipped(resources, "second eye");
  ExpectSkipped(resources, "surfaces");
  ExpectBuilt(resources, "volume");
  ExpectBuilt(resources, "picture");
}

TEST_F(HaspExplain, StereoPaysForTheSecondEye)
{
  ExpectBuilt(this->Resources({ "--stereo", "anaglyph" }), "second eye");
}

TEST_F(HaspExplain, TheMeshMapperMakesNoCells)
{
  const auto resources = this->Resources({ "--mapper", "mesh" });
  ExpectBuilt(resources, "mesh");
  ExpectSkipped(resources, "active cells");
}

TEST_F(HaspExplain, VtksMapperMakesNeitherMeshNorCells)
{
  const auto resources = this->Resources({ "--mapper", "vtk" });
  ExpectSkipped(resources, "mesh");
  ExpectSkipped(resources, "active cells");
  EXPECT_EQ(resources.at("volume, GPU").at("bytes"), resources.at("volume").at("bytes"));
}

TEST_F(HaspExplain, SamplesGoToTheGPUOnlyWhereTheyAreShown)
{
  for (const std::string mapper : { "cells", "raycaching", "raycast", "mesh" })
    ExpectSkipped(this->Resources({ "--mapper", mapper }), "volume, GPU");
  for (const std::string mapper : { "mip", "composite" })
  {
    const auto resources = this->Resources({ "--mapper", mapper }, { this->Phantom() });
    ExpectSkipped(resources, "mesh");
    ExpectSkipped(resources, "active cells");
    EXPECT_EQ(resources.at("volume, GPU").at("bytes"), resources.at("volume").at("bytes"));
  }
}

TEST_F(HaspExplain, TheCellMapperMakesNoMeshAndNoPickingBuffers)
{
  const auto resources = this->Resources({ "--mapper", "cells" });
  ExpectSkipped(resources, "mesh");
  ExpectSkipped(resources, "picking buffers");
  ExpectSkipped(resources, "shader: cell selection");
  // By OpenGL or by rays, as the mapper chooses; one picture never takes both.
  const bool traced = resources.at("ray tracing tree").at("bytes") > 0;
  ExpectBuilt(resources, traced ? "ray tracing tree" : "active cells, GPU");
  ExpectSkipped(resources, traced ? "active cells, GPU" : "ray tracing tree");
}

TEST_F(HaspExplain, CellsThatAreGivenAreListedOnceAndNothingIsExtracted)
{
  const auto extracted = this->Resources({});
  ASSERT_EQ(RunHasp({ "cells", this->Path("head.mha"), "--isovalue", "226", "--output",
                      this->Path("head.hcells") })
              .exitCode,
    0);
  const auto given = this->Resources({}, { this->Path("head.hcells") });
  ExpectSkipped(given, "min-max blocks");
  EXPECT_NE(given.at("min-max blocks").at("reason"), extracted.at("min-max blocks").at("reason"));
  EXPECT_EQ(
    given.at("active cells, host").at("bytes"), extracted.at("active cells, host").at("bytes"));
  EXPECT_EQ(given.at("reading active cells").at("bytes"), 0); // they are the host's
  EXPECT_GT(given.at("reading active cells").at("ms"), 0.0);
  ExpectSkipped(given, "cell labels, host");
  EXPECT_EQ(given.at("cell labels, host").at("reason"), "the input has none");
}

TEST_F(HaspExplain, TheTableSaysTheSame)
{
  const HaspRun run = RunHasp({ "info", this->Phantom(), "--explain" });
  EXPECT_EQ(run.exitCode, 0);
  EXPECT_NE(run.out.find("bytes"), std::string::npos);
  EXPECT_NE(run.out.find("volume"), std::string::npos);
}

} // namespace
