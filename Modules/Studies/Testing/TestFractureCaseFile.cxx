#include "Studies/FractureCaseFile.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <unistd.h>

namespace
{

using hasp::FractureCaseTruth;
using hasp::RigidPose;

FractureCaseTruth Truth()
{
  FractureCaseTruth truth;
  truth.name = "a case";
  truth.geometry.dims = { 180, 220, 108 };
  truth.geometry.spacing = { 0.957, 0.957, 1.5 };
  truth.geometry.origin = { 38.25, 19.125, -3.0 };
  truth.fixed = { 2 };
  truth.cuts = {
    { 3, 2,
      { { { 1, 2, 3 }, { 0, 0.6, 0.8 }, -1.0, 9007199254740991U, { { 9, 1 }, { 4, 0.5 } }, 1.1 } } }
  };
  const RigidPose pose{ { 17.2, -31.9, 0.1 + 0.2 }, hasp::TurnBy({ 0.3, -2.0, 1.9 }) };
  truth.fragments = { { 3, "left zygoma", pose, 4015, 4107, 5516.1, { 174, 71, 53 }, 6.9, 12.1 } };
  truth.landmarks = { { "zygion", 3, { 188, 95, 42 }, { 187, 94, 40 } } };
  truth.damage = { true, 0.3, 0.5, 2, 4.0, 20.0, { 0.1, 0.2, 0.3 }, true, 7 };
  return truth;
}

/// The text with one part replaced, once.
std::string With(std::string text, const std::string& what, const std::string& by)
{
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

std::string WhyRefused(const std::string& text)
{
  try
  {
    hasp::ParseFractureCase(text);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

/// Of one fragment, unmoved: a matrix that tests can find.
FractureCaseTruth Unmoved()
{
  FractureCaseTruth truth = Truth();
  truth.fragments[0].anatomicalToFractured = {};
  return truth;
}
constexpr const char* Row0 = "[1.0, 0.0, 0.0, 0.0]";

TEST(FractureCaseFile, DamageIsRefusedWithoutAWordOfTheFile)
{
  const std::string text = hasp::FormatFractureCase(Truth());
  EXPECT_FALSE(WhyRefused("").empty());
  EXPECT_FALSE(WhyRefused(text.substr(0, text.size() / 2)).empty());
  for (const auto& [what, by] : std::vector<std::pair<std::string, std::string>>{
         { "fracture-case/1", "fracture-case/2" }, { "\"mm\"", "\"cm\"" }, { "LPS", "RAS" },
         { "\"left zygoma\"", "7" }, { "\"label\": 3", "\"label\": 2" },
         { "\"new_label\": 3", "\"new_label\": 0" }, { "\"sign\": -1", "\"sign\": 0" },
         { "[180, 220, 108]", "[180, 220]" }, { "[180, 220, 108]", "[0, 220, 108]" },
         { "\"cuts\"", "\"Muster, Max\"" }, { "[9.0, 1.0]", "[9.0, \"Muster, Max\"]" } })
  {
    const std::string why = WhyRefused(With(text, what, by));
    EXPECT_FALSE(why.empty()) << what;
    EXPECT_EQ(why.find("zygoma"), std::string::npos) << why;
    EXPECT_EQ(why.find("Muster"), std::string::npos) << why;
  }
}

TEST(FractureCaseFile, AMirroredMatrixIsSaidToMirror)
{
  const std::string text = hasp::FormatFractureCase(Unmoved());
  const std::string mirrored = WhyRefused(With(text, Row0, "[-1.0, 0.0, 0.0, 0.0]"));
  EXPECT_NE(mirrored.find("mirrors"), std::string::npos) << mirrored;
  EXPECT_NE(mirrored.find("fragments[0].displacement_4x4"), std::string::npos) << mirrored;
  EXPECT_NE(
    WhyRefused(With(text, Row0, "[1.001, 0.0, 0.0, 0.0]")).find("scale"), std::string::npos);
  EXPECT_NE(WhyRefused(With(text, "[0.0, 0.0, 0.0, 1.0]", "[0.0, 0.0, 0.1, 1.0]")).find("last row"),
    std::string::npos);
  // The first one is the displacement: the reduction is no more its inverse.
  EXPECT_NE(
    WhyRefused(With(text, Row0, "[1.0, 0.0, 0.0, 0.001]")).find("inverse"), std::string::npos);
}

TEST(FractureCaseFile, WhatIsWrittenIsReadBack)
{
  const FractureCaseTruth truth = Truth();
  const FractureCaseTruth read = hasp::ParseFractureCase(hasp::FormatFractureCase(truth));
  EXPECT_EQ(read.name, truth.name);
  EXPECT_EQ(read.geometry.dims, truth.geometry.dims);
  EXPECT_EQ(read.geometry.spacing, truth.geometry.spacing);
  EXPECT_EQ(read.geometry.origin, truth.geometry.origin);
  EXPECT_EQ(read.geometry.direction, truth.geometry.direction);
  EXPECT_EQ(read.fixed, truth.fixed);
  ASSERT_EQ(read.cuts.size(), 1U);
  ASSERT_EQ(read.cuts[0].surfaces.size(), 1U);
  EXPECT_EQ(read.cuts[0].surfaces[0].seed, truth.cuts[0].surfaces[0].seed);
  EXPECT_EQ(read.cuts[0].surfaces[0].bandsMm, truth.cuts[0].surfaces[0].bandsMm);
  EXPECT_EQ(read.cuts[0].surfaces[0].sign, -1.0);
  ASSERT_EQ(read.fragments.size(), 1U);
  EXPECT_EQ(read.fragments[0].name, "left zygoma");
  EXPECT_EQ(read.fragments[0].voxelsFractured, 4107U);
  EXPECT_EQ(read.fragments[0].startMostMm, 12.1);
  ASSERT_EQ(read.landmarks.size(), 1U);
  EXPECT_EQ(read.landmarks[0].name, "zygion");
  EXPECT_EQ(read.landmarks[0].fracturedMm, truth.landmarks[0].fracturedMm);
  EXPECT_TRUE(read.damage.known);
  EXPECT_EQ(read.damage.lostChips, 2U);
  EXPECT_EQ(read.damage.blurMm, truth.damage.blurMm);
  EXPECT_EQ(read.damage.seed, 7U);
}

TEST(FractureCaseFile, PosesComeBackWithinAMillionthOfAMillimetre)
{
  FractureCaseTruth truth = Truth();
  for (int n = 0; n < 200; ++n) // turns up to half a turn, at any axis
  {
    const double a = 0.7 * n;
    RigidPose& pose = truth.fragments[0].anatomicalToFractured;
    pose.orientation = hasp::TurnBy(
      3.14159 * n / 199.0 * glm::normalize(glm::dvec3(std::sin(a), std::cos(2.0 * a), 0.3)));
    pose.position = { 400.0 * std::sin(3.0 * a), -300.0, 1.0 / 3.0 };
    const FractureCaseTruth read = hasp::ParseFractureCase(hasp::FormatFractureCase(truth));
    for (const glm::dvec3& place : { glm::dvec3(0.0), glm::dvec3(250.0, -180.0, 900.0) })
    {
      ASSERT_LT(
        glm::distance(read.fragments[0].anatomicalToFractured.Place(place), pose.Place(place)),
        1e-9);
      ASSERT_LT(glm::distance(hasp::TrueReduction(read, 3).Place(pose.Place(place)), place), 1e-9);
    }
  }
  EXPECT_EQ(hasp::TrueReduction(truth, 2), RigidPose{});
  EXPECT_THROW(hasp::TrueReduction(truth, 4), std::invalid_argument);
}

TEST(FractureCaseFile, AFileIsReplacedWholeOrNotAtAll)
{
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("hasp-case-" + std::to_string(getpid()));
  EXPECT_THROW(hasp::WriteFractureCase(folder, Truth()), std::runtime_error); // no such folder
  EXPECT_THROW(hasp::ReadFractureCase(folder), std::runtime_error);
  std::filesystem::create_directory(folder);
  hasp::WriteFractureCase(folder, Truth());
  FractureCaseTruth bad = Truth();
  bad.fragments[0].label = 2; // twice
  EXPECT_THROW(hasp::WriteFractureCase(folder, bad), std::invalid_argument);
  EXPECT_EQ(hasp::ReadFractureCase(folder).fragments[0].label, 3);
  std::filesystem::remove_all(folder);
}

} // namespace
