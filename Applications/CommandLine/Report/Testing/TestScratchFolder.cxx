#include "ScratchFolder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace
{
namespace fs = std::filesystem;

TEST(ScratchFolder, IsOurOwnAndGoneAfterwards)
{
  fs::path place;
  {
    const hasp::ScratchFolder folder, other;
    place = folder.Path();
    EXPECT_NE(place, other.Path());
    EXPECT_EQ(fs::status(place).permissions(), fs::perms::owner_all);
    fs::create_directory(place / "inner");
    std::ofstream(place / "inner" / "file") << "something";
    EXPECT_TRUE(fs::exists(place / "inner" / "file"));
  }
  EXPECT_FALSE(fs::exists(place));
}

} // namespace
