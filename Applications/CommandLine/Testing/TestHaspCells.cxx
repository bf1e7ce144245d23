#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <utility>

namespace
{

using nlohmann::json;
using Words = std::vector<std::string>;

class HaspCells : public HaspTest
{
protected:
  HaspRun Cells(const std::string& in, const std::string& out, const Words& more = {}) const
  {
    Words words{ "cells", this->Path(in), "--isovalue", "226", "--output", this->Path(out) };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
};

TEST_F(HaspCells, WrongUseIsSaidAndWritesNothing)
{
  this->Phantom();
  ExpectFailure(this->Cells("head.mha", "a.mha"), 1, "must end in .hcells");
  ExpectFailure(this->Cells("head.mha", "no/a.hcells"), 1, "does not exist");
  ExpectFailure(this->Cells("none.mha", "a.hcells"), 2, "the .mha file");
  ExpectFailure(RunHasp({ "cells", this->Path("head.mha"), "--isovalue", "99999", "--output",
                  this->Path("a.hcells") }),
    1, "has no surface");
  for (const char* value : { "nan", "inf" })
    ExpectFailure(RunHasp({ "cells", this->Path("head.mha"), "--isovalue", value, "--output",
                    this->Path("a.hcells") }),
      1, "finite");
  ExpectFailure(this->Cells("head.mha", "a.hcells", { "--memory-limit", "0" }), 1, "memory-limit");
  EXPECT_EQ(this->Names(), (Words{ "head.mha" }));
}

TEST_F(HaspCells, WhatTheVolumesFormatIsDoesNotMatter)
{
  this->Phantom();
  const HaspRun run = this->Cells("head.mha", "a.hcells", { "--json", "--explain" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json resources = json::parse(run.out).at("resources");
  EXPECT_EQ(resources.back().at("resource"), "file");
  EXPECT_EQ(resources.back().at("bytes"), std::filesystem::file_size(this->Path("a.hcells")));
  const json cells = json::parse(run.out).at("cells");
  EXPECT_GT(cells.at("cells"), 1000);
  EXPECT_LT(cells.at("mesh_share"), 0.22);
  EXPECT_EQ(cells.at("precision"), "exact");
  EXPECT_EQ(cells.at("isovalue"), 226.0);
  EXPECT_EQ(run.err.find("is loaded"), std::string::npos);
  const std::string truth = ReadBytes(this->Path("a.hcells"));
  EXPECT_EQ(truth.size(), cells.at("bytes").get<std::size_t>() + 224); // the head
  for (const char* name : { "b.nrrd", "b.vti" })
  {
    ASSERT_EQ(RunHasp({ "convert", this->Path("head.mha"), this->Path(name) }).exitCode, 0);
    const HaspRun other = this->Cells(name, "b.hcells");
    ASSERT_EQ(other.exitCode, 0) << other.err;
    EXPECT_EQ(ReadBytes(this->Path("b.hcells")), truth) << name;
    EXPECT_EQ(other.err.find("is loaded") != std::string::npos, std::string(name) == "b.vti");
  }
}

TEST_F(HaspCells, InfoSaysTheSameAndFindsDamage)
{
  this->Phantom();
  const HaspRun made = this->Cells("head.mha", "a.hcells", { "--compact", "--json" });
  ASSERT_EQ(made.exitCode, 0) << made.err;
  const HaspRun info = RunHasp({ "info", this->Path("a.hcells"), "--json" });
  ASSERT_EQ(info.exitCode, 0) << info.err;
  EXPECT_EQ(json::parse(info.out).at("cells"), json::parse(made.out).at("cells"));
  EXPECT_EQ(json::parse(info.out).at("cells").at("precision"), "compact");
  EXPECT_NE(
    RunHasp({ "info", this->Path("a.hcells") }).out.find("times as many"), std::string::npos);
  ExpectFailure(RunHasp({ "info", this->Path("a.hcells"), "--series", "1" }), 1, "for volumes");

  std::string bytes = ReadBytes(this->Path("a.hcells"));
  bytes[bytes.size() / 2] ^= 1;
  this->WriteText("b.hcells", bytes);
  ExpectFailure(RunHasp({ "info", this->Path("b.hcells") }), 2, "the .hcells file: its cells are");
}

TEST_F(HaspCells, WhereAVolumeIsExpectedTheySayWhatTheyAre)
{
  this->Phantom();
  ASSERT_EQ(this->Cells("head.mha", "a.hcells").exitCode, 0);
  this->WriteText("b.mha", ReadBytes(this->Path("a.hcells")));
  this->WriteText("b.stl", ReadBytes(this->Path("a.hcells")));
  const Words before = this->Names();
  const std::string what = "holds active cells of an isosurface, no ";
  const std::pair<const char*, const char*> files[] = {
    { "a.hcells", ": hasp render draws them, hasp info describes them" },
    { "b.mha", ": rename it to end in .hcells" }
  };
  for (const auto& [in, then] : files)
  {
    ExpectFailure(this->Cells(in, "x.hcells"), 2, what + "volume" + then);
    for (const char* out : { "x.nrrd", "x.stl", "slices" })
      ExpectFailure(RunHasp({ "convert", this->Path(in), this->Path(out) }), 2,
        what + "volume and no triangles" + then);
  }
  ExpectFailure(RunHasp({ "info", this->Path("b.mha") }), 2, what + "volume: rename");
  ExpectFailure(RunHasp({ "info", this->Path("b.stl") }), 2, what + "triangles: rename");
  ExpectFailure(
    RunHasp({ "convert", this->Path("head.mha"), this->Path("x.hcells") }), 1, "hasp cells makes");
  EXPECT_EQ(this->Names(), before);
}

TEST_F(HaspCells, AVolumeUnderTheirNameIsToldFromThem)
{
  this->WriteText("a.hcells", ReadBytes(this->Phantom()));
  const std::string words = "the .hcells file: holds no active cells";
  for (const char* rest : { words.c_str(), "its own ending", "hasp cells makes" })
  {
    ExpectFailure(RunHasp({ "info", this->Path("a.hcells") }), 2, rest);
    ExpectFailure(RunHasp({ "convert", this->Path("a.hcells"), this->Path("x.nrrd") }), 2, rest);
    ExpectFailure(this->Cells("a.hcells", "x.hcells"), 2, rest);
  }
  this->WriteText("note.txt", "Dear colleague,\n");
  ExpectFailure(RunHasp({ "info", this->Path("note.txt") }), 2, "active cells .hcells");
}

/// In the words of the command line, which knows of no function.
TEST_F(HaspCells, AVolumeTooLongIsSaid)
{
  this->WriteText("long.mha", "ObjectType = Image\nNDims = 3\nDimSize = 65538 2 2\nElementSpacing "
                              "= 1 1 1\nElementType = MET_UCHAR\n"
                              "ElementDataFile = LOCAL\n" +
                                std::string(65537 * 4, '\0') + std::string(4, '\1'));
  const HaspRun run = RunHasp(
    { "cells", this->Path("long.mha"), "--isovalue", "0.5", "--output", this->Path("x.hcells") });
  ExpectFailure(run, 1, "hasp: the volume has more than 65,537 samples along one axis: crop");
}

TEST_F(HaspCells, ALimitTooSmallIsSaidWithItsBytes)
{
  ASSERT_EQ(
    RunHasp({ "phantom", "--spacing", "1.5,1.5,1.5", "--output", this->Path("big.mha") }).exitCode,
    0);
  ExpectFailure(this->Cells("big.mha", "a.hcells", { "--memory-limit", "1", "--quiet" }), 1,
    "hasp: --memory-limit is 1 MiB, and ");
  ASSERT_EQ(RunHasp({ "convert", this->Path("big.mha"), this->Path("big.vti") }).exitCode, 0);
  ExpectFailure(
    this->Cells("big.vti", "a.hcells", { "--memory-limit", "1" }), 2, "raise the limit");
  ExpectFailure(
    this->Cells("big.vti", "a.hcells", { "--memory-limit", "5" }), 1, "hasp: --memory-limit is 5");
  EXPECT_EQ(this->Cells("big.mha", "a.hcells", { "--memory-limit", "4" }).exitCode, 0);
}

} // namespace
