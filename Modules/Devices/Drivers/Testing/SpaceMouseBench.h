#pragma once
#include "Devices/Drivers/Testing/FakeHid.h"

#include "Devices/Drivers/SpaceMouse/SpaceMouseDriver.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseHid.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace hasp::test
{

constexpr std::int64_t Ms = 1'000'000;
// At once, so that a pose is what was integrated and no more.
const SpaceMouseSettings AtOnce{ .waitMs = 0, .followS = 0.0 };

/// The driver and a device that is not there, in virtual time.
class SpaceMouseBench : public ::testing::Test
{
protected:
  DriverSample At(std::int64_t ms) { return this->Driver.Exchange({}, ms * Ms); }
  void Says(Bytes report) { this->Device->reports.push_back(std::move(report)); }
  static void ExpectFinite(const DriverSample& sample)
  {
    for (int n = 0; n < 3; ++n)
      ASSERT_LE(std::abs(sample.pose.position[n]), 100.0); // NaN is not
    ASSERT_NEAR(glm::length(sample.pose.orientation), 1.0, 1e-9);
  }

  std::shared_ptr<FakeHid> Device = std::make_shared<FakeHid>();
  SpaceMouseDriver Driver{
    std::make_unique<SpaceMouseHid>(std::make_unique<FakeHidTransport>(this->Device)), AtOnce
  };
};

} // namespace hasp::test
