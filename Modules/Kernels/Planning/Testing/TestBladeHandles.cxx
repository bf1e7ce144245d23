// Blades under a pointer, against where the handle must be afterwards.
#include "Planning/BladeHandles.h"

#include "Planning/BladePlacing.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using glm::dvec3;
using hasp::BladeHandle;
constexpr double RoundingMm = 1e-9;

hasp::Osteotomy Blade()
{
  return { { 5, -20, 30 }, { 0.6, 0.8, 0 }, { 0, 0, 1 }, 40, 30, 1 };
}

/// From an eye 500 mm away.
hasp::PointerRay RayTo(const dvec3& eye, const dvec3& place)
{
  return { eye, glm::normalize(place - eye) };
}
double OffRay(const hasp::PointerRay& ray, const dvec3& place)
{
  return glm::length(glm::cross(place - ray.origin, ray.direction));
}

TEST(BladeHandles, LieOnTheBlade)
{
  const auto blade = Blade();
  EXPECT_EQ(HandlePlace(blade, BladeHandle::Middle), blade.point);
  const dvec3 tip = HandlePlace(blade, BladeHandle::Normal);
  EXPECT_NEAR(glm::distance(tip, blade.point + 7.5 * blade.normal), 0.0, RoundingMm);
  for (const auto corner :
    { BladeHandle::Corner0, BladeHandle::Corner1, BladeHandle::Corner2, BladeHandle::Corner3 })
  {
    const dvec3 at =
      glm::transpose(hasp::BladeAxes(blade)) * (HandlePlace(blade, corner) - blade.point);
    EXPECT_NEAR(std::abs(at.x), 20.0, RoundingMm);
    EXPECT_NEAR(std::abs(at.y), 15.0, RoundingMm);
    EXPECT_NEAR(at.z, 0.0, RoundingMm);
  }
}

TEST(BladeHandles, WhereNothingWasDraggedNothingMoves)
{
  const auto blade = Blade();
  for (const BladeHandle handle : hasp::BladeHandleList)
  {
    const auto ray = RayTo({ 300, 300, 200 }, HandlePlace(blade, handle));
    const auto same = hasp::DraggedBlade(blade, handle, ray, ray);
    EXPECT_NEAR(glm::distance(same.point, blade.point), 0.0, RoundingMm);
    EXPECT_NEAR(glm::distance(same.normal, blade.normal), 0.0, 1e-12);
  }
}

TEST(BladeHandles, WhatWasPressedStaysUnderThePointer)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto blade = Blade();
  int turned = 0;
  for (int n = 0; n < 300; ++n)
  {
    const dvec3 side = glm::normalize(dvec3(any(random), any(random), any(random)));
    const dvec3 eye = blade.point + 500.0 * side;
    const dvec3 move = 6.0 * dvec3(any(random), any(random), any(random));
    const double cosine = std::abs(glm::dot(side, blade.normal));
    for (const BladeHandle handle : hasp::BladeHandleList)
    {
      const dvec3 place = HandlePlace(blade, handle);
      const auto from = RayTo(eye, place), to = RayTo(eye, place + move);
      const auto moved = hasp::DraggedBlade(blade, handle, from, to);
      EXPECT_NO_THROW(hasp::ValidateOsteotomy(moved));
      const dvec3 way = moved.point - blade.point;
      if (handle == BladeHandle::Middle)
      {
        EXPECT_NEAR(glm::dot(way, blade.normal), 0.0, RoundingMm);
        if (cosine > 0.2)
        {
          EXPECT_NEAR(OffRay(to, HandlePlace(moved, handle)), 0.0, RoundingMm);
        }
      }
      else if (handle == BladeHandle::Normal)
      {
        EXPECT_NEAR(glm::length(glm::cross(way, blade.normal)), 0.0, RoundingMm);
      }
      else
      {
        EXPECT_EQ(moved.point, blade.point);
        const bool within = OffRay(to, blade.point) < 25.0;
        turned += within;
        if (within) // the corner's ball is of radius 25
        {
          EXPECT_NEAR(OffRay(to, HandlePlace(moved, handle)), 0.0, 1e-6);
        }
      }
    }
  }
  EXPECT_GT(turned, 600);
}

TEST(BladeHandles, AlongItsNormalItGoesAsFarAsItIsDragged)
{
  const auto blade = Blade();
  const dvec3 tip = HandlePlace(blade, BladeHandle::Normal);
  const dvec3 eye = blade.point + 500.0 * glm::normalize(dvec3(0.8, -0.6, 0.3)); // across it
  const auto moved = hasp::DraggedBlade(
    blade, BladeHandle::Normal, RayTo(eye, tip), RayTo(eye, tip + 4.0 * blade.normal));
  EXPECT_NEAR(glm::distance(moved.point, blade.point + 4.0 * blade.normal), 0.0, RoundingMm);
}

TEST(BladeHandles, SeenFromItsEdgeItDoesNotJump)
{
  const auto blade = Blade();
  const dvec3 across = hasp::BladeAxes(blade)[1];
  const dvec3 eye = blade.point + 500.0 * across; // in its plane
  const auto moved = hasp::DraggedBlade(blade, BladeHandle::Middle, RayTo(eye, blade.point),
    RayTo(eye, blade.point + dvec3(0, 0, 5) + 3.0 * blade.normal));
  EXPECT_NEAR(glm::distance(moved.point, blade.point + dvec3(0, 0, 5)), 0.0, 0.01);
  const dvec3 ahead = blade.point + 500.0 * blade.normal; // along its normal
  const auto pushed = hasp::DraggedBlade(blade, BladeHandle::Normal, RayTo(ahead, blade.point),
    RayTo(ahead, blade.point + dvec3(0, 0, 5)));
  EXPECT_NEAR(glm::distance(pushed.point, blade.point), 0.0, 0.1);
}

} // namespace
