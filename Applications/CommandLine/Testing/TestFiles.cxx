#include "Failure.h"
#include "Files.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace
{

namespace fs = std::filesystem;

class Files : public testing::Test
{
protected:
  Files() : folder(fs::temp_directory_path() / ("hasp-files-" + std::to_string(getpid())))
  {
    fs::create_directories(this->folder);
  }
  ~Files() override { fs::remove_all(this->folder); }

  std::string Path(const std::string& name) const { return (this->folder / name).string(); }
  std::string Read(const std::string& name) const
  {
    std::ifstream file(this->folder / name);
    return { std::istreambuf_iterator<char>(file), {} };
  }
  std::ptrdiff_t Count() const
  {
    return std::distance(fs::directory_iterator(this->folder), fs::directory_iterator());
  }

  fs::path folder;
};

TEST_F(Files, OneFileIsFoundUnderAnyOfItsNames)
{
  const std::string one = this->Path("x.png");
  const auto same = [&](const std::string& other)
  {
    try
    {
      hasp::RequireDifferent(one, other, "--a and --b");
      return false;
    }
    catch (const hasp::Failure& failed)
    {
      return std::string(failed.what()).find("--a and --b are one file") != std::string::npos;
    }
  };
  EXPECT_TRUE(same(one)); // not there yet
  EXPECT_TRUE(same(this->Path("./x.png")));
  EXPECT_TRUE(same(fs::relative(one).string()));
  EXPECT_FALSE(same(this->Path("y.png")));
  fs::create_directory_symlink(this->folder, this->folder / "again");
  EXPECT_TRUE(same(this->Path("again/x.png")));
  std::ofstream(one) << "x";
  fs::create_hard_link(one, this->folder / "y.png");
  EXPECT_TRUE(same(this->Path("y.png")));
}

TEST_F(Files, WhatCannotBeWrittenLeavesNothing)
{
  EXPECT_THROW(hasp::RequireWritable(this->Path("none/x.png"), {}), hasp::Failure);
  EXPECT_THROW(hasp::RequireWritable(this->Path("x.png"), { ".stl" }), hasp::Failure);
  EXPECT_THROW(hasp::RequireWritable(this->folder.string(), {}), hasp::Failure);
  EXPECT_THROW(hasp::RequireWritable("/dev/null", {}), hasp::Failure);
  EXPECT_THROW(hasp::RequireWritable(this->Path(std::string(300, 'x')), {}), hasp::Failure);
  // Its owner may write there, says the system, and then takes no file.
  EXPECT_THROW(hasp::RequireWritable("/proc/x.html", {}), hasp::Failure);
  EXPECT_THROW(hasp::RequireWritableFolder("/proc/x"), hasp::Failure);
  EXPECT_NO_THROW(hasp::RequireWritable(this->Path("x.png"), {}));
  EXPECT_NO_THROW(hasp::RequireWritableFolder(this->Path("x")));
  EXPECT_THROW(hasp::WriteFile(this->Path("none/x"), "text"), hasp::Failure);
  fs::create_directories(this->folder / "taken" / "inner");
  EXPECT_THROW(hasp::WriteFile(this->Path("taken"), "text"), hasp::Failure);
  EXPECT_EQ(this->Count(), 1); // the folder made above
}

TEST_F(Files, AFileIsReplacedAsAWhole)
{
  hasp::WriteFile(this->Path("x"), "a long old text");
  hasp::WriteFile(this->Path("x"), std::string("a\0b", 3));
  EXPECT_EQ(this->Read("x"), std::string("a\0b", 3));
  fs::permissions(this->folder / "x", fs::perms::owner_read | fs::perms::owner_write);
  hasp::WriteFile(this->Path("x"), "new");
  EXPECT_EQ(fs::status(this->folder / "x").permissions(), // as open as the old one, not more
    fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(this->Count(), 1);
}

/// Where nobody can say what is there, any name is free: writing then says why it cannot. (A link
/// to itself, for root reads every folder.)
TEST_F(Files, AFreeNameInAFolderThatCannotBeReadIsRefusedByWriting)
{
  fs::create_symlink("loop", this->folder / "loop");
  std::string name;
  ASSERT_NO_THROW(name = hasp::FreeName(this->Path("loop/hasp-view"), ".png"));
  EXPECT_EQ(name, this->Path("loop/hasp-view-1.png"));
  try
  {
    hasp::RequireWritable(name, { ".png" });
    FAIL();
  }
  catch (const hasp::Failure& failure)
  {
    const std::string said = failure.what();
    EXPECT_EQ(said.find("cannot write the .png file: its folder cannot be reached: "), 0U) << said;
    EXPECT_NE(said.find("; nothing was written"), std::string::npos) << said;
    EXPECT_EQ(said.find("loop/"), std::string::npos) << said;
  }
}

TEST_F(Files, FreeNamesCountOnFromWhatIsThere)
{
  hasp::WriteFile(this->Path("a-1.png"), "x");
  fs::create_directories(this->folder / "a-2.png");
  EXPECT_EQ(hasp::FreeName(this->Path("a"), ".png"), this->Path("a-3.png"));
}

TEST_F(Files, ErrorsOfLibrariesThatHoldPathsAreCut)
{
  try
  {
    fs::create_directories(this->Path("x"));
    fs::resize_file(this->Path("x"), 1); // a folder has no size
    FAIL();
  }
  catch (const std::exception& error)
  {
    EXPECT_NE(std::string(error.what()).find(this->Path("x")), std::string::npos) << error.what();
    EXPECT_EQ(hasp::SafeText(error).find("hasp-files"), std::string::npos);
    EXPECT_NE(hasp::SafeText(error).find("directory"), std::string::npos);
  }
}

TEST_F(Files, FailuresCallAFileByItsEnding)
{
  try
  {
    hasp::RequireInput(this->Path("Erika.mha"));
    FAIL();
  }
  catch (const hasp::Failure& failure)
  {
    EXPECT_EQ(failure.what(), std::string("the .mha file: no such file or folder; check the path"));
  }
}

} // namespace
