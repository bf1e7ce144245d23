#include "CanaryFiles.h"
#include "HaspProcess.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace
{

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Runs verbs on files full of tokens and looks for them in all that comes out: both streams, each
/// file written, compressed or not, and the name of each file that was there for a moment.
class Canary : public HaspTest
{
protected:
  Canary()
  {
    fs::create_directories(this->In());
    fs::create_directories(this->Out());
    const char* old = std::getenv("TMPDIR");
    this->OldTemporary = old ? old : "";
    setenv("TMPDIR", this->Out().c_str(), 1); // whoever makes files elsewhere makes them here
    this->Watch = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    EXPECT_GE(inotify_add_watch(this->Watch, this->Out().c_str(), IN_CREATE | IN_MOVED_TO), 0);
  }
  ~Canary() override
  {
    close(this->Watch);
    if (this->OldTemporary.empty())
      unsetenv("TMPDIR");
    else
      setenv("TMPDIR", this->OldTemporary.c_str(), 1);
  }
  fs::path In() const { return this->folder / canary::Name(); }
  fs::path Out() const { return this->folder / "out"; }
  std::string OutFile(const std::string& name) const { return (this->Out() / name).string(); }

  /// All tokens that a run left, in streams, files and names. Its files are removed.
  std::string TokensAfter(const Words& words, int* exitCode = nullptr)
  {
    const HaspRun run = RunHasp(words);
    if (exitCode)
      *exitCode = run.exitCode;
    EXPECT_LT(run.exitCode, 5) << "it crashed: " << words.front();
    std::string found = canary::TokensIn(run.out + "\n" + run.err);
    if (!found.empty())
      found += "in: " + run.out + run.err;
    for (const auto& entry : fs::recursive_directory_iterator(this->Out()))
      if (entry.is_regular_file())
      {
        ++this->FilesSeen;
        if (const std::string inside = canary::TokensIn(ReadBytes(entry.path().string()));
            !inside.empty())
          found += "in a file " + entry.path().extension().string() + ": " + inside;
      }
    alignas(inotify_event) char events[1 << 16];
    for (ssize_t got = 0; (got = read(this->Watch, events, sizeof events)) > 0;)
      for (ssize_t at = 0; at < got;)
      {
        const auto* event = reinterpret_cast<const inotify_event*>(events + at);
        if (event->len > 0)
          found += canary::TokensIn(event->name);
        ++this->NamesSeen;
        at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
      }
    for (const auto& entry : fs::directory_iterator(this->Out()))
      fs::remove_all(entry.path());
    return found;
  }
  void ExpectNone(const Words& words)
  {
    EXPECT_EQ(this->TokensAfter(words), "") << testing::PrintToString(words);
  }
  /// As text, and as JSON with resources.
  void ExpectNoneTwice(Words words)
  {
    this->ExpectNone(words);
    words.insert(words.end(), { "--json", "--explain" });
    this->ExpectNone(words);
  }
  /// The input itself and copies that are cut off or hold faults.
  static std::vector<std::string> Damaged(const std::string& path)
  {
    std::vector<std::string> copies;
    for (const int fault : { 0, 1, 2, 3 })
    {
      const fs::path from(path),
        to = from.parent_path() / (std::to_string(fault) + from.filename().string());
      fs::copy(from, to, fs::copy_options::recursive);
      const fs::path file = fs::is_directory(to) ? fs::directory_iterator(to)->path() : to;
      std::string bytes = ReadBytes(file.string());
      if (fault == 0)
        bytes.resize(bytes.size() * 6 / 10);
      else if (fault == 1)
        bytes.resize(bytes.size() - 1);
      else // a fault in the header, behind what says the kind of file
        for (std::size_t at = 20 * fault; at < bytes.size() / 2; at += 97 * fault)
          bytes[at] = static_cast<char>(bytes[at] ^ (fault == 2 ? 1 : 0x55));
      canary::WriteTo(file, bytes);
      copies.push_back(to.string());
    }
    return copies;
  }
  void VolumeVerbs(const std::string& path)
  {
    this->ExpectNoneTwice({ "info", path });
    for (const std::string ending : { "x.mha", "x.vti", "x.nrrd", "x.nii", "x.nii.gz", "x.seg.nrrd",
           "slices", "x.stl", "x.unknown" })
      this->ExpectNone({ "convert", path, this->OutFile(ending) });
    this->ExpectNoneTwice(
      { "cells", path, "--isovalue", "0", "--output", this->OutFile("x.hcells") });
#if HASP_WITH_PICTURES
    this->ExpectNoneTwice({ "render", path, "--isovalue", "0", "--resolution", "40,30", "--output",
      this->OutFile("x.png") });
#endif
#if HASP_WITH_GUIDES
    this->ExpectNoneTwice(
      { "guide", path, "--recipe", this->Recipe(), "--output", this->OutFile("x.stl"), "--check" });
#endif
  }
  std::string Recipe() const
  {
    const fs::path recipe = this->In() / (canary::Name() + ".json");
    canary::WriteTo(recipe, R"({ "format": "hasp-guide-recipe-1", "note": ")" + canary::Name() +
                              R"(", "isovalue": 0, "landmarks": [[2,7,7],[7,2,7],[7,7,2]],
"outline": "open", "withdrawal": [-0.577350269,-0.577350269,-0.577350269], "gapMm": 0.3,
"thicknessMm": 2, "widthMm": 4, "spacingMm": 0.7, "ignoreBelowMm3": 0, "slots": [], "holes": [] })");
    return recipe.string();
  }
  void Volume(const std::vector<canary::Input>& inputs, int count, int which)
  {
    ASSERT_EQ(inputs.size(), static_cast<std::size_t>(count)) << "not all are tried";
    const canary::Input& input = inputs[which];
    int exitCode = -1;
    EXPECT_EQ(this->TokensAfter({ "info", input.path }, &exitCode), "");
    EXPECT_EQ(exitCode, input.opens ? 0 : 2) << input.path; // else this would test nothing
    if (input.opens)
      this->VolumeVerbs(input.path);
    for (const std::string& damaged : Damaged(input.path))
    {
      this->ExpectNone({ "info", damaged });
      this->ExpectNone({ "convert", damaged, this->OutFile("x.mha") });
    }
    EXPECT_GT(this->FilesSeen, input.opens ? 5 : -1);
    EXPECT_GT(this->NamesSeen, this->FilesSeen);
  }

  std::string OldTemporary;
  int Watch = -1, FilesSeen = 0, NamesSeen = 0;
};

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
  for (const std::string& file : files)
  {
    this->ExpectNoneTwice({ "info", file });
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
    this->ExpectNone({ "guide", this->Path("head.mha"), "--recipe", recipe, "--output",
      this->OutFile("x.stl"), "--check" });
#endif
}

} // namespace
