// Radiance pictures: what is read back, and damage of all kinds.
#include "Light/RadianceFile.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <random>

namespace
{

constexpr int Columns = 40, Rows = 6;
const std::string Header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

glm::vec3 ColorAt(int x, int y)
{
  return { float(x) / 8.0F, float(y * y) * 100.0F, x == 7 ? 1e6F : 0.0F };
}

/// Ward's shared exponent.
std::array<char, 4> Encoded(const glm::vec3& color)
{
  const float largest = std::max({ color.r, color.g, color.b });
  if (largest < 1e-32F)
    return {};
  int exponent = 0;
  const double scale = std::frexp(largest, &exponent) * 256.0 / largest;
  return { char(int(color.r * scale)), char(int(color.g * scale)), char(int(color.b * scale)),
    char(exponent + 128) };
}

std::string Plain(int columns = Columns)
{
  std::string text;
  for (int y = 0; y < Rows; ++y)
    for (int x = 0; x < columns; ++x)
    {
      const auto pixel = Encoded(ColorAt(x, y));
      text.append(pixel.data(), 4);
    }
  return text;
}

/// Runs of 3 or more, and what is plain between them.
std::string Runs()
{
  std::string text;
  for (int y = 0; y < Rows; ++y)
  {
    text += { 2, 2, 0, char(Columns) };
    for (int channel = 0; channel < 4; ++channel)
      for (int x = 0; x < Columns;)
      {
        const auto at = [&](int n) { return Encoded(ColorAt(n, y))[channel]; };
        int same = 1;
        while (x + same < Columns && at(x + same) == at(x))
          ++same;
        if (same >= 3)
          text += { char(128 + same), at(x) };
        else
          text += { char(1), at(x) };
        x += same >= 3 ? same : 1;
      }
  }
  return text;
}

std::string SizeLine(int columns = Columns)
{
  return "-Y " + std::to_string(Rows) + " +X " + std::to_string(columns) + "\n";
}

class RadianceFile : public ::testing::Test
{
protected:
  std::filesystem::path Path =
    std::filesystem::path(::testing::TempDir()) /
    (std::string("radiance-") + ::testing::UnitTest::GetInstance()->current_test_info()->name() +
      ".hdr");
  ~RadianceFile() override { std::filesystem::remove(this->Path); }

  hasp::EnvironmentMap Read(const std::string& text)
  {
    std::ofstream(this->Path, std::ios::binary) << text;
    return hasp::ReadRadianceFile(this->Path);
  }
  void ExpectRefused(const std::string& text, const std::string& with)
  {
    try
    {
      this->Read(text);
      ADD_FAILURE() << "read, not refused with " << with;
    }
    catch (const std::runtime_error& e)
    {
      EXPECT_NE(std::string(e.what()).find(with), std::string::npos) << e.what();
      EXPECT_EQ(std::string(e.what()).find(this->Path.parent_path().string()), std::string::npos);
    }
  }
};

void ExpectColors(const hasp::EnvironmentMap& map, int columns, float scale = 1.0F)
{
  ASSERT_EQ(map.size, glm::ivec2(columns, Rows));
  for (int y = 0; y < Rows; ++y)
    for (int x = 0; x < columns; ++x)
    {
      const glm::vec3 wanted = ColorAt(x, y) * scale;
      const float largest = std::max({ wanted.r, wanted.g, wanted.b });
      for (int c = 0; c < 3; ++c) // 8 bits of the largest, cut off
        ASSERT_NEAR(map.pixels[std::size_t(y) * columns + x][c], wanted[c], largest / 128.0F)
          << x << " " << y;
    }
}

TEST_F(RadianceFile, ReadsRunsAndPlainPixelsAlike)
{
  ExpectColors(this->Read(Header + SizeLine() + Runs()), Columns);
  ExpectColors(this->Read(Header + SizeLine() + Plain()), Columns);
  ExpectColors(this->Read(Header + SizeLine(3) + Plain(3)), 3);
  ExpectColors(this->Read(Header + SizeLine() + Runs() + "and more"), Columns);
}

TEST_F(RadianceFile, ReadsOldRepeats)
{
  const std::string pixel = { 64, 32, 16, char(129) }, again = { 1, 1, 1, 9 };
  const hasp::EnvironmentMap map = this->Read(Header + "-Y 1 +X 10\n" + pixel + again);
  for (const glm::vec3& color : map.pixels)
    EXPECT_EQ(color, glm::vec3(0.5F, 0.25F, 0.125F));
}

TEST_F(RadianceFile, TakesExposureBackOut)
{
  const std::string header = "#?RGBE\r\n# made by hand\r\nEXPOSURE= 4\r\nEXPOSURE=0.5\r\n\r\n";
  ExpectColors(this->Read(header + SizeLine() + Plain()), Columns, 0.5F);
}

TEST_F(RadianceFile, RefusesWhatIsNone)
{
  this->ExpectRefused("", "header");
  this->ExpectRefused("\x89PNG\r\n\x1a\n and so on\n", "#?");
  this->ExpectRefused(std::string(100'000, 'x'), "Radiance");
  this->ExpectRefused("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n" + SizeLine() + Plain(), "xyze");
  this->ExpectRefused("#?RADIANCE\nEXPOSURE=0\n\n" + SizeLine() + Plain(), "exposure");
  this->ExpectRefused(Header + "+X 40 -Y 6\n" + Plain(), "-Y rows");
  this->ExpectRefused(Header + "-Y 6 +X 40 more\n" + Plain(), "-Y rows");
  this->ExpectRefused(Header + "-Y 0 +X 40\n" + Plain(), "40 x 0");
  this->ExpectRefused(Header + "-Y 9000 +X 40\n" + Plain(), "scale");
  this->ExpectRefused(Header + "-Y 99999999999999 +X 40\n" + Plain(), "size");
  EXPECT_THROW(
    hasp::ReadRadianceFile(this->Path.parent_path() / "nothing-here.hdr"), std::runtime_error);
  EXPECT_THROW(hasp::ReadRadianceFile(this->Path.parent_path()), std::runtime_error);
}

TEST_F(RadianceFile, FindsAFileFarTooShortBeforeMemoryIsTaken)
{
  this->ExpectRefused(Header + "-Y 8192 +X 16384\n" + Runs(), "16384 x 8192");
}

TEST_F(RadianceFile, FindsEachEndThatIsTooEarly)
{
  for (const std::string& body : { Runs(), Plain() })
  {
    const std::string text = Header + SizeLine() + body;
    for (std::size_t length = 0;
         length<text.size(); length += length + 20> text.size() || length < 80 ? 1 : 29)
      EXPECT_THROW(this->Read(text.substr(0, length)), std::runtime_error) << length;
  }
}

TEST_F(RadianceFile, SurvivesDamageOfAllKinds)
{
  std::mt19937 random(7);
  int read = 0;
  for (int n = 0; n < 400; ++n)
  {
    std::string text = Header + SizeLine() + Runs();
    for (int k = 0; k < 1 + n % 4; ++k)
      text[random() % text.size()] = static_cast<char>(random());
    try
    {
      const hasp::EnvironmentMap map = this->Read(text);
      ASSERT_EQ(map.pixels.size(), std::size_t(map.size.x) * std::size_t(map.size.y));
      for (const glm::vec3& color : map.pixels)
        ASSERT_TRUE(color.r >= 0.0F && std::isfinite(color.r + color.g + color.b));
      ++read;
    }
    catch (const std::runtime_error&)
    {
    }
  }
  EXPECT_GT(read, 40); // a changed value of a pixel is no damage that can be seen
  EXPECT_LT(read, 390);
}

} // namespace
