// Pictures of a volume without a surface: the brightest values, and translucent skin and bone.
#include "RenderFixture.h"

namespace
{

class HaspRenderVolume : public RenderFixture
{
protected:
  HaspRenderVolume() { this->Phantom(); }

  HaspRun Show(const std::string& mapper, const Words& more, const std::string& output = "out.png",
    const std::string& input = "head.mha") const
  {
    Words words{ "render", this->Path(input), "--mapper", mapper, "--resolution", "120,90",
      "--output", this->Path(output) };
    words.insert(words.end(), more.begin(), more.end());
    return RunHasp(words);
  }
  std::string Drawn(const std::string& mapper, const Words& more) const
  {
    const HaspRun run = this->Show(mapper, more);
    EXPECT_EQ(run.exitCode, 0) << run.err;
    return ReadBytes(this->Path("out.png"));
  }
  /// A MetaImage of bytes.
  void WriteVolume(const std::string& name, const std::string& size, const std::string& spacing,
    const std::string& samples) const
  {
    this->WriteText(name, "ObjectType = Image\nNDims = 3\nDimSize = " + size +
                            "\nElementSpacing = " + spacing +
                            "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + samples);
  }
};

TEST_F(HaspRenderVolume, NoIsovalueIsAskedForAndTheWindowIsSaid)
{
  const HaspRun run = this->Show("mip", { "--explain" });
  ASSERT_EQ(run.exitCode, 0) << run.err;
  EXPECT_NE(run.out.find("--mapper mip; window -1000 to "), std::string::npos) << run.out; // no HU
  EXPECT_EQ(this->Show("composite", {}).exitCode, 0);
  ExpectFailure(this->Show("mesh", {}), 1, "--isovalue is required");
}

TEST_F(HaspRenderVolume, WindowIsovalueAndColorChangeThePicture)
{
  const std::string plain = this->Drawn("mip", {});
  EXPECT_EQ(this->Drawn("mip", {}), plain);
  EXPECT_NE(this->Drawn("mip", { "--window", "0,1500" }), plain);
  EXPECT_NE(this->Drawn("mip", { "--color", "1,0,0" }), plain);
  EXPECT_NE(this->Drawn("mip", { "--view", "right" }), plain);
  const std::string bone = this->Drawn("composite", {});
  EXPECT_NE(this->Drawn("composite", { "--isovalue", "226" }), bone);
  EXPECT_NE(this->Drawn("composite", { "--color", "1,0,0" }), bone);
  EXPECT_NE(bone, plain);
}

TEST_F(HaspRenderVolume, WhatWouldDoNothingIsRefused)
{
  const auto refuse = [&](const std::string& mapper, const Words& more, const std::string& words)
  { ExpectFailure(this->Show(mapper, more), 1, words); };
  refuse("mip", { "--isovalue", "226" }, "--window says what is dark");
  refuse("mip", { "--ignore-below", "10" }, "leave them out");
  refuse("composite", { "--window", "0,1000" }, "--window is for --mapper mip");
  refuse("cells", { "--isovalue", "226", "--window", "0,1000" }, "--window is for --mapper mip");
  refuse("composite", { "--isovalue", "9000" }, "values run from -1000 to ");
  for (const std::string mapper : { "mip", "composite" })
  {
    refuse(mapper, { "--ambient-occlusion", "9" }, "leave them out");
    refuse(mapper, { "--shadows" }, "leave them out");
    refuse(mapper, { "--renderer", "rasterize" }, "leave them out");
    refuse(mapper, { "--compact" }, "leave them out");
    refuse(mapper, { "--blend-normals" }, "leave them out");
  }
  EXPECT_EQ(this->Names(), (Words{ "head.mha" }));
}

TEST_F(HaspRenderVolume, AWindowMustHoldSomeOfTheValues)
{
  for (const std::string window : { "5,5", "7,3", "nan,3", "0,inf" })
    ExpectFailure(this->Show("mip", { "--window", window }), 1, "low must be below high");
  for (const std::string window : { "-3000,-1000", "9000,9500" })
    ExpectFailure(this->Show("mip", { "--window", window }), 1, "values run from -1000 to ");
  ExpectFailure(this->Show("mip", { "--window", "5" }), 1, "--window");
  this->WriteVolume("same.mha", "4 4 4", "1 1 1", std::string(64, '\5'));
  ExpectFailure(this->Show("mip", {}, "x.png", "same.mha"), 2, "all values are the same");
  EXPECT_EQ(this->Show("mip", { "--window", "0,9" }, "x.png", "same.mha").exitCode, 0);
}

TEST_F(HaspRenderVolume, CellsAreNoVolume)
{
  ASSERT_EQ(RunHasp({ "cells", this->Path("head.mha"), "--isovalue", "226", "--output",
                      this->Path("head.hcells") })
              .exitCode,
    0);
  for (const std::string mapper : { "mip", "composite" })
    ExpectFailure(this->Show(mapper, {}, "x.png", "head.hcells"), 1, "are for volumes");
}

TEST_F(HaspRenderVolume, FlatAndLongVolumesAreDrawn)
{
  std::string samples;
  for (int n = 0; n < 600; ++n)
    samples += static_cast<char>(n % 200);
  this->WriteVolume("flat.mha", "30 20 1", "1 1 3", samples);
  this->WriteVolume("long.mha", "10 10 6", "0.1 0.1 10", samples);
  this->WriteVolume("empty.mha", "10 10 6", "1 1 1", std::string(599, '\0') + '\1');
  const HaspRun nothing =
    this->Show("mip", { "--window", "200,255" }, "nothing.png", "long.mha"); // 199 is the most
  ExpectFailure(nothing, 1, "--window shows nothing");
  this->Show("mip", {}, "empty.png", "empty.mha");
  for (const std::string mapper : { "mip", "composite" })
    for (const std::string view : { "front", "top" })
      for (const std::string input : { "flat.mha", "long.mha" })
      {
        const HaspRun run = this->Show(mapper, { "--view", view }, "out.png", input);
        EXPECT_EQ(run.exitCode, 0) << run.err;
        // More than a background alone, which a PNG packs into a few bytes.
        EXPECT_GT(
          ReadBytes(this->Path("out.png")).size(), ReadBytes(this->Path("empty.png")).size())
          << mapper << view << input;
      }
}

/// VTK would say it on standard output, and draw nothing.
TEST_F(HaspRenderVolume, MoreSamplesThanATextureTakesAreSaid)
{
  this->WriteVolume("long.mha", "40000 2 2", "1 1 1", std::string(159999, '\0') + '\1');
  for (const std::string mapper : { "composite", "vtk" })
    ExpectFailure(this->Show(mapper, { "--isovalue", "0.5" }, "x.png", "long.mha"), 4,
      "40000 samples along one axis, and this OpenGL takes");
  const HaspRun run = this->Show("mip", {}, "x.png", "long.mha");
  ExpectFailure(run, 4, "crop it, or take --mapper mesh");
  EXPECT_EQ(run.out, "");
}

} // namespace
