#include "Planning/Transplant.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>

namespace
{

using glm::dvec3;

/// Two segments round a corner of 90 degrees, from a straight donor along z.
hasp::Transplant Corner()
{
  hasp::Transplant t;
  const std::vector<dvec3> line{ { 0, 0, 0 }, { 40, 0, 0 }, { 40, 30, 0 } };
  t.joints = hasp::MitreJoints(line);
  t.outward = { { 0, 0, 1 }, { 0, 0, 1 } };
  t.donor.axis = { { 500, 7, -170 }, { 500, 7, 170 } };
  t.donor.lateral = { 0, 1, 0 };
  t.donor.radiusMm = 5.0;
  return t;
}

std::string Fault(const std::function<void(hasp::Transplant&)>& change)
{
  hasp::Transplant t = Corner();
  change(t);
  try
  {
    hasp::LayOutSegments(t);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

TEST(Transplant, WhatCannotBeLaidOutIsNamed)
{
  const auto expect = [](const std::function<void(hasp::Transplant&)>& change, const char* text)
  {
    const std::string fault = Fault(change);
    EXPECT_NE(fault.find(text), std::string::npos) << fault;
  };
  EXPECT_EQ(Fault([](auto&) {}), "");
  expect([](auto& t) { t.joints.resize(1); }, "number of joints is 1");
  expect([](auto& t) { t.outward.pop_back(); }, "number of outward is 1");
  expect([](auto& t) { t.joints[1].normal = { 1, 1, 0 }; }, "joints[1].normal's length");
  expect(
    [](auto& t) {
      t.joints[2].normal = { 1, 0, 0 };
    },
    "joints[2].normal: its angle with segments[1] is 90");
  expect([](auto& t) { t.joints[0].normal = { -1, 0, 0 }; }, "is 180, must be at most 60 degrees");
  expect([](auto& t) { t.joints[1].point = { 0.5, 0, 0 }; }, "segments[0]'s length is 0.5");
  expect([](auto& t) { t.outward[1] = { 0, 1, 0 }; }, "outward[1]: its sine");
  expect([](auto& t) { t.donor.axis.resize(1); }, "donor.axis");
  expect([](auto& t) { t.donor.axis[1] = t.donor.axis[0]; }, "donor.axis[1]");
  expect([](auto& t) { t.donor.lateral = { 0, 0, 1 }; }, "donor.lateral");
  expect([](auto& t) { t.donor.radiusMm = 0; }, "donor.radiusMm is 0");
  expect([](auto& t) { t.donor.keepMm = std::nan(""); }, "donor.keepMm is nan");
  expect([](auto& t) { t.kerfMm = 0; }, "kerfMm is 0");
  expect([](auto& t) { t.betweenMm = -1; }, "betweenMm is -1");
  expect([](auto& t) { t.vessel = { { 0, 0, 0 } }; }, "vessel");
  expect([](auto& t) { t.donor.radiusMm = 45; }, "segments[0]'s shortest side is -5");
  // 75 + 1 + 40 + ... + 30 + 1 + 75, a wedge of 10 and two kerfs at 45 degrees, is above 230.
  expect([](auto& t) { t.donor.axis[1].z = 60; }, "mm too short: its 2 segments");
  EXPECT_THROW(hasp::MitreJoints(std::vector<dvec3>{ { 0, 0, 0 } }), std::invalid_argument);
  EXPECT_THROW(hasp::MitreJoints(std::vector<dvec3>{ { 0, 0, 0 }, { 9, 0, 0 }, { 0, 0, 0 } }),
    std::invalid_argument);
}

TEST(Transplant, AMitreHasTheLengthsAndAnglesOfItsClosedForm)
{
  const auto segments = hasp::LayOutSegments(Corner());
  ASSERT_EQ(segments.size(), 2U);
  const double eighth = glm::quarter_pi<double>();
  EXPECT_NEAR(segments[0].lengthMm, 40.0, 1e-12);
  EXPECT_NEAR(segments[1].lengthMm, 30.0, 1e-12);
  for (const hasp::DonorSegment& segment : segments)
  {
    EXPECT_NEAR(segment.wedgeRadians, eighth, 1e-12);
    EXPECT_NEAR(segment.longestMm - segment.lengthMm, 5.0, 1e-12); // radius x tan 45
    EXPECT_NEAR(segment.lengthMm - segment.shortestMm, 5.0, 1e-12);
  }
  EXPECT_NEAR(segments[0].startTiltRadians, 0.0, 1e-12);
  EXPECT_NEAR(segments[0].endTiltRadians, eighth, 1e-12);
  EXPECT_NEAR(segments[1].startTiltRadians, eighth, 1e-12);
  // 75 mm stay, then a kerf; two mitres back to back with two kerfs at 45 degrees between.
  EXPECT_NEAR(segments[0].fromMm, 76.0, 1e-12);
  EXPECT_NEAR(segments[0].toMm, 116.0, 1e-12);
  EXPECT_NEAR(segments[1].fromMm, 116.0 + 2.0 * std::sqrt(2.0) + 1.5 + 10.0, 1e-12);
  EXPECT_NEAR(segments[0].start.point.z, -170.0 + 76.0, 1e-12);
}

TEST(Transplant, TurnedOverTheMitresLieAlongEachOtherAndNothingIsWasted)
{
  hasp::Transplant t = Corner();
  t.outward[1] = { 0, 0, -1 };
  const auto segments = hasp::LayOutSegments(t);
  EXPECT_NEAR(segments[1].fromMm - segments[0].toMm, 2.0 * std::sqrt(2.0) + 1.5, 1e-12);
  EXPECT_NEAR(glm::dot(segments[0].end.normal, segments[1].start.normal), 1.0, 1e-12);
}

/// Where a plane's bone face is along the axis, at a place across it.
double Along(const hasp::TransplantJoint& plane, const dvec3& place, const dvec3& axis)
{
  return glm::dot(plane.point - place, plane.normal) / glm::dot(axis, plane.normal);
}

TEST(Transplant, RandomPlansGoIntoTheDefectExactlyAndKeepTheirDistance)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto any = [&] { return dvec3(unit(random), unit(random), unit(random)); };
  int laid = 0;
  for (int trial = 0; trial < 1000; ++trial)
  {
    hasp::Transplant t;
    std::vector<dvec3> line{ 20.0 * any() };
    const int segments = 1 + trial % 3;
    dvec3 way = glm::normalize(any());
    for (int n = 0; n < segments; ++n)
    {
      way = glm::normalize(way + 0.8 * any());
      line.push_back(line.back() + (25.0 + 5.0 * unit(random)) * way);
      t.outward.push_back(glm::normalize(glm::cross(way, any())));
    }
    t.joints = hasp::MitreJoints(line);
    // A bow of 5 mm on 340 mm, as a fibula has, somewhere, however turned.
    const dvec3 z = glm::normalize(any()), x = glm::normalize(glm::cross(z, any()));
    const dvec3 middle = 300.0 * any();
    for (int n = -17; n <= 17; ++n)
      t.donor.axis.push_back(middle + 10.0 * n * z + 5.0 * (1.0 - n * n / 289.0) * x);
    t.donor.lateral = glm::normalize(glm::cross(z, x) + 0.3 * x);
    t.donor.radiusMm = 8.0;
    t.fromLastTip = trial % 2 == 1;
    std::vector<hasp::DonorSegment> cut;
    try
    {
      cut = hasp::LayOutSegments(t);
    }
    catch (const std::exception&)
    {
      continue; // tilted too much, or too long
    }
    ++laid;
    for (int n = 0; n < segments; ++n)
    {
      const hasp::DonorSegment& s = cut[n];
      const hasp::PlanPose& pose = s.donorToDefect;
      EXPECT_LT(glm::distance(pose.Place(s.start.point), t.joints[n].point), 1e-9);
      EXPECT_LT(glm::distance(pose.Place(s.end.point), t.joints[n + 1].point), 1e-9);
      EXPECT_LT(glm::distance(pose.orientation * s.start.normal, t.joints[n].normal), 1e-9);
      EXPECT_LT(glm::distance(pose.orientation * s.end.normal, t.joints[n + 1].normal), 1e-9);
      EXPECT_LT(glm::distance(pose.PlaceBack(pose.Place(middle)), middle), 1e-9);
      // The lateral side looks outward, as far as it is upright on the segment.
      const dvec3 along = glm::normalize(t.joints[n + 1].point - t.joints[n].point);
      const dvec3 lateral = pose.orientation * t.donor.lateral;
      EXPECT_LT(
        glm::distance(glm::normalize(lateral - glm::dot(lateral, along) * along), t.outward[n]),
        1e-9);
    }
    // Along the donor, whichever way: planes do not meet within the bone, and tips stay.
    std::vector<hasp::TransplantJoint> planes;
    for (int n = 0; n < segments; ++n)
    {
      const hasp::DonorSegment& s = cut[t.fromLastTip ? segments - 1 - n : n];
      planes.push_back(t.fromLastTip ? s.end : s.start);
      planes.push_back(t.fromLastTip ? s.start : s.end);
    }
    const dvec3 first = t.donor.axis.front(), last = t.donor.axis.back();
    for (int a = 0; a < 64; ++a)
    {
      const double angle = glm::two_pi<double>() * a / 64;
      double before = 74.0; // of 75: the bow leans the bone over by 3 degrees
      for (std::size_t p = 0; p < planes.size(); ++p)
      {
        const dvec3 at =
          planes[p].point + 8.0 * (std::cos(angle) * x + std::sin(angle) * glm::cross(z, x));
        const double along = Along(planes[p], at, z) + glm::dot(at - first, z);
        const bool between = p > 0 && p % 2 == 0;
        EXPECT_GE(along, before + (between ? 2.0 * t.kerfMm + t.betweenMm - 0.5 : 0.0));
        before = along;
      }
      EXPECT_LE(before, glm::dot(last - first, z) - 74.0);
    }
  }
  EXPECT_GT(laid, 500);
}

TEST(Transplant, FromTheLastTipTheFirstSegmentIsTheLastOnTheDonor)
{
  hasp::Transplant t = Corner();
  t.fromLastTip = true;
  const auto segments = hasp::LayOutSegments(t);
  EXPECT_NEAR(segments[1].toMm, 76.0, 1e-12);
  EXPECT_GT(segments[0].toMm, segments[1].fromMm);
  EXPECT_NEAR(segments[0].fromMm - segments[0].toMm, 40.0, 1e-12);
}

TEST(Transplant, VesselAndPaddleComeWithTheirSegments)
{
  hasp::Transplant t = Corner();
  const auto segments = hasp::LayOutSegments(t);
  // 10 mm lateral of the axis, all along it.
  t.vessel = { { 500, 17, -170 }, { 500, 17, 0 }, { 500, 17, 170 } };
  const auto placed = hasp::PlaceVessel(segments, t.vessel);
  ASSERT_EQ(placed.size(), 2U);
  for (const hasp::PlacedVessel& part : placed)
  {
    for (const dvec3& p : part.line)
      EXPECT_NEAR(p.z, 10.0, 1e-9); // outward
    // It ends in the joints' planes.
    const auto off = [&](const dvec3& p, std::size_t joint)
    { return glm::dot(p - t.joints[joint].point, t.joints[joint].normal); };
    EXPECT_NEAR(off(part.line.front(), part.segment), 0.0, 1e-9);
    EXPECT_NEAR(off(part.line.back(), part.segment + 1), 0.0, 1e-9);
  }
  EXPECT_LT(glm::distance(placed[0].line.back(), dvec3(40, 0, 10)), 1e-9);
  hasp::SkinPaddle paddle{ { { 500, 30, -60 }, { 510, 30, -50 } }, { 500, 12, -70 } };
  const auto skin = hasp::PlacePaddle(segments, paddle);
  EXPECT_EQ(skin.segment, 0U);
  EXPECT_NEAR(skin.paddle.perforator.z, 5.0, 1e-9);
  EXPECT_NEAR(skin.paddle.outline[0].z, 23.0, 1e-9);
  paddle.perforator.z = 100;
  EXPECT_THROW(hasp::PlacePaddle(segments, paddle), std::invalid_argument);
}

} // namespace
