#include "Distance/SolidSweeps.h"
#include "Testing/SolidPromises.h"

#include "Distance/Csg.h"
#include "Distance/ImplicitShapes.h"
#include "Distance/SolidShapes.h"

#include <functional>
#include <string>

namespace
{

constexpr std::string_view Letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-/+:";
const glm::dvec3 Right(1, 0, 0), Up(0, 1, 0);

std::vector<glm::dvec3> Spiral(int points)
{
  std::vector<glm::dvec3> line;
  for (int n = 0; n < points; ++n)
    line.emplace_back(4 * std::cos(0.3 * n), 4 * std::sin(0.3 * n), 0.1 * n - 3);
  return line;
}

std::string MessageOf(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& e)
  {
    return e.what();
  }
  return "nothing was refused";
}

TEST(SolidSweeps, RefuseWhatIsNoLine)
{
  const double nan = std::nan("");
  const std::vector<glm::dvec3> line{ {}, { 1, 0, 0 } }, bad{ {}, { 1, nan, 0 } };
  const auto plane = hasp::MakePlane({}, { 0, 0, 1 });
  EXPECT_THROW(hasp::MakeTube({}, false, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeTube(bad, false, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeTube(line, true, 0), std::invalid_argument);
  EXPECT_THROW(hasp::MakeRibbon(nullptr, line, 1, 0, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeRibbon(plane, std::span(line).first(1), 1, 0, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeRibbon(plane, bad, 1, 0, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeRibbon(plane, line, nan, 0, 1), std::invalid_argument);
  EXPECT_THROW(hasp::MakeRibbon(plane, line, 1, 1, 0), std::invalid_argument);
  // Through the middle of a ball, and off it: the message says where.
  const auto ball = hasp::MakeCapsule({}, {}, 5);
  const std::vector<glm::dvec3> through{ { 5, 0, 0 }, { -5, 0, 0 } };
  EXPECT_NE(MessageOf([&] { hasp::MakeRibbon(ball, through, 2, 0, 1); }).find("after place 0"),
    std::string::npos);
  const std::vector<glm::dvec3> below{ { 4, 0, 0 }, { 4, 0.1, 0 } };
  EXPECT_THROW(hasp::MakeRibbon(ball, below, 2, 0, 1), std::invalid_argument);
  const std::vector<glm::dvec3> off{ { 5, 0, 0 }, { 0, 5, 1 } };
  EXPECT_NE(
    MessageOf([&] { hasp::MakeRibbon(ball, off, 0.1, 0, 1); }).find("place 1"), std::string::npos);
}

TEST(SolidSweeps, RefuseWhatIsNoText)
{
  EXPECT_THROW(hasp::MakeText("", {}, Right, Up, 6, 0.5), std::invalid_argument);
  EXPECT_THROW(hasp::MakeText("  ", {}, Right, Up, 6, 0.5), std::invalid_argument);
  EXPECT_THROW(hasp::MakeText("A", {}, Right, 2.0 * Right, 6, 0.5), std::invalid_argument);
  EXPECT_THROW(hasp::MakeText("A", {}, {}, Up, 6, 0.5), std::invalid_argument);
  EXPECT_THROW(hasp::MakeText("A", {}, Right, Up, 0, 0.5), std::invalid_argument);
  EXPECT_THROW(hasp::MakeText("A", {}, Right, Up, 6, 0), std::invalid_argument);
  EXPECT_THROW(hasp::MakeText("A", {}, Right, Up, 6, 1.01), std::invalid_argument);
  // The text may be a patient's name: its place is told, not what it says.
  const std::string told = MessageOf([] { hasp::MakeText("NAME_B", {}, Right, Up, 6, 0.5); });
  EXPECT_NE(told.find("character 5"), std::string::npos);
  EXPECT_EQ(told.find('_'), std::string::npos);
  EXPECT_EQ(told.find("NAME"), std::string::npos);
}

TEST(SolidSweeps, KeepThePromisesOfASolid)
{
  const auto ball = hasp::MakeCapsule({}, {}, 4);
  const hasp::SolidPointer sweeps[] = { hasp::MakeTube(Spiral(60), false, 0.3),
    hasp::MakeTube(Spiral(20), true, 2.0), hasp::MakeTube(Spiral(1), false, 1.0),
    hasp::MakeText("TIBIA 2/3:L", { -9, 0, 0 }, { 1, 0.2, 0 }, Up, 2, 0.3),
    hasp::MakeRibbon(ball,
      std::vector<glm::dvec3>{ { 4, 0, 0 }, { 4 * std::cos(0.4), 4 * std::sin(0.4), 0 },
        { 4 * std::cos(0.8), 4 * std::sin(0.8), 0 } },
      2, 0.2, 1) };
  for (const auto& solid : sweeps)
  {
    const auto places = hasp::RandomPlaces(1000, 8);
    hasp::ExpectSamplesAgree(*solid, places);
    hasp::ExpectNoSteeperThanPromised(*solid, places);
    hasp::ExpectGradientsOfFaces(*solid, hasp::RandomPlaces(20, 8), hasp::AllFaces(*solid), 1e-5);
  }
}

TEST(SolidSweeps, TubesAreTheLeastOfAllTheirCapsules)
{
  const auto line = Spiral(300);
  for (const bool closed : { false, true })
  {
    const auto tube = hasp::MakeTube(line, closed, 0.4);
    EXPECT_EQ(tube->Faces(), closed ? 300u : 299u);
    for (const glm::dvec3& x : hasp::RandomPlaces(2000, 40))
      ASSERT_EQ(tube->At(x), hasp::TubeDistance(x, line, closed, 0.4));
    hasp::ExpectFootPointsOnSurface(*tube, hasp::RandomPlaces(500, 8));
  }
  EXPECT_EQ(hasp::MakeTube(std::vector<glm::dvec3>{ { 1, 0, 0 } }, true, 1)->At({ 3, 0, 0 }), 1.0);
}

TEST(SolidSweeps, ARibbonOnAPlaneIsAPlateWithRoundEnds)
{
  const auto floor = hasp::MakePlane({}, { 0, 0, 1 });
  const std::vector<glm::dvec3> path{ { 0, 0, 0 }, { 10, 0, 0 } };
  const auto plate = hasp::MakeRibbon(floor, path, 4, 0.5, 1.5);
  const auto truth = hasp::MakeStadium({ 0, 0, 1 }, { 10, 0, 1 }, { 0, 0, 1 }, 2, 1);
  for (const glm::dvec3& x : hasp::RandomPlaces(3000, 4, { 9, 0, 1 }))
  {
    // A bound outside, the distance inside and at the faces.
    ASSERT_LE(plate->At(x), truth->At(x) + 1e-12);
    ASSERT_EQ(plate->At(x) < 0, truth->At(x) < 0);
    ASSERT_NEAR(std::min(plate->At(x), 0.0), std::min(truth->At(x), 0.0), 1e-12);
  }
}

TEST(SolidSweeps, ARibbonOnABallFollowsItWithUprightWalls)
{
  const double radius = 20;
  const auto ball = hasp::MakeCapsule({}, {}, radius);
  std::vector<glm::dvec3> path;
  for (int n = 0; n <= 12; ++n)
    path.emplace_back(radius * std::cos(0.1 * n), radius * std::sin(0.1 * n), 0);
  const auto plate = hasp::MakeRibbon(ball, path, 6, 0.3, 2.3);
  const auto at = [&](double angle, double height, double across)
  {
    return (radius + height) * glm::normalize(glm::dvec3(std::cos(angle), std::sin(angle), 0)) +
           glm::dvec3(0, 0, across);
  };
  for (double angle = 0.0; angle <= 1.2; angle += 0.01)
  {
    EXPECT_NEAR(plate->At(at(angle, 2.3, 0)), 0.0, 1e-12);
    EXPECT_NEAR(plate->At(at(angle, 0.3, 0)), 0.0, 1e-12);
    EXPECT_NEAR(plate->At(at(angle, 1.3, 0)), -1.0, 1e-12);
    // The wall: 3 mm across, upright. Segments turn by 0.1: at most 0.05 (0.9 + 3 mm of sag) mm off
    // a segment's end, seen along its normal, is 0.6 um nearer to the wall.
    const auto wall = plate->SampleAt(at(angle, 0.9, 3.01));
    EXPECT_NEAR(wall.value, 0.01, 6e-4);
    EXPECT_LT(glm::distance(wall.gradient, glm::dvec3(0, 0, 1)), 0.02);
  }
  // Round at its ends, upright where the first segment has its middle, half its angle on; and
  // nothing of it on the ball's other side.
  EXPECT_NEAR(
    plate->At({ radius + 1.3, -4, 0 }), 4 * std::cos(0.05) + 1.3 * std::sin(0.05) - 3, 1e-9);
  for (const glm::dvec3& x : hasp::RandomPlaces(2000, 24))
    ASSERT_TRUE(x.x > 0 || x.y > 0 || plate->At(x) > 0.0);
}

TEST(SolidSweeps, AWideRibbonReachesDownWhereTheSurfaceBendsAway)
{
  // 5.5 mm off its middle a ball of 10 mm is 1.6 mm lower, and so is the ribbon's underside.
  const auto ball = hasp::MakeCapsule({}, {}, 10);
  const std::vector<glm::dvec3> path{ { 10 * std::cos(0.1), 10 * std::sin(0.1), 0 },
    { 10 * std::cos(0.1), -10 * std::sin(0.1), 0 } };
  const auto plate = hasp::MakeRibbon(ball, path, 12, -0.4, 0.4);
  for (const double across : { -5.5, 0.0, 5.5 })
    EXPECT_NEAR(plate->At({ std::sqrt(100 - across * across), 0, across }), -0.4, 1e-9);
}

TEST(SolidSweeps, EveryLetterStaysInItsPlaceAndIsItsOwn)
{
  // As pictures of 9 x 13 places of the digits' grid and between: no two the same.
  std::vector<std::string> pictures;
  for (const char letter : Letters)
  {
    const auto solid = hasp::MakeText(std::string(1, letter), {}, Right, Up, 6, 0.5);
    const auto box = solid->Bounds();
    for (const double low : { box.low.x, box.low.y, box.low.z })
      EXPECT_GE(low, -0.25) << letter;
    EXPECT_LE(box.high.x, 4.25) << letter;
    EXPECT_LE(box.high.y, 6.25) << letter;
    std::string picture;
    for (int y = 12; y >= 0; --y)
      for (int x = 0; x <= 8; ++x)
        picture += solid->At({ 0.5 * x, 0.5 * y, 0 }) < 0 ? '#' : '.';
    for (const std::string& other : pictures)
    {
      int differ = 0;
      for (std::size_t n = 0; n < picture.size(); ++n)
        differ += picture[n] != other[n];
      EXPECT_GE(differ, 2) << letter; // the tail of a Q, the leg of an R
    }
    pictures.push_back(picture);
  }
}

TEST(SolidSweeps, TextLiesInItsPlaneAndKeepsItsMeasures)
{
  const glm::dvec3 origin(3, 4, 5);
  const auto word = hasp::MakeText("L L", origin, { 0, 2, 0 }, { 0, 5, 3 }, 3, 0.4);
  const auto box = word->Bounds();
  const glm::dvec3 stroke(0.2), size(0, hasp::TextWidth(3, 3), 3);
  EXPECT_LT(glm::distance(box.low, origin - stroke), 1e-12);
  EXPECT_LT(glm::distance(box.high, origin + size + stroke), 1e-12);
  EXPECT_EQ(hasp::TextWidth(3, 3), 8.0);
  EXPECT_EQ(hasp::TextWidth(0, 3), 0.0);
  // In the middle of the first letter's foot, 2 mm long, a stroke of 0.2 mm radius.
  EXPECT_NEAR(word->At(origin + glm::dvec3(0.1, 1, 0)), -0.1, 1e-12);
  EXPECT_NEAR(word->At(origin + glm::dvec3(0, 1, -1)), 0.8, 1e-12);
  // Engraved half a stroke deep in a plane through its axes.
  const auto plate = hasp::MakeDifference(hasp::MakePlane(origin, { 1, 0, 0 }), word);
  EXPECT_NEAR(plate->At(origin + glm::dvec3(0, 1, 0)), 0.2, 1e-12);
  EXPECT_NEAR(plate->At(origin + glm::dvec3(-0.2, 1, 0)), 0.0, 1e-12);
}

TEST(SolidSweeps, ARibbonsWallsAreUprightAlongTheNormalsGiven)
{
  const auto table = hasp::MakeBox({ 0, 0, -10 }, glm::dmat3(1), { 40, 40, 10 });
  const std::vector<glm::dvec3> path{ { -10, 0, 0 }, { 0, 0, 0 }, { 10, 0, 0 } };
  const glm::dvec3 leaning = { 0, 0.5, 1 }; // any length
  const std::vector<glm::dvec3> normals{ leaning, leaning };
  const auto band = hasp::MakeRibbon(table, path, 6.0, 0.0, 4.0, normals);
  // Walls go out by half of what they go up; 3 mm from the axis, upright on it.
  const double edge = 3.0 * std::sqrt(1.25);
  for (const double z : { 0.5, 2.0, 3.5 })
    for (const double side : { -1.0, 1.0 })
    {
      EXPECT_LT(band->At({ 3, 0.5 * z + side * (edge - 0.05), z }), 0.0) << z << " " << side;
      EXPECT_GT(band->At({ 3, 0.5 * z + side * (edge + 0.05), z }), 0.0) << z << " " << side;
    }
  EXPECT_THROW(
    hasp::MakeRibbon(table, path, 6.0, 0.0, 4.0, { normals.data(), 1 }), std::invalid_argument);
}

} // namespace
