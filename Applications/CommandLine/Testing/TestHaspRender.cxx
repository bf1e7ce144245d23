#include "RenderFixture.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>

namespace
{

class HaspRender : public RenderFixture
{
protected:
  /// Width and height out of the PNG's header.
  std::pair<int, int> Size(const std::string& name) const
  {
    const std::string png = ReadBytes(this->Path(name));
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const auto number = [&](std::size_t at)
    {
      int value = 0;
      for (std::size_t k = 0; k < 4; ++k)
        value = 256 * value + static_cast<unsigned char>(png.at(at + k));
      return value;
    };
    return { number(16), number(20) };
  }
};

TEST_F(HaspRender, AnIsovalueOutsideTheVolumeNamesItsRange)
{
  this->Phantom();
  for (const std::string value : { "5000", "-1000", "nan" })
    ExpectFailure(RunHasp({ "render", this->Path("head.mha"), "--isovalue", value, "--output",
                    this->Path("x.png") }),
      1, "values run from -1000 to ");
  EXPECT_EQ(this->Names(), (Words{ "head.mha" }));
}

TEST_F(HaspRender, WhatCannotBeWrittenIsOneAndLeavesNothing)
{
  this->Phantom();
  std::filesystem::create_directory(this->folder / "taken.png");
  ExpectFailure(this->Render({}, "none/x.png"), 1, "the .png file: its folder does not exist");
  ExpectFailure(this->Render({}, "taken.png"), 1, "a folder has this name");
  ExpectFailure(this->Render({}, "x.bmp"), 1, "must end in .png");
  const HaspRun system = RunHasp({ "render", this->Path("head.mha"), "--isovalue", "226",
    "--resolution", "9,9", "--output", "/proc/x.png" }); // no one writes there, not even root
  ExpectFailure(system, 1, "cannot write the .png file: its folder takes no file");
  EXPECT_EQ(this->Names(), (Words{ "head.mha", "taken.png" }));
}

/// In the words of the command line, which knows of no function.
TEST_F(HaspRender, AVolumeTooLongForCellsIsSaid)
{
  this->WriteText("long.mha", "ObjectType = Image\nNDims = 3\nDimSize = 65538 2 2\nElementSpacing "
                              "= 1 1 1\nElementType = MET_UCHAR\n"
                              "ElementDataFile = LOCAL\n" +
                                std::string(65537 * 4, '\0') + std::string(4, '\1'));
  ExpectFailure(RunHasp({ "render", this->Path("long.mha"), "--isovalue", "0.5", "--output",
                  this->Path("x.png") }),
    2, "isosurface: the volume has more than 65,537 samples along one axis: crop");
}

TEST_F(HaspRender, AFailureKeepsTheOldPicture)
{
  this->Phantom();
  this->WriteText("out.png", "old");
  this->WriteText("bad.stl", "solid nothing\nendsolid nothing\n");
  ExpectFailure(this->Render({ "--surface", this->Path("bad.stl") }), 2, "surface 1: ");
  ExpectFailure(this->Render({ "--surface", this->Path("no.stl") }), 2, "the .stl file: no such");
  EXPECT_EQ(ReadBytes(this->Path("out.png")), "old");
  EXPECT_EQ(this->Names(), (Words{ "bad.stl", "head.mha", "out.png" }));
}

TEST_F(HaspRender, IgnoringSmallPiecesKeepsTheOthersAndRefusesToKeepNone)
{
  this->Phantom();
  ASSERT_EQ(this->Render({}, "all.png").exitCode, 0);
  ASSERT_EQ(this->Render({ "--ignore-below", "10" }, "large.png").exitCode, 0);
  EXPECT_EQ(ReadBytes(this->Path("all.png")), ReadBytes(this->Path("large.png")));
  ExpectFailure(this->Render({ "--ignore-below", "1e9" }, "none.png"), 2, "lower --ignore-below");
  EXPECT_EQ(this->Names(), (Words{ "all.png", "head.mha", "large.png" }));
}

TEST_F(HaspRender, BrokenSurfacesAreTwoNotInvisible)
{
  this->Phantom();
  const auto stl = [](std::uint32_t declared, float wild)
  {
    const std::array<float, 12> triangle{ 0, 0, 1, 0, 0, 0, 9, 0, 0, 0, wild, 0 };
    std::string bytes(80, ' ');
    bytes.append(reinterpret_cast<const char*>(&declared), 4);
    bytes.append(reinterpret_cast<const char*>(triangle.data()), sizeof triangle).append(2, '\0');
    return bytes;
  };
  this->WriteText("s.stl", stl(1, 9));
  EXPECT_EQ(this->Render({ "--surface", this->Path("s.stl") }).exitCode, 0);
  for (const auto& [bytes, words] : std::vector<std::pair<std::string, std::string>>{
         { stl(2, 9), "too short" }, { stl(4000000000, 9), "too short" },
         { stl(1, std::nanf("")), "no number" }, { stl(1, 3e38F), "kilometre" } })
  {
    this->WriteText("s.stl", bytes);
    ExpectFailure(this->Render({ "--surface", this->Path("s.stl") }), 2, words);
  }
}

TEST_F(HaspRender, ASurfaceLooksTheSameInEveryFormat)
{
  this->Phantom();
  this->WriteText("s.obj", "# SPACE=LPS\nv 0 0 0\nv 90 0 0\nv 0 90 90\nf 1 2 3\n");
  this->WriteText("s.ply",
    "ply\nformat ascii 1.0\ncomment SPACE=LPS\nelement vertex 3\nproperty float x\n"
    "property float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n"
    "0 0 0\n90 0 0\n0 90 90\n3 0 1 2\n");
  this->WriteText("s.stl",
    "solid SPACE=LPS\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 90 0 0\n"
    "vertex 0 90 90\nendloop\nendfacet\nendsolid\n");
  this->WriteText(
    "s.vtp", R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="3" NumberOfPolys="1"><Points>
<DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 90 0 0 0 90 90</DataArray></Points>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>)");
  ASSERT_EQ(this->Render({}, "none.png").exitCode, 0);
  ASSERT_EQ(this->Render({ "--surface", this->Path("s.stl") }, "s.stl.png").exitCode, 0);
  EXPECT_NE(ReadBytes(this->Path("s.stl.png")), ReadBytes(this->Path("none.png")));
  for (const std::string name : { "s.obj", "s.ply", "s.vtp" })
  {
    const HaspRun run = this->Render({ "--surface", this->Path(name) }, name + ".png");
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(
      run.err.find("warning: surface 1: the file does not say") != run.err.npos, name == "s.vtp")
      << run.err;
    EXPECT_TRUE(ReadBytes(this->Path(name + ".png")) == ReadBytes(this->Path("s.stl.png"))) << name;
  }
}

TEST_F(HaspRender, CameraVectorsMustSpanAView)
{
  this->Phantom();
  ExpectFailure(this->Render({ "--camera-direction", "0,0,0" }), 1, "some length");
  ExpectFailure(
    this->Render({ "--camera-direction", "0,0,1", "--view-up", "0,0,-2" }), 1, "parallel");
}

TEST_F(HaspRender, WithoutOpenGLItIsFourAndLeavesNothing)
{
  this->Phantom();
  setenv("HASP_EGL_DEVICE", "99", 1); // a graphics card that is not there
  const HaspRun run = this->Render({});
  unsetenv("HASP_EGL_DEVICE");
  ExpectFailure(run, 4, "cannot draw");
  EXPECT_EQ(this->Names(), (Words{ "head.mha" }));
}

TEST_F(HaspRender, TheLayoutMakesTheSize)
{
  this->Phantom();
  using Size = std::pair<int, int>;
  for (const auto& [layout, size] :
    std::vector<std::pair<std::string, Size>>{ { "mono", { 120, 90 } }, { "left", { 120, 90 } },
      { "side-by-side", { 240, 90 } }, { "top-bottom", { 120, 180 } }, { "anaglyph", { 120, 90 } },
      { "right", { 120, 90 } }, { "interlaced", { 120, 90 } }, { "checkerboard", { 120, 90 } } })
  {
    const HaspRun run = this->Render({ "--stereo", layout });
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(this->Size("out.png"), size) << layout;
  }
}

TEST_F(HaspRender, EyesThatCannotBeAreToldAndNothingIsWritten)
{
  this->Phantom();
  const auto fail = [&](const Words& more, const std::string& words)
  { ExpectFailure(this->Render(more), 1, words); };
  fail({ "--stereo", "dual-window" }, "hasp view");
  fail({ "--stereo", "quad-buffer" }, "hasp view");
  fail({ "--screen", "520" }, "WIDTHxHEIGHT");
  fail({ "--screen", "520x320", "--head-position", "0,0,0" }, "in front of the screen");
  fail({ "--screen", "520x320", "--eye-angle", "3" }, "--eye-angle");
  fail({ "--sketch", this->Path("s.png") }, "--screen");
  fail({ "--eye-separation", "63" }, "--screen");
  fail({ "--screen", "520x320", "--sketch", this->Path("s.jpg") }, ".png");
  fail({ "--screen", "520x320", "--sketch", this->Path("./out.png") },
    "--sketch and --output are one file");
  EXPECT_EQ(this->Names(), (Words{ "head.mha" }));
}

TEST_F(HaspRender, TwoRunsGiveTheSameBytes)
{
  this->Phantom();
  ASSERT_EQ(this->Render({}, "a.png").exitCode, 0);
  ASSERT_EQ(this->Render({}, "b.png").exitCode, 0);
  ASSERT_EQ(this->Render({ "--view", "right" }, "c.png").exitCode, 0);
  EXPECT_EQ(ReadBytes(this->Path("a.png")), ReadBytes(this->Path("b.png")));
  EXPECT_NE(ReadBytes(this->Path("a.png")), ReadBytes(this->Path("c.png")));
}

TEST_F(HaspRender, PathsOfTheWorldAreWritten)
{
  this->Phantom();
  const HaspRun run = this->Render({}, "Снимок é.png");
  EXPECT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(this->Size("Снимок é.png").first, 120);
}

} // namespace
