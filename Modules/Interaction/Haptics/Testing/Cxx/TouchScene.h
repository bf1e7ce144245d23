#ifndef TouchScene_h
#define TouchScene_h

// A ball that stands still and a tool of one point, pressed by a hand: all of it in closed form.
#include "HapticChain.h"

#include "Devices/SimulatedHapticDevice.h"
#include "Grid/AnalyticVolumes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace hasp::testing
{

inline constexpr double BallRadius = 15.0, PlateTop = 3.0, PointArea = 200.0; // mm, mm^2

inline RigidPose At(double x, double y, double z)
{
  return { { x, y, z }, { 1, 0, 0, 0 } };
}

/// Samples 0.5 mm apart, 20 mm each way: the distance itself, within int16 steps.
inline std::shared_ptr<const DistanceMap> MapOf(double (*distance)(const glm::dvec3&))
{
  const GridGeometry grid{ glm::ivec3(81), glm::dvec3(-20), glm::dvec3(0.5), glm::dmat3(1) };
  const auto samples = SampleAnalytic<float>({ "body", distance, 1.0 }, grid, 1.0, 0.0);
  return std::make_shared<const DistanceMap>(GridView<const float>{ samples.data(), grid });
}

/// About the world's origin.
inline std::shared_ptr<const DistanceMap> BallMap()
{
  static const auto made = MapOf([](const glm::dvec3& p) { return glm::length(p) - BallRadius; });
  return made;
}

/// A point that looks down and stands for PointArea.
inline std::shared_ptr<const PointShell> TipShell()
{
  const SurfacePoint tip{ { 0, 0, 0 }, { 0, 0, -1 } };
  return PointShell::OfPoints({ &tip, 1 }, PointArea, glm::dvec3(0.0));
}

inline std::vector<HapticShell> Tip()
{
  return { { TipShell(), {} } };
}
inline std::vector<HapticBody> Ball()
{
  return { { BallMap(), {} } };
}
/// Level, as far down as up: nothing slides off it.
inline std::vector<HapticBody> Plate()
{
  static const auto made = MapOf([](const glm::dvec3& p) { return std::abs(p.z) - PlateTop; });
  return { { made, {} } };
}

inline std::unique_ptr<HapticSceneOffer> Scene(
  std::uint64_t number = 1, std::vector<HapticBody> bodies = Ball())
{
  auto offer = std::make_unique<HapticSceneOffer>();
  offer->scene = std::make_unique<HapticScene>(Tip(), std::move(bodies));
  offer->number = number;
  return offer;
}

inline HapticChainSettings Settings()
{
  HapticChainSettings settings;
  settings.step.budgetUs = std::numeric_limits<double>::infinity(); // the same on every machine
  settings.step.limits.rampInS = 0.05;
  settings.step.leastContactMm2 = 0.0; // contact is a linear spring: a closed form
  return settings;
}

/// A hand that holds the device at a place; firm.
inline SimulatedDeviceSettings HandSettings()
{
  SimulatedDeviceSettings settings;
  settings.grip = FirmGrip();
  settings.profile.positionQuantumMm = 0.001;
  return settings;
}
inline std::unique_ptr<SimulatedHapticDevice> HandAt(
  const RigidPose& start, std::vector<HandMotion> motions = {})
{
  return std::make_unique<SimulatedHapticDevice>(
    HandSettings(), HandIntention(start, std::move(motions)));
}

/// Contact so hard that no hand gets through a body.
inline HapticChainSettings Firm()
{
  HapticChainSettings settings = Settings();
  settings.step.contact.stiffness = 0.02F;
  return settings;
}

/// Hand, coupling and contact in series where the hand wants to be `deep` mm under the ball's top:
/// N, and how deep the tool is then.
struct Pressed
{
  double forceN, depthMm;
};
inline Pressed PressedBall(double deep, const CouplingSpring& spring, double stiffness)
{
  const double hand = FirmGrip().springNPerMm, contact = stiffness * PointArea;
  double force = 0.0;
  for (int n = 0; n < 1000; ++n) // F = Fs tanh(k (deep - F / hand - F / contact) / Fs), damped
    force += 0.2 * (spring.forceLimit *
                       std::tanh(spring.stiffness * (deep - force / hand - force / contact) /
                                 spring.forceLimit) -
                     force);
  return { force, force / contact };
}

/// Ticks of a millisecond, in virtual time.
inline const HapticSnapshot& Ticks(HapticChain& chain, int ticks, std::int64_t& nowNs)
{
  static std::uint64_t number = 0;
  for (int n = 0; n < ticks; ++n)
    chain.Tick(number++, nowNs += 1'000'000);
  return *chain.Latest();
}

} // namespace hasp::testing

#endif
