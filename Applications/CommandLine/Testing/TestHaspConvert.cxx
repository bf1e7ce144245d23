#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <thread>

namespace
{

using nlohmann::json;
using Words = std::vector<std::string>;

class HaspConvert : public HaspTest
{
protected:
  HaspRun Convert(const std::string& in, const std::string& out, const Words& more = {}) const
  {
    Words words{ "convert", this->Path(in), this->Path(out) };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
};

TEST_F(HaspConvert, TheInputIsNeverWrittenOver)
{
  const std::string before = ReadBytes(this->Phantom());
  ExpectFailure(this->Convert("head.mha", "./head.mha"), 1, "the same");
  EXPECT_EQ(ReadBytes(this->Path("head.mha")), before);
}

TEST_F(HaspConvert, EveryFormatKeepsEverySampleAndPlace)
{
  this->Phantom();
  std::string from = "head.mha";
  const json truth =
    json::parse(RunHasp({ "info", this->Path(from), "--json" }).out).at("passport").at("hash");
  for (const std::string to : { "a.vti", "a.nrrd", "a.nii", "a.nii.gz", "a.mha" })
  {
    const HaspRun run = this->Convert(from, to, { "--json" }); // a chain: errors would add up
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json document = json::parse(run.out);
    EXPECT_EQ(document.at("compared").at("identical"), true) << to;
    EXPECT_LE(document.at("compared").at("position_mm"), 1e-4) << to;
    EXPECT_EQ(document.at("written").at("hash"), truth) << to;
    EXPECT_EQ(document.at("written").at("bytes"), std::filesystem::file_size(this->Path(to)));
    from = to;
  }
}

#if HASP_WITH_DICOM
TEST_F(HaspConvert, SlicesAreAFolderAndComeBackAsHu)
{
  this->Phantom();
  const HaspRun run = this->Convert("head.mha", "slices/", { "--hounsfield", "--json" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(json::parse(run.out).at("output"), "the folder");
  const json passport =
    json::parse(RunHasp({ "info", this->Path("slices"), "--json" }).out).at("passport");
  EXPECT_EQ(json::parse(run.out).at("written").at("slices"), passport.at("dims").at(2));
  EXPECT_EQ(passport.at("hounsfield"), true);
  EXPECT_EQ(passport.at("format"), "DICOM");
  const HaspRun back = this->Convert("slices", "back.mha", { "--json" });
  ASSERT_EQ(back.exitCode, 0) << back.err;
  EXPECT_EQ(json::parse(back.out).at("lost"), (json{ "modality", "that values are HU" }));
  ExpectFailure(this->Convert("head.mha", "slices"), 1, "not empty");
  ExpectFailure(this->Convert("head.mha", "no/slices"), 1, "does not exist");
  ExpectFailure(
    this->Convert("head.mha", "mr", { "--modality", "MR", "--hounsfield" }), 1, "--modality");
  EXPECT_EQ(this->Names(), (Words{ "back.mha", "head.mha", "slices" }));
}

TEST_F(HaspConvert, RoundingForSlicesIsAsked)
{
  // Two by two by two floats that no 65536 levels hold.
  const float samples[] = { 0.0F, 1.0F, 3.14159F, 2.71828F, 1e5F, 0.5F, -1.0F, 7.25F };
  this->WriteText("f.mha",
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
    "DimSize = 2 2 2\nElementSpacing = 1 1 1\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n" +
      std::string(reinterpret_cast<const char*>(samples), sizeof samples));
  ExpectFailure(this->Convert("f.mha", "slices"), 1, "--quantise");
  const HaspRun run = this->Convert("f.mha", "slices", { "--quantise", "--json" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  const json compared = json::parse(run.out).at("compared");
  EXPECT_EQ(compared.at("identical"), false);
  EXPECT_LE(compared.at("largest_rounding"), 0.5 * 100001.0 / 65535.0 + 1e-2); // float of 1e5
  const HaspRun text = this->Convert("f.mha", "slices2", { "--quantise" });
  EXPECT_NE(text.out.find("samples rounded, by up to "), std::string::npos) << text.out;
}

TEST_F(HaspConvert, WhatTheFormatCannotHoldIsThreeAndNotKept)
{
  // Axes off the right angle by 5e-5, which DICOM cannot say: 2.5 micrometres over these 50 mm.
  this->WriteText("skew.mha",
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
    "DimSize = 2 2 2\nTransformMatrix = 1 0 0 0.00005 1 0 0 0 1\nElementSpacing = 1 50 1\n"
    "ElementType = MET_UCHAR\nElementDataFile = LOCAL\nabcdefgh");
  std::filesystem::create_directory(this->Path("slices"));
  ExpectFailure(this->Convert("skew.mha", "slices"), 3, "mm from their place");
  EXPECT_TRUE(std::filesystem::is_empty(this->Path("slices")));
  EXPECT_EQ(this->Convert("skew.mha", "skew.nrrd").exitCode, 0);
  EXPECT_EQ(this->Names(), (Words{ "skew.mha", "skew.nrrd", "slices" }));
}

TEST_F(HaspConvert, AnInterruptLeavesNothing)
{
  this->Phantom();
  // A pipe with room for two steps: hasp waits where it is to say that it reads the slices back.
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  const int capacity = fcntl(ends[1], F_SETPIPE_SZ, 4096);
  const std::string steps = "hasp: reading the .mha file\nhasp: writing slices\nhasp: ";
  const std::string full(static_cast<std::size_t>(capacity) - steps.size(), '.');
  ASSERT_EQ(write(ends[1], full.data(), full.size()), static_cast<ssize_t>(full.size()));
  const pid_t child =
    StartHasp({ "convert", this->Path("head.mha"), this->Path("slices") }, ends[1]);
  close(ends[1]);
  const auto written = [&]
  {
    for (const auto& entry : std::filesystem::directory_iterator(this->folder))
      if (std::filesystem::exists(entry.path() / "out" / "slice-00029.dcm"))
        return true;
    return false;
  };
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!written() && std::chrono::steady_clock::now() < end)
    std::this_thread::yield();
  EXPECT_TRUE(written());
  kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  close(ends[0]);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
  EXPECT_EQ(this->Names(), (Words{ "head.mha" }));
}
#endif

TEST_F(HaspConvert, SurfacesKeepEveryTriangle)
{
  this->WriteText("a.obj", "v 0 0 0\nv 10 0 0.25\nv 0 10 0\nv 0 0 10\nf 1 2 3\nf 1 4 2\n");
  std::string from = "a.obj";
  for (const std::string to : { "b.ply", "c.stl", "d.obj" })
  {
    const HaspRun run = this->Convert(from, to, { "--json" });
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json document = json::parse(run.out);
    EXPECT_EQ(document.at("compared").at("identical"), true) << to; // quarters are exact in float
    EXPECT_EQ(document.at("written").at("triangles"), 2);
    from = to;
  }
  // float32 keeps 0.01 mm there.
  this->WriteText("far.obj", "v 200000.01 0 0\nv 10 0 0\nv 0 10 0\nf 1 2 3\n");
  ExpectFailure(this->Convert("far.obj", "far.stl"), 3, "mm from their place");
  EXPECT_EQ(this->Convert("far.obj", "far.ply").exitCode, 0);
  this->WriteText("empty.stl", "solid x\nendsolid x\n");
  ExpectFailure(this->Convert("empty.stl", "x.ply"), 2, "the .stl file");
  EXPECT_EQ(this->Names(),
    (Words{ "a.obj", "b.ply", "c.stl", "d.obj", "empty.stl", "far.obj", "far.ply" }));
}

#if HASP_WITH_LIB3MF
TEST_F(HaspConvert, WhatAFileSaysOfItsPartGoesWithIt)
{
  const std::string hash(64, 'a');
  this->WriteText("a.obj",
    "# Hasp 1 SPACE=LPS; UNIT=mm; DOES NOT HOLD; HASH=" + hash +
      "; PART=guide\nv 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  std::string from = "a.obj";
  for (const std::string to : { "b.3mf", "c.3mf", "d.ply", "e.stl" })
  {
    const HaspRun run = this->Convert(from, to);
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const HaspRun info = RunHasp({ "info", this->Path(to), "--json" });
    ASSERT_EQ(info.exitCode, 0) << info.err;
    const json passport = json::parse(info.out).at("passport");
    EXPECT_EQ(passport.at("part").at("does_not_hold"), true) << to;
    EXPECT_EQ(passport.at("part").at("name"), "guide") << to;
    EXPECT_EQ(passport.at("objects").size(), to.ends_with(".3mf") ? 1U : 0U);
    from = to;
  }
  EXPECT_TRUE(ReadBytes(this->Path("b.3mf")) == ReadBytes(this->Path("c.3mf")));
  // An open surface is no body.
  this->WriteText("open.obj", "v 0 0 0\nv 10 0 0\nv 0 10 0\nf 1 2 3\n");
  ExpectFailure(this->Convert("open.obj", "open.3mf"), 1, "not closed");
}
#endif

TEST_F(HaspConvert, WhatIsNoConversionIsOne)
{
  this->Phantom();
  ExpectFailure(this->Convert("head.mha", "bone.stl"), 1, "hasp render draws one, hasp guide");
  ExpectFailure(this->Convert("head.mha", "a.bmp"), 1, "known are .mha, .vti");
  ExpectFailure(this->Convert("head.mha", "a.seg.nrrd"), 1, "no segments");
  ExpectFailure(this->Convert("head.mha", "no/a.mha"), 1, "its folder does not exist");
  ExpectFailure(this->Convert("head.mha", "a.mha", { "--modality", "XA" }), 1, "--modality takes");
  ExpectFailure(this->Convert("none.mha", "a.mha"), 2, "no such file");
  this->WriteText("surface.stl", "solid x\nendsolid x\n");
  ExpectFailure(this->Convert("surface.stl", "a.mha"), 1, "a surface is no volume");
  EXPECT_EQ(this->Names(), (Words{ "head.mha", "surface.stl" }));
}

TEST_F(HaspConvert, TheOldFileIsReplacedAndKeepsItsRights)
{
  this->Phantom();
  this->WriteText("a.nrrd", "old");
  namespace fs = std::filesystem;
  const auto rights = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(this->Path("a.nrrd"), rights);
  const HaspRun run = this->Convert("head.mha", "a.nrrd");
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(run.out.find("identical: every sample"), std::string::npos) << run.out;
  EXPECT_EQ(fs::status(this->Path("a.nrrd")).permissions(), rights);
  EXPECT_EQ(this->Names(), (Words{ "a.nrrd", "head.mha" }));
}

} // namespace
