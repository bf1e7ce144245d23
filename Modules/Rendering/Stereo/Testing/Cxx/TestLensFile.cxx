#include "LensFile.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{

using hasp::LensModel;

constexpr const char* Good = R"({ "format": "hasp-lens-1", "note": "as measured",
  "coefficients": [0.22, 0.24, -0.03], "leftCenter": [0.08, -0.02], "rightCenter": [-0.08, -0.02],
  "colorScale": [0.995, 1, 1.008] })";

std::string Replace(const std::string& from, const std::string& to)
{
  std::string text = Good;
  return text.replace(text.find(from), from.size(), to);
}

TEST(LensFile, RefusesAllButWhatItIs)
{
  EXPECT_THROW(hasp::ParseLens("{"), std::runtime_error);
  EXPECT_THROW(hasp::ParseLens(Replace("0.22", "1e999")), std::runtime_error);
  EXPECT_THROW(hasp::ReadLens("/nowhere/lens.json"), std::runtime_error);
  EXPECT_THROW(hasp::ParseLens("[]"), std::invalid_argument);
  EXPECT_THROW(hasp::ParseLens(Replace("hasp-lens-1", "hasp-lens-2")), std::invalid_argument);
  EXPECT_THROW(hasp::ParseLens(Replace("leftCenter", "leftcenter")), std::invalid_argument);
  EXPECT_THROW(hasp::ParseLens(Replace("[0.22, ", "[")), std::invalid_argument);
  EXPECT_THROW(hasp::ParseLens(Replace("0.22", "\"0.22\"")), std::invalid_argument);
  EXPECT_THROW(hasp::ParseLens(Replace("0.995", "-0.995")), std::invalid_argument);
  EXPECT_THROW(hasp::ParseLens(Replace("\"as measured\"", "3")), std::invalid_argument);
}

TEST(LensFile, SaysNoTextOfTheFile)
{
  for (const std::string& text : { Replace("note", "Secret"), Replace("hasp-lens-1", "Secret"),
         std::string("Secret"), Replace("[0.08, -0.02]", "\"Secret\"") })
    try
    {
      hasp::ParseLens(text);
      ADD_FAILURE() << text;
    }
    catch (const std::exception& error)
    {
      EXPECT_EQ(std::string(error.what()).find("Secret"), std::string::npos) << error.what();
    }
}

TEST(LensFile, ReadsALens)
{
  const LensModel lens = hasp::ParseLens(Good), expected{ { 0.22, 0.24, -0.03 },
    { glm::dvec2(0.08, -0.02), glm::dvec2(-0.08, -0.02) }, { 0.995, 1.0, 1.008 } };
  EXPECT_EQ(lens.coefficients, expected.coefficients);
  EXPECT_EQ(lens.centers, expected.centers);
  EXPECT_EQ(lens.colorScale, expected.colorScale);
}

} // namespace
