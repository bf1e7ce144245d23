#include "Devices/CoLocation.h"
#include "Devices/WorkspaceMapping.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>

namespace
{

using namespace hasp;

std::string Refusal(const std::function<void()>& body)
{
  try
  {
    body();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

#if HASP_WITH_EIGEN

const RigidPose Truth{ { 120, -40, 300 }, TurnBy({ 0.4, -1.1, 0.3 }) };
const std::vector<glm::dvec3> Marks = { { -40, -40, 0 }, { 40, -40, 5 }, { 40, 40, -5 },
  { -40, 40, 0 }, { 0, 0, 35 } };

std::vector<CoLocationPair> Pairs(const std::vector<glm::dvec3>& marks)
{
  std::vector<CoLocationPair> pairs;
  for (const glm::dvec3& mark : marks)
    pairs.push_back({ mark, Truth.Place(mark) });
  return pairs;
}

TEST(CoLocation, WrongUnitsAreRefusedWithTheirFactor)
{
  for (const double factor : { 0.001, 0.8, 1.2, 25.4, 1000.0 })
  {
    auto pairs = Pairs(Marks);
    for (CoLocationPair& pair : pairs)
      pair.deviceMm /= factor;
    const std::string why = Refusal([&] { FitCoLocation(pairs); });
    EXPECT_NE(why.find("co-location: points lie"), std::string::npos) << factor << why;
  }
  auto pairs = Pairs(Marks);
  for (CoLocationPair& pair : pairs)
    pair.deviceMm *= 1.03; // a device that is 3 % out is one
  const CoLocationFit fit = FitCoLocation(pairs);
  EXPECT_NEAR(fit.spreadRatio, 1.0 / 1.03, 1e-9);
}

TEST(CoLocation, PointsOnALineAndMirrorImagesAreRefused)
{
  const auto line = Pairs({ { 0, 0, 0 }, { 10, 0, 0 }, { 20, 0, 0 }, { 35, 0, 0 } });
  const std::string onLine = Refusal([&] { FitCoLocation(line); });
  EXPECT_NE(
    onLine.find("co-location: for the device the points lie almost on a line"), std::string::npos)
    << onLine;
  auto mirrored = Pairs(Marks);
  for (CoLocationPair& pair : mirrored)
    pair.deviceMm.z = -pair.deviceMm.z;
  const std::string image = Refusal([&] { FitCoLocation(mirrored); });
  EXPECT_NE(image.find("Is the device's frame left-handed"), std::string::npos) << image;
  EXPECT_NE(Refusal(
              [&] {
                FitCoLocation(Pairs({ { 0, 0, 0 }, { 1, 0, 0 } }));
              })
              .find("2 pairs"),
    std::string::npos);
}

TEST(CoLocation, ExactPointsGiveTheExactPlace)
{
  const CoLocationFit fit = FitCoLocation(Pairs(Marks));
  EXPECT_LT(glm::length(fit.deviceToWorld.position - Truth.position), 1e-10);
  EXPECT_LT(
    glm::length(RotationVector(fit.deviceToWorld.orientation * glm::conjugate(Truth.orientation))),
    1e-12);
  EXPECT_LT(fit.rmsMm, 1e-10);
  EXPECT_EQ(fit.residualsMm.size(), Marks.size());
}

/// The residual of each pair is what the eye sees: the drawn tip beside the device's.
TEST(CoLocation, TheDrawnTipIsAsFarFromTheMarkAsTheResidualSays)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, 0.8);
  auto pairs = Pairs(Marks);
  for (CoLocationPair& pair : pairs)
    for (int axis = 0; axis < 3; ++axis)
      pair.worldMm[axis] += noise(random);
  const CoLocationFit fit = FitCoLocation(pairs);
  WorkspaceMapping mapping;
  mapping.Place(fit.deviceToWorld);
  double sum = 0.0;
  for (std::size_t n = 0; n < pairs.size(); ++n)
  {
    const RigidPose& tool = mapping.Update({ pairs[n].deviceMm }, false, 0.001);
    EXPECT_NEAR(glm::length(tool.position - pairs[n].worldMm), fit.residualsMm[n], 1e-10);
    sum += fit.residualsMm[n] * fit.residualsMm[n];
  }
  EXPECT_NEAR(fit.rmsMm, std::sqrt(sum / static_cast<double>(pairs.size())), 1e-12);
  EXPECT_GT(fit.rmsMm, 0.1);
}

#else

TEST(CoLocation, WithoutEigenTheFitSaysWhatIsMissing)
{
  const std::string why = Refusal([] { FitCoLocation({}); });
  EXPECT_NE(why.find("co-location"), std::string::npos) << why;
  EXPECT_NE(why.find("HASP_ENABLE_EIGEN=ON"), std::string::npos) << why;
}

#endif

} // namespace
