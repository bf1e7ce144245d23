#include "CanaryFixture.h"

#include <algorithm>

namespace
{

TEST_F(Canary, TheTokensAreFoundWhereTheyAre)
{
  EXPECT_EQ(canary::TokensIn("hasp: reading the .mha file"), "");
  EXPECT_NE(canary::TokensIn("a QZVKERIKA b"), "");
  EXPECT_NE(canary::TokensIn("\xe9" + canary::Given), "");
  for (const canary::Input& input : canary::MakeVolumes(this->In()))
    EXPECT_NE(canary::TokensIn(ReadBytes(input.path)), "") << input.path; // gzipped ones, too
}

TEST_F(Canary, WithShowNamesTheyAreThere)
{
  const auto inputs = canary::MakeVolumes(this->In());
  const auto mha = std::find_if(inputs.begin(), inputs.end(),
    [](const canary::Input& input) { return input.path.ends_with(".mha"); });
  ASSERT_NE(mha, inputs.end());
  EXPECT_NE(this->TokensAfter({ "info", mha->path, "--show-names" }), "");
  EXPECT_EQ(this->TokensAfter({ "info", mha->path }), "");
  // A segmentation's names are its point: they go on for who shows names, in a compressed file.
  const std::string segmented = this->In() / (canary::Name() + ".seg.nrrd");
  const Words convert{ "convert", segmented, this->OutFile("x.seg.nrrd") };
  EXPECT_EQ(this->TokensAfter(convert), "");
  EXPECT_NE(
    this->TokensAfter({ convert[0], convert[1], convert[2], "--show-names" }).find("in a file"),
    std::string::npos);
  const std::string named = this->OutFile(canary::Name() + ".mha");
  EXPECT_NE(this->TokensAfter({ "convert", mha->path, named }), ""); // the name that was asked for
}

class CanaryVolume : public Canary, public testing::WithParamInterface<int>
{
};
constexpr int Volumes = HASP_WITH_LIBARCHIVE ? 11 : 9;

TEST_P(CanaryVolume, GivesNothingAway)
{
  this->Volume(canary::MakeVolumes(this->In()), Volumes, GetParam());
}
INSTANTIATE_TEST_SUITE_P(Each, CanaryVolume, testing::Range(0, Volumes));

#if HASP_WITH_DICOM
class CanaryDicom : public Canary, public testing::WithParamInterface<int>
{
};
constexpr int Folders = 11;

TEST_P(CanaryDicom, GivesNothingAway)
{
  this->Volume(canary::MakeDicomFolders(this->In()), Folders, GetParam());
}
INSTANTIATE_TEST_SUITE_P(Each, CanaryDicom, testing::Range(0, Folders));
#endif

TEST_F(Canary, SurfacesGiveNothingAway)
{
  for (const canary::Input& input : canary::MakeSurfaces(this->In()))
  {
    int exitCode = -1;
    EXPECT_EQ(this->TokensAfter({ "convert", input.path, this->OutFile("x.ply") }, &exitCode), "");
    EXPECT_EQ(exitCode, 0) << input.path;
    std::vector<std::string> files = Damaged(input.path);
    files.push_back(input.path);
    for (const std::string& file : files)
    {
      for (const std::string to : { "x.stl", "x.ply", "x.obj", "x.mha" })
        this->ExpectNone({ "convert", file, this->OutFile(to) });
      this->ExpectNone({ "evaluate", file, input.path });
      const std::string plan = this->OutFile("x.hasp"); // gone after each run
      RunHasp({ "plan", plan, "--new" });
      this->ExpectNone({ "plan", plan, "--surface", file, "--thickness", "5" });
      RunHasp({ "plan", plan, "--new" });
      RunHasp({ "plan", plan, "--surface", input.path, "--thickness", "5" });
      this->ExpectNone({ "reduce", plan, "--surface", file, "--reference", "2" });
#if HASP_WITH_PICTURES
      const std::string volume = this->folder / "head.mha";
      if (!fs::exists(volume))
        this->Phantom();
      this->ExpectNone({ "render", volume, "--isovalue", "226", "--resolution", "40,30",
        "--surface", file, "--output", this->OutFile("x.png") });
#endif
    }
  }
}

TEST_F(Canary, ActiveCellsGiveNothingAway)
{
  this->Phantom();
  const std::string cells = this->In() / (canary::Name() + ".hcells");
  ASSERT_EQ(
    RunHasp({ "cells", this->Path("head.mha"), "--isovalue", "226", "--output", cells }).exitCode,
    0);
  std::vector<std::string> files = Damaged(cells);
  files.push_back(cells);
  files.push_back(this->In() / (canary::Name() + ".mha")); // under a volume's name
  fs::copy(cells, files.back());
  for (const std::string& file : files)
  {
    this->ExpectNoneTwice({ "info", file });
    this->ExpectNone({ "cells", file, "--isovalue", "0", "--output", this->OutFile("x.hcells") });
    this->ExpectNone({ "convert", file, this->OutFile("x.mha") });
#if HASP_WITH_PICTURES
    this->ExpectNone(
      { "render", file, "--resolution", "40,30", "--output", this->OutFile("x.png") });
#endif
  }
}

TEST_F(Canary, RecipesGiveNothingAway)
{
#if HASP_WITH_GUIDES
  this->Phantom();
  for (const std::string& recipe : Damaged(this->Recipe()))
  {
    this->ExpectNone({ "guide", this->Path("head.mha"), "--recipe", recipe, "--output",
      this->OutFile("x.stl"), "--check", "--html", this->OutFile("x.html") });
    this->ExpectNone(
      { "cut", this->Path("head.mha"), "--cuts", recipe, "--output", this->OutFile("x") });
    this->ExpectNone(
      { "plate", this->Path("head.mha"), "--recipe", recipe, "--output", this->OutFile("x.stl") });
    this->ExpectNone(
      { "transplant", this->Path("head.mha"), "--recipe", recipe, "--output", this->OutFile("x") });
  }
#endif
}

TEST_F(Canary, SegmentationsGiveNothingAway)
{
#if HASP_WITH_SEGMENTATION
  canary::MakeVolumes(this->In());
  const std::string name = this->In() / canary::Name(), seeds = name + "-seeds.json",
                    markups = name + ".mrk.json", recipe = name + "-recipe.json";
  canary::WriteTo(seeds, R"({ "format": "hasp-seeds-1", "labels": [{ "label": 2, "name": ")" +
                           canary::Name() + R"(", "colour": "#ff0000",
"strokes": [{ "radiusMm": 2, "points": [[5, 7, 7]] }, { "radiusMm": 2, "points": [[90, 7, 7]] }] }] })");
  canary::WriteTo(markups, R"({ "markups": [{ "type": "Line", "name": ")" + canary::Name() +
                             R"(", "controlPoints": [{ "label": ")" + canary::Name() +
                             R"(", "description": ")" + canary::Family +
                             R"(", "position": [5, 7, 7] }, { "position": [7, 7, 7] }] }] })");
  canary::WriteTo(recipe, R"({ "format": "hasp-segmentation-1", "steps":
[{ "step": "merge", "from": 1, "into": 2 }], "names": [{ "label": 2, "name": ")" +
                            canary::Name() + R"(", "colour": "#ff0000" }] })");
  const Words segment{ "segment", name + ".mha", "--output", this->OutFile("x.mha") };
  for (const auto& [file, before] :
    std::vector<std::pair<std::string, Words>>{ { seeds, { "--threshold", "0", "--seeds" } },
      { markups, { "--threshold", "0", "--seeds" } },
      { recipe, { "--labels", name + ".seg.nrrd", "--recipe" } },
      { name + ".seg.nrrd", { "--recipe", recipe, "--labels" } } })
  {
    Words words = segment;
    words.insert(words.end(), before.begin(), before.end());
    words.push_back(file);
    int exitCode = -1;
    EXPECT_EQ(this->TokensAfter(words, &exitCode), "") << file;
    EXPECT_EQ(exitCode, 0) << file; // else this would test nothing
    this->ExpectNoneTwice(words);
    for (const std::string& damaged : Damaged(file))
    {
      words.back() = damaged;
      this->ExpectNone(words);
    }
  }
  EXPECT_GT(this->FilesSeen, 8);
#endif
}

TEST_F(Canary, CertificatesGiveNothingAway)
{
#if HASP_WITH_GUIDES
  this->Phantom();
  const int before = this->FilesSeen;
  for (const canary::Input& input : canary::MakeSurfaces(this->In()))
    for (const std::string& recipe : Words{ "", this->Recipe() })
    {
      Words words{ "certify", input.path, "--bone", this->Path("head.mha"), "--html",
        this->OutFile("x.html") };
      if (!recipe.empty())
        words.insert(words.end(), { "--recipe", recipe });
      this->ExpectNoneTwice(words);
    }
  EXPECT_GT(this->FilesSeen, before + 3); // pages, most of parts that do not hold
#endif
}

} // namespace
