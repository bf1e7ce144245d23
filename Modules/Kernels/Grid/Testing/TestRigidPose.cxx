#include "Grid/RigidPose.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

namespace
{

using hasp::RigidPose;

class Draw
{
public:
  double In(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  glm::dvec3 Vector(double most) { return { In(-most, most), In(-most, most), In(-most, most) }; }
  glm::dvec3 Direction()
  {
    for (;;)
      if (const glm::dvec3 v = Vector(1.0); glm::length(v) > 0.1 && glm::length(v) < 1.0)
        return glm::normalize(v);
  }
  RigidPose Pose() { return { Vector(200.0), hasp::TurnBy(Direction() * In(0.0, 3.1)) }; }

private:
  std::mt19937 Random{ 3 };
};

/// The turned vector by Rodrigues' formula: the closed form that quaternions are held against.
glm::dvec3 Rodrigues(const glm::dvec3& axis, double angle, const glm::dvec3& v)
{
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * glm::dot(axis, v) * (1.0 - std::cos(angle));
}

TEST(RigidPose, OfNothingTurnsNothing)
{
  EXPECT_EQ(hasp::RotationVector({ 0.0, 0.0, 0.0, 0.0 }), glm::dvec3(0.0));
  EXPECT_EQ(hasp::RotationVector({ 1.0, 0.0, 0.0, 0.0 }), glm::dvec3(0.0));
  EXPECT_EQ(hasp::TurnBy({ 0.0, 0.0, 0.0 }), glm::dquat(1.0, 0.0, 0.0, 0.0));
  const RigidPose none;
  EXPECT_EQ(none.Place({ 1.0, 2.0, 3.0 }), glm::dvec3(1.0, 2.0, 3.0));
  EXPECT_EQ(none.Inverse().Place({ 1.0, 2.0, 3.0 }), glm::dvec3(1.0, 2.0, 3.0));
}

TEST(RigidPose, TurnsAsRodriguesSays)
{
  Draw draw;
  for (int n = 0; n < 200; ++n)
  {
    const glm::dvec3 axis = draw.Direction(), v = draw.Vector(10.0);
    const double angle = draw.In(0.0, 2.0 * std::numbers::pi);
    const RigidPose pose{ glm::dvec3(0.0), hasp::TurnBy(axis * angle) };
    // A few roundings of numbers up to 17.
    EXPECT_LT(glm::length(pose.Turn(v) - Rodrigues(axis, angle, v)), 1e-13);
  }
}

TEST(RigidPose, VectorAndTurnRoundTripFromTheSmallestToPi)
{
  Draw draw;
  for (const double angle : { 1e-150, 1e-20, 1e-12, 0.9e-8, 1.1e-8, 1e-4, 0.5, 2.0, 3.0,
         std::numbers::pi - 1e-4, std::numbers::pi - 1e-8, std::numbers::pi - 1e-12 })
    for (int n = 0; n < 50; ++n)
    {
      const glm::dvec3 vector = draw.Direction() * angle;
      const glm::dvec3 back = hasp::RotationVector(hasp::TurnBy(vector));
      // Relative: next to no turn no digit may get lost. 8 roundings, of which none cancels.
      EXPECT_LT(glm::length(back - vector), 8.0 * angle * std::numeric_limits<double>::epsilon())
        << angle;
    }
}

TEST(RigidPose, TheShorterWayRoundIsTaken)
{
  Draw draw;
  for (int n = 0; n < 200; ++n)
  {
    const glm::dvec3 axis = draw.Direction();
    const double angle = draw.In(std::numbers::pi + 1e-6, 2.0 * std::numbers::pi);
    const glm::dvec3 shorter = hasp::RotationVector(hasp::TurnBy(axis * angle));
    EXPECT_LT(glm::length(shorter + axis * (2.0 * std::numbers::pi - angle)), 1e-14);
    // A quaternion and its negative are one turn, half a turn too (either way round).
    const glm::dquat turn = hasp::TurnBy(axis * angle);
    EXPECT_EQ(hasp::RotationVector(turn), hasp::RotationVector(-turn));
  }
  const double half =
    glm::length(hasp::RotationVector(hasp::TurnBy({ 0.0, -std::numbers::pi, 0.0 })));
  EXPECT_NEAR(half, std::numbers::pi, 1e-15);
}

TEST(RigidPose, TurnsAreUnitWhateverTheAngle)
{
  Draw draw;
  for (const double angle : { 0.0, 1e-9, 1e-8, 1.0, 6.0, 1e3 })
    EXPECT_NEAR(glm::length(hasp::TurnBy(draw.Direction() * angle)), 1.0, 1e-15);
}

TEST(RigidPose, ComposesInTheOrderOfItsNames)
{
  Draw draw;
  for (int n = 0; n < 200; ++n)
  {
    const RigidPose toolToWorld = draw.Pose(), tipToTool = draw.Pose(), third = draw.Pose();
    const glm::dvec3 p = draw.Vector(100.0);
    // 1e-12: a dozen roundings of numbers up to 1000.
    EXPECT_LT(
      glm::length((toolToWorld * tipToTool).Place(p) - toolToWorld.Place(tipToTool.Place(p))),
      1e-12);
    EXPECT_LT(glm::length(((toolToWorld * tipToTool) * third).Place(p) -
                          (toolToWorld * (tipToTool * third)).Place(p)),
      1e-12);
    EXPECT_LT(
      glm::length(toolToWorld.Place(p) - toolToWorld.Place({}) - toolToWorld.Turn(p)), 1e-12);
  }
}

TEST(RigidPose, InverseUndoes)
{
  Draw draw;
  for (int n = 0; n < 200; ++n)
  {
    const RigidPose pose = draw.Pose();
    const glm::dvec3 p = draw.Vector(100.0);
    EXPECT_LT(glm::length(pose.Inverse().Place(pose.Place(p)) - p), 1e-12);
    const RigidPose none = pose * pose.Inverse();
    EXPECT_LT(glm::length(none.position), 1e-12);
    EXPECT_LT(glm::length(hasp::RotationVector(none.orientation)), 1e-14);
    EXPECT_NEAR(glm::length(pose.Turn(p)), glm::length(p), 1e-12);
  }
}

TEST(RigidPose, WrenchesAdd)
{
  hasp::Wrench sum{ { 1, 2, 3 }, { 4, 5, 6 } };
  sum += { { 10, 20, 30 }, { 40, 50, 60 } };
  EXPECT_EQ(sum.force, glm::dvec3(11, 22, 33));
  EXPECT_EQ(sum.torque, glm::dvec3(44, 55, 66));
}

} // namespace
