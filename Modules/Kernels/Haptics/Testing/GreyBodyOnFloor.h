#pragma once
// A body of grey values over a floor: what the dynamic shell's tests press.
#include "Haptics/DynamicPointShell.h"
#include "Haptics/Testing/SampledDistance.h"

#include "Grid/Trilinear.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

namespace hasp::testing
{

inline constexpr double Nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double Isovalue = 1000.0,
                        PerMm = -100.0; ///< grey values of a body, from its distance

/// A grey volume as a scanner would make it of a body: 16 bit, clamped, bright inside.
class GreyBody
{
public:
  GreyBody(const DistanceFunction& distance, const GridGeometry& g) : Distance(distance)
  {
    auto made = std::make_shared<std::vector<std::int16_t>>();
    for (const float d : SampledDistance(distance, g).samples)
      made->push_back(
        static_cast<std::int16_t>(std::lround(std::clamp(Isovalue + PerMm * d, -1000.0, 3000.0))));
    this->Volume.grid = hasp::GridView<const std::int16_t>{ made->data(), g };
    this->Volume.blocks = std::make_shared<hasp::MinMaxBlocks>(this->Volume.grid);
    this->Volume.owner = made;
    this->Volume.isovalue = Isovalue;
  }
  /// Grey value at a point of the body, or nothing outside of the grid.
  std::optional<double> ValueAt(const glm::dvec3& p) const
  {
    const auto& grid = std::get<hasp::GridView<const std::int16_t>>(this->Volume.grid);
    return hasp::SampleTrilinear(grid, grid.geometry.WorldToIndex(p));
  }

  ShellVolume Volume;
  DistanceFunction Distance;
};

struct Live
{
  glm::dvec3 position, normal;
  double area;
};

inline std::vector<Live> LivePoints(const DynamicPointShell& shell)
{
  const ContactPoints p = shell.Points();
  EXPECT_EQ(p.count % ContactPoints::Lanes, 0U);
  std::vector<Live> points;
  double area = 0.0;
  for (std::uint32_t n = 0; n < p.count; ++n)
    if (p.x[n] != ContactPoints::FarAway)
    {
      points.push_back({ { p.x[n], p.y[n], p.z[n] }, { p.nx[n], p.ny[n], p.nz[n] }, p.areas[n] });
      area += p.areas[n];
    }
  EXPECT_EQ(points.size(), shell.LastTick().points);
  EXPECT_NEAR(area, shell.LastTick().areaMm2, 1e-4 * area);
  return points;
}

/// The half space y < 0, 1 mm samples.
inline std::shared_ptr<const DistanceMap> Floor()
{
  return std::make_shared<DistanceMap>(
    SampledDistance(HalfSpace({}, { 0, 1, 0 }), CubeGrid(49)).View());
}

struct Touch
{
  double area = 0.0, force = 0.0; ///< mm^2; along y at 1 N/mm per mm^2
};
inline Touch TouchOnFloor(const DynamicPointShell& shell, const RigidPose& pose)
{
  Touch touch;
  for (const Live& p : LivePoints(shell))
    if (const double y = pose.Place(p.position).y; y < 0.0)
    {
      touch.area += p.area;
      touch.force += p.area * y * pose.Turn(p.normal).y;
    }
  return touch;
}

/// A ball of radius r pressed by h into the floor: cap and pressure by hand.
inline Touch BallOnFloor(double r, double h)
{
  const double c = (r - h) / r; // cosine at the cap's rim; depth is r u - (r - h), u from c to 1
  const double force =
    2.0 * std::numbers::pi * r * r * (r * (1.0 - c * c * c) / 3.0 - (r - h) * (1.0 - c * c) / 2.0);
  return { 2.0 * std::numbers::pi * r * h, force };
}

} // namespace hasp::testing
