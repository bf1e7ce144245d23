// Light that all surfaces share: what is drawn, and what is refused.
#include "RenderFixture.h"

#include <filesystem>

namespace
{

class HaspRenderLight : public RenderFixture
{
protected:
  /// A map of 16 x 8 pixels, brighter above.
  std::string Map() const
  {
    std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n";
    for (int n = 0; n < 8 * 16; ++n)
      text += { char(200), char(180), char(160), char(132 - n / 16) };
    return text;
  }
  void Part() const
  {
    this->WriteText("part.stl", "solid part\nfacet normal 0 -1 0\nouter loop\nvertex -40 -130 -20\n"
                                "vertex 40 -130 -20\nvertex 0 -130 60\nendloop\nendfacet\n"
                                "endsolid part\n");
  }
};

TEST_F(HaspRenderLight, PathsLightThePhantomAndTwiceTheSame)
{
  this->Phantom();
  const HaspRun lit = this->Render({ "--path-trace", "3", "--explain" }, "lit.png");
  if (!HASP_WITH_EMBREE)
    return ExpectFailure(lit, 4, "Embree");
  ASSERT_EQ(lit.exitCode, 0) << lit.err;
  EXPECT_NE(lit.out.find("3 samples a pixel"), std::string::npos) << lit.out;
  EXPECT_NE(lit.out.find("1 bodies; 0 opaque"), std::string::npos) << lit.out;
  const HaspRun plain = this->Render({ "--explain" }, "plain.png");
  ASSERT_EQ(plain.exitCode, 0) << plain.err;
  EXPECT_NE(plain.out.find("each has its own"), std::string::npos) << plain.out;
  EXPECT_EQ(plain.out.find("light, trees"), std::string::npos) << plain.out;
  EXPECT_NE(ReadBytes(this->Path("lit.png")), ReadBytes(this->Path("plain.png")));
  ASSERT_EQ(this->Render({ "--path-trace", "3" }, "again.png").exitCode, 0);
  EXPECT_EQ(ReadBytes(this->Path("again.png")), ReadBytes(this->Path("lit.png")));
  for (const Words& other :
    { Words{ "--path-trace", "3", "--bounces", "1" }, Words{ "--path-trace", "4" },
      Words{ "--path-trace", "3", "--shadows" }, Words{ "--path-trace", "3", "--mapper", "mesh" } })
  {
    ASSERT_EQ(this->Render(other, "other.png").exitCode, 0) << other.back();
    EXPECT_NE(ReadBytes(this->Path("other.png")), ReadBytes(this->Path("lit.png"))) << other.back();
  }
}

TEST_F(HaspRenderLight, AnEnvironmentIsReadOrSaidToBeNone)
{
  this->Phantom();
  this->WriteText("sky.hdr", this->Map());
  const auto render = [&](const std::string& name, const std::string& output) {
    return this->Render({ "--path-trace", "2", "--environment", this->Path(name) }, output);
  };
  const HaspRun lit = render("sky.hdr", "map.png");
  if (!HASP_WITH_EMBREE)
    return ExpectFailure(lit, 4, "Embree");
  ASSERT_EQ(lit.exitCode, 0) << lit.err;
  ASSERT_EQ(this->Render({ "--path-trace", "2" }, "daylight.png").exitCode, 0);
  EXPECT_NE(ReadBytes(this->Path("map.png")), ReadBytes(this->Path("daylight.png")));

  ExpectFailure(render("none.hdr", "x.png"), 2, "none.hdr");
  this->WriteText("short.hdr", this->Map().substr(0, 300));
  ExpectFailure(render("short.hdr", "x.png"), 2, "get it again");
  this->WriteText("picture.hdr", "P6 2 2 255\n");
  ExpectFailure(render("picture.hdr", "x.png"), 2, "#?");
  EXPECT_FALSE(std::filesystem::exists(this->Path("x.png"))) << "nothing is left behind";
}

TEST_F(HaspRenderLight, SurfacesShadeEachOther)
{
  this->Phantom();
  this->Part();
  const Words both{ "--surface", this->Path("part.stl"), "--ambient-occlusion", "60", "--shadows" };
  Words explained = both;
  explained.emplace_back("--explain");
  const HaspRun shared = this->Render(explained, "shared.png");
  if (!HASP_WITH_EMBREE)
    return ExpectFailure(shared, 4, "Embree");
  ASSERT_EQ(shared.exitCode, 0) << shared.err;
  EXPECT_NE(shared.out.find("2 bodies; 0 opaque"), std::string::npos) << shared.out;
  const HaspRun alone = this->Render({ "--ambient-occlusion", "60", "--shadows", "--explain" });
  ASSERT_EQ(alone.exitCode, 0) << alone.err;
  EXPECT_NE(alone.out.find("light cache"), std::string::npos) << alone.out;
  EXPECT_EQ(alone.out.find("light, trees"), std::string::npos) << alone.out;
}

TEST_F(HaspRenderLight, WhatDoesNotGoTogetherIsRefused)
{
  this->Phantom();
  ExpectFailure(this->Render({ "--environment", "sky.hdr" }), 1, "--path-trace");
  ExpectFailure(this->Render({ "--bounces", "2" }), 1, "--path-trace");
  ExpectFailure(this->Render({ "--path-trace", "0" }), 1, "--path-trace");
  ExpectFailure(this->Render({ "--path-trace", "2", "--bounces", "65" }), 1, "--bounces");
  ExpectFailure(this->Render({ "--path-trace", "2", "--blend-normals" }), 1, "--blend-normals");
  ExpectFailure(this->Render({ "--path-trace", "2", "--ambient-occlusion", "25" }), 1, "leave out");
  for (const std::string mapper : { "vtk", "mip", "raycast", "raycaching" })
    ExpectFailure(
      this->Render({ "--path-trace", "2", "--mapper", mapper }), 1, "--mapper cells and mesh");
}

} // namespace
