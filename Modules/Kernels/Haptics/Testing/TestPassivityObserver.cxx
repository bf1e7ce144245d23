#include "Grid/Testing/CountNew.h"
#include "Haptics/PassivityObserver.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Tick = 0.001;

// A device pushed through a spring and back: what it holds on the way, nothing at the end.
TEST(PassivityObserver, ReadsTheSpringsEnergyAndNoneAtTheEnd)
{
  hasp::PassivityObserver observer;
  const double k = 0.5;
  for (int n = 0; n <= 20'000; ++n)
  {
    const double x = 2.0 * std::sin(std::acos(-1.0) * n / 20'000);
    observer.Tick({ { x, 0, 0 }, { 1, 0, 0, 0 } }, { { -k * x, 0, 0 }, {} });
    if (n == 10'000)
    {
      EXPECT_NEAR(observer.Energy(), 0.5 * k * 4.0, 1e-3); // held for one of 1e4 steps
    }
  }
  EXPECT_NEAR(observer.Energy(), 0.0, 1e-3);
}

// Forces one step late push out more than they took in: sum of k v^2 T.
TEST(PassivityObserver, SeesTheEnergyOfALateForce)
{
  hasp::PassivityObserver observer;
  const double k = 5.0;
  double late = 0.0;
  for (int n = 0; n <= 100; ++n)
  {
    const double x = 2.0 * std::sin(std::acos(-1.0) * n / 100.0);
    observer.Tick({ { x, 0, 0 }, { 1, 0, 0, 0 } }, { { -k * late, 0, 0 }, {} });
    late = x;
  }
  EXPECT_LT(observer.Energy(), -0.1);
  EXPECT_LT(observer.Lowest(), -0.1);
  observer.Tick({ { NaN, 0, 0 }, { 1, 0, 0, 0 } }, {});
  EXPECT_TRUE(std::isfinite(observer.Energy()));
}

// While no pose is known the device holds what it was told then, not what it held before.
TEST(PassivityObserver, CountsWhatIsHeldWhileNoPoseIsKnown)
{
  const auto at = [](double x) { return hasp::RigidPose{ { x, 0, 0 }, { 1, 0, 0, 0 } }; };
  hasp::PassivityObserver observer;
  hasp::PassivityController controller;
  const auto tick = [&](double x, double force)
  {
    observer.Tick(at(x), { { force, 0, 0 }, {} });
    controller.Tick(at(x), { { force, 0, 0 }, {} });
  };
  tick(0.0, -5.0);
  tick(1.0, -5.0); // 5 mJ in
  for (int n = 0; n < 100; ++n)
    tick(NaN, 0.0);
  tick(-9.0, 0.0); // 10 mm back, with nothing held
  EXPECT_NEAR(observer.Energy(), 5.0, 1e-12);
  EXPECT_NEAR(controller.Observer().Energy(), 5.0, 1e-12);
}

TEST(PassivityObserver, CountsTurns)
{
  hasp::PassivityObserver observer;
  for (int n = 0; n <= 100; ++n)
    observer.Tick({ glm::dvec3(0.0), hasp::TurnBy({ 0, 0, 0.01 * n }) }, { {}, { 0, 0, -30 } });
  EXPECT_NEAR(observer.Energy(), 30.0, 1e-9);
}

TEST(PassivityController, ActsOnALateSpringWithBoundedDamping)
{
  const auto run = [](int delay)
  {
    hasp::PassivityController controller;
    hasp::PassivityObserver observer; // of what the device holds
    std::array<double, 4> late{};
    double worst = 0.0;
    for (int n = 0; n <= 2000; ++n)
    {
      const double x = 1.0 + std::cos(2.0 * std::acos(-1.0) * 20.0 * n * Tick);
      late[n % 4] = x;
      const double wanted = -2.0 * late[(n + 4 - delay) % 4];
      const hasp::Wrench out =
        controller.Tick({ { x, 0, 0 }, { 1, 0, 0, 0 } }, { { wanted, 0, 0 }, {} });
      worst = std::max(worst, std::abs(out.force.x - wanted));
      observer.Tick({ { x, 0, 0 }, { 1, 0, 0, 0 } }, out);
      EXPECT_NEAR(controller.Observer().Energy(), observer.Energy(), 1e-9) << n;
    }
    EXPECT_EQ(controller.Activations() > 0, worst > 0.0);
    EXPECT_LE(worst, 0.005 * 2.0 * std::acos(-1.0) * 20.0 * 1.05) << "damping is bounded";
    return controller.Activations();
  };
  // On a cosine of 20 Hz and 1 mm at 2 N/mm a force held a tick gives back k v^2 T/2 = 8 mJ/s more
  // than it took, and 3 ticks late 56 mJ/s; 4 mJ are there to begin with.
  EXPECT_GT(run(3), 100U);
  EXPECT_THROW(hasp::PassivityController({ .damping = 0.0 }), std::invalid_argument);
  EXPECT_THROW(hasp::PassivityController({ .allowance = NaN }), std::invalid_argument);
}

// A force F along a motion at v gives F v T a tick. Once the allowance is spent, damping is F / v,
// which leaves no force; a device that rests is left alone. The same of turns, at the lever.
TEST(PassivityController, TakesAsMuchAsIsMissingAndNothingFromWhatRests)
{
  for (const bool turns : { false, true })
  {
    const hasp::PassivityControllerSettings settings;
    hasp::PassivityController controller(settings);
    const double way = 0.01, force = 0.01; // 10 mm/s
    const double turn = way / settings.leverMm, torque = force * settings.leverMm;
    const auto tick = [&](int n)
    {
      if (!turns)
        return controller.Tick({ { way * n, 0, 0 }, { 1, 0, 0, 0 } }, { { force, 0, 0 }, {} })
          .force.x;
      return controller
               .Tick(
                 { glm::dvec3(0.0), hasp::TurnBy({ turn * n, 0, 0 }) }, { {}, { torque, 0, 0 } })
               .torque.x /
             settings.leverMm;
    };
    EXPECT_EQ(tick(0), force);
    for (int n = 1; n < 10'000; ++n)
      ASSERT_EQ(tick(n), force) << "1 mJ is borne";
    double left = force;
    for (int n = 10'000; n < 11'000; ++n)
      left = tick(n);
    EXPECT_NEAR(left, 0.0, 1e-6);
    for (int n = 0; n < 200; ++n)
      tick(11'000); // the filter forgets the motion
    const std::uint64_t until = controller.Activations();
    for (int n = 0; n < 200; ++n)
      EXPECT_EQ(tick(11'000), force);
    EXPECT_EQ(controller.Activations(), until);
  }
}

// Pressed and let go at the pace of a hand: nothing to control.
TEST(PassivityController, IsSilentOnWhatAHandDoesToASpring)
{
  hasp::PassivityController controller;
  for (int n = 0; n <= 2000; ++n)
  {
    const double x = 5.0 - 5.0 * std::cos(std::acos(-1.0) * n / 1000.0);
    const hasp::Wrench wanted{ { -0.33 * x, 0, 0 }, {} };
    const hasp::Wrench out = controller.Tick({ { x, 0, 0 }, { 1, 0, 0, 0 } }, wanted);
    ASSERT_EQ(out.force, wanted.force);
  }
  EXPECT_EQ(controller.Activations(), 0U);
}

TEST(PassivityController, ATickTakesNoMemory)
{
  hasp::PassivityController controller;
  const std::size_t before = hasp::test::NewCount();
  for (int n = 0; n < 50; ++n)
    controller.Tick({ { 0.1 * n, 0, 0 }, { 1, 0, 0, 0 } }, { { -1, 0, 0 }, {} });
  EXPECT_EQ(hasp::test::NewCount(), before);
}

} // namespace
