#include "CertificateTrial.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

std::string All(const hasp::CertificateTrial& trial)
{
  std::string text;
  for (const std::string& wrong : trial.wrong)
    text += wrong + "\n";
  return text;
}

class SeededParts : public testing::TestWithParam<hasp::SeededDefect>
{
};

#if HASP_WITH_CGAL
TEST(CleanParts, AreNotFlagged)
{
  const auto trial = hasp::TryCertificate(hasp::SeededDefect::None, 1, 3);
  EXPECT_EQ(trial.red, 0U) << All(trial);
}

TEST_P(SeededParts, TheDefectIsFoundForWhatItIs)
{
  const auto trial = hasp::TryCertificate(GetParam(), 10, 1);
  EXPECT_EQ(trial.found, trial.parts) << All(trial);
}

INSTANTIATE_TEST_SUITE_P(, SeededParts,
  testing::Values(hasp::SeededDefect::MeshHole, hasp::SeededDefect::FlippedTriangle,
    hasp::SeededDefect::SelfIntersection, hasp::SeededDefect::ThinWall,
    hasp::SeededDefect::WrongGap, hasp::SeededDefect::NarrowSlot, hasp::SeededDefect::SmallHole,
    hasp::SeededDefect::Mirrored, hasp::SeededDefect::InchForMm, hasp::SeededDefect::LoosePiece));
#else
TEST(CleanParts, AreNotGreenWithoutCGAL)
{
  EXPECT_EQ(hasp::TryCertificate(hasp::SeededDefect::None, 1, 1).red, 1U);
}
#endif

} // namespace
