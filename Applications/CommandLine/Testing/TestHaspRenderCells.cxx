#include "OlderOpenGL.h"
#include "RenderFixture.h"

#include <filesystem>

namespace
{

using HaspRenderCells = RenderFixture;

TEST_F(HaspRenderCells, ActiveCellsAreDrawnWithoutTheVolume)
{
  this->Phantom();
  ASSERT_EQ(RunHasp({ "cells", this->Path("head.mha"), "--isovalue", "226", "--output",
                      this->Path("head.hcells") })
              .exitCode,
    0);
  ASSERT_EQ(this->Render({}, "volume.png").exitCode, 0);
  std::filesystem::remove(this->Path("head.mha"));
  const auto draw = [&](const Words& more)
  {
    Words words{ "render", this->Path("head.hcells"), "--resolution", "120,90", "--output",
      this->Path("cells.png") };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  };
  for (const Words& words : { Words{ "--isovalue", "226" }, Words{ "--ignore-below", "5" },
         Words{ "--mapper", "mesh" }, Words{ "--series", "1" } })
    ExpectFailure(draw(words), 1, "for volumes");
  ExpectFailure(draw({ "--surface", this->Path("head.hcells") }), 2, "isosurface, no triangles");
  this->WriteText("named.mha", ReadBytes(this->Path("head.hcells")));
  ExpectFailure(RunHasp({ "render", this->Path("named.mha"), "--output", this->Path("x.png") }), 2,
    "isosurface, no volume: rename it");
  const HaspRun run = draw({});
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_EQ(ReadBytes(this->Path("cells.png")), ReadBytes(this->Path("volume.png")));
  ExpectFailure(RunHasp({ "render", this->Path("none.mha"), "--output", this->Path("x.png") }), 1,
    "--isovalue");
}

TEST_F(HaspRenderCells, BothRenderersDrawTheSameSurface)
{
  this->Phantom();
  const HaspRun traced = this->Render({ "--renderer", "trace", "--explain" }, "trace.png");
  if (!HASP_WITH_EMBREE)
    return ExpectFailure(traced, 1, "HASP_ENABLE_EMBREE");
  ASSERT_EQ(traced.exitCode, 0) << traced.err;
  EXPECT_NE(traced.out.find("traced picture"), std::string::npos) << traced.out;
  const HaspRun drawn = this->Render({ "--renderer", "rasterize", "--explain" }, "raster.png");
  ASSERT_EQ(drawn.exitCode, 0) << drawn.err;
  EXPECT_NE(drawn.out.find("active cells, GPU"), std::string::npos) << drawn.out;
  const double ratio = double(ReadBytes(this->Path("trace.png")).size()) /
                       double(ReadBytes(this->Path("raster.png")).size());
  EXPECT_NEAR(ratio, 1.0, 0.02); // alike to a few pixels; the mapper's own tests compare them
  ExpectFailure(this->Render({ "--renderer", "magic" }), 1, "one of");
}

TEST_F(HaspRenderCells, LightTakesRaysAndChangesThePicture)
{
  this->Phantom();
  ExpectFailure(this->Render({ "--shadows", "--renderer", "rasterize" }), 1,
    "--ambient-occlusion and --shadows");
  for (const std::string mapper : { "mesh", "vtk", "raycast" })
    ExpectFailure(
      this->Render({ "--ambient-occlusion", "9", "--mapper", mapper }), 1, "leave them");
  ExpectFailure(this->Render({ "--ambient-occlusion", "0" }), 1, "--ambient-occlusion");
  const HaspRun plain = this->Render({ "--explain" }, "plain.png");
  ASSERT_EQ(plain.exitCode, 0) << plain.err;
  const HaspRun lit =
    this->Render({ "--ambient-occlusion", "9", "--shadows", "--explain" }, "lit.png");
  if (!HASP_WITH_EMBREE)
    return ExpectFailure(lit, 4, "Embree");
  ASSERT_EQ(lit.exitCode, 0) << lit.err;
  EXPECT_NE(lit.out.find("light cache"), std::string::npos) << lit.out;
  EXPECT_NE(ReadBytes(this->Path("lit.png")), ReadBytes(this->Path("plain.png")));
  // Ray caching draws the same cells where light is asked for.
  const HaspRun cells = this->Render({ "--shadows" }, "cells.png");
  const HaspRun rays = this->Render({ "--shadows", "--mapper", "raycaching" }, "rays.png");
  ASSERT_EQ(rays.exitCode, 0) << rays.err;
  EXPECT_EQ(ReadBytes(this->Path("rays.png")), ReadBytes(this->Path("cells.png")));
}

TEST_F(HaspRenderCells, OnAnOlderOpenGLRaysDrawThem)
{
  this->Phantom();
  const EnvironmentScope mesa(MesasOpenGL);
  const HaspRun truth = this->Render({ "--renderer", "trace" }, "truth.png");
  const EnvironmentScope older(OlderOpenGL);
  if (!HASP_WITH_EMBREE)
    return ExpectFailure(this->Render({}), 4, "this window has 3.3");
  ASSERT_EQ(truth.exitCode, 0) << truth.err;
  const std::string needs = "rasterising needs OpenGL 4.3, and this window has 3.3";
  for (const std::string mapper : { "cells", "raycast" })
  {
    const HaspRun run = this->Render({ "--mapper", mapper, "--explain" });
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_NE(run.out.find("traced: " + needs), std::string::npos) << run.out;
    EXPECT_EQ(run.err.find("Active cells stand in") != std::string::npos, mapper == "raycast");
    EXPECT_EQ(ReadBytes(this->Path("out.png")), ReadBytes(this->Path("truth.png"))) << mapper;
  }
  ExpectFailure(this->Render({ "--renderer", "rasterize" }), 4,
    needs + "; the renderer automatic traces rays on the CPU instead");
}

/// A mask: its isosurface is all terraces.
TEST_F(HaspRenderCells, BlendedNormalsSmoothTerraces)
{
  std::string samples;
  for (int n = 0; n < 24 * 24 * 24; ++n)
  {
    const int x = n % 24 - 12, y = n / 24 % 24 - 12, z = n / 576 - 12;
    samples += x * x + y * y + z * z < 90 ? '\1' : '\0';
  }
  this->WriteText("mask.mha", "ObjectType = Image\nNDims = 3\nDimSize = 24 24 24\nElementSpacing "
                              "= 1 1 1\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
                                samples);
  const auto draw = [&](const Words& more, const std::string& output)
  {
    Words words{ "render", this->Path("mask.mha"), "--isovalue", "0.5", "--resolution", "120,90",
      "--explain", "--output", this->Path(output) };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  };
  const auto bytesOfBlending = [](const HaspRun& run)
  { return std::stol(run.out.substr(run.out.find("normal blending") + 15)); };
  const HaspRun plain = draw({ "--renderer", "rasterize" }, "plain.png");
  const HaspRun blended = draw({ "--blend-normals" }, "blended.png");
  ASSERT_EQ(plain.exitCode, 0) << plain.err;
  ASSERT_EQ(blended.exitCode, 0) << blended.err;
  EXPECT_EQ(bytesOfBlending(plain), 0);
  EXPECT_GE(bytesOfBlending(blended), 24 * 120 * 90); // its least, a pixel
  // Fewer edges are fewer bytes of PNG; the mapper's own tests hold its shading.
  EXPECT_NE(ReadBytes(this->Path("plain.png")), ReadBytes(this->Path("blended.png")));
  for (const Words& words :
    { Words{ "--renderer", "trace" }, Words{ "--shadows" }, Words{ "--ambient-occlusion", "9" } })
  {
    Words all{ "--blend-normals" };
    all.insert(all.end(), words.begin(), words.end());
    ExpectFailure(draw(all, "x.png"), 1, "--blend-normals is drawn by OpenGL");
  }
  ExpectFailure(draw({ "--blend-normals", "--mapper", "mesh" }, "x.png"), 1, "--mapper cells");
}

/// All that the picture shows was met by rays, and the cells' own picture is the same.
TEST_F(HaspRenderCells, AStillPictureByRayCachingTakesFewFrames)
{
  this->Phantom();
  for (const std::string stereo : { "mono", "side-by-side" })
  {
    Words words{ "--renderer", "rasterize", "--stereo", stereo, "--explain" };
    const HaspRun cells = this->Render(words, "cells.png");
    ASSERT_EQ(cells.exitCode, 0) << cells.err;
    words.insert(words.end(), { "--mapper", "raycaching" });
    const HaspRun rays = this->Render(words, "rays.png");
    ASSERT_EQ(rays.exitCode, 0) << rays.err;
    EXPECT_NE(rays.out.find("cache: asked for"), std::string::npos) << rays.out;
    EXPECT_NE(rays.out.find("which held 100.00 %"), std::string::npos) << rays.out;
    const std::size_t at = rays.out.find("frames of each: ");
    ASSERT_NE(at, std::string::npos) << rays.out;
    EXPECT_LE(std::stoi(rays.out.substr(at + 16)), 4) << rays.out;
    const double ratio = double(ReadBytes(this->Path("rays.png")).size()) /
                         double(ReadBytes(this->Path("cells.png")).size());
    EXPECT_NEAR(ratio, 1.0, 0.02); // coarser cells far away change a few pixels
  }
}

TEST_F(HaspRenderCells, CompactCellsAreSmallerAndOnlyForCells)
{
  this->Phantom();
  const auto bytesOfCells = [&](const HaspRun& run)
  {
    const std::size_t at = run.out.find("active cells, host");
    return at == std::string::npos ? 0 : std::stol(run.out.substr(at + 18));
  };
  const HaspRun exact = this->Render({ "--explain" }, "exact.png");
  const HaspRun compact = this->Render({ "--compact", "--explain" }, "compact.png");
  ASSERT_EQ(compact.exitCode, 0) << compact.err;
  EXPECT_GT(bytesOfCells(compact), 0);
  EXPECT_LT(bytesOfCells(compact), bytesOfCells(exact));
  ExpectFailure(this->Render({ "--compact", "--mapper", "mesh" }), 1, "--mapper cells");
  ExpectFailure(
    this->Render({ "--renderer", "rasterize", "--mapper", "mesh" }), 1, "--mapper cells");
}

} // namespace
