#pragma once
#include "CanaryFiles.h"
#include "HaspProcess.h"

#include <sys/inotify.h>
#include <unistd.h>

#include <cstdlib>

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
    this->ExpectNoneTwice({ "compare", path, path });
    for (const std::string ending : { "x.mha", "x.vti", "x.nrrd", "x.nii", "x.nii.gz", "x.seg.nrrd",
           "slices", "x.stl", "x.unknown" })
      this->ExpectNone({ "convert", path, this->OutFile(ending) });
    this->ExpectNoneTwice(
      { "cells", path, "--isovalue", "0", "--output", this->OutFile("x.hcells") });
#if HASP_WITH_SEGMENTATION
    this->ExpectNoneTwice({ "segment", path, "--threshold", "0", "--output",
      this->OutFile("x.seg.nrrd"), "--write-recipe", this->OutFile("x.json") });
#endif
#if HASP_WITH_PICTURES
    this->ExpectNoneTwice({ "render", path, "--isovalue", "0", "--resolution", "40,30", "--output",
      this->OutFile("x.png") });
#endif
#if HASP_WITH_GUIDES
    this->ExpectNoneTwice(
      { "guide", path, "--recipe", this->Recipe(), "--output", this->OutFile("x.stl"), "--check" });
    this->ExpectNoneTwice(
      { "mirror", path, "--isovalue", "1", "--output", this->OutFile("x.stl") });
    this->ExpectNoneTwice(
      { "fracture", "--volume", path, "--bone", "60", "--output", this->OutFile("x") });
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
