#pragma once
// A square foot above level ground, for tests of the whole step.
#include "Haptics/HapticStep.h"
#include "SampledDistance.h"

#include <limits>
#include <memory>
#include <vector>

namespace hasp::testing
{

inline RigidPose At(double x, double y, double z)
{
  return { { x, y, z }, { 1, 0, 0, 0 } };
}

/// A square foot of 20 mm, z = 0, facing down, n x n points.
inline std::shared_ptr<const PointShell> Foot(int n = 64)
{
  std::vector<SurfacePoint> points;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      points.push_back({ { 20.0F * ((i + 0.5F) / n - 0.5F), 20.0F * ((j + 0.5F) / n - 0.5F), 0.0F },
        { 0, 0, -1 } });
  return PointShell::OfPoints(points, 400.0, glm::dvec3(0.0), { n * n, 64, 1 });
}

/// z < 0 is solid, on a skewed, anisotropic grid.
inline std::shared_ptr<const DistanceMap> Ground(double height = 0.0)
{
  static const SampledDistance flat(
    HalfSpace(glm::dvec3(0.0), { 0, 0, 1 }), SkewGrid({ 80, 60, 40 }));
  if (height == 0.0)
    return std::make_shared<DistanceMap>(flat.View());
  const SampledDistance higher(HalfSpace({ 0, 0, height }, { 0, 0, 1 }), SkewGrid({ 80, 60, 40 }));
  return std::make_shared<DistanceMap>(higher.View());
}

inline HapticStepSettings Settings()
{
  HapticStepSettings settings;
  settings.budgetUs = std::numeric_limits<double>::infinity(); // the same on every machine
  settings.limits.rampInS = 0.0;
  settings.contact.stiffness = 0.1F; // 40 N/mm for the foot
  return settings;
}

inline std::unique_ptr<HapticScene> GroundScene(double height = 0.0)
{
  return std::make_unique<HapticScene>(
    std::vector<HapticShell>{ { Foot(), {} } }, std::vector<HapticBody>{ { Ground(height), {} } });
}

inline HapticTick Ticks(HapticStep& step, const RigidPose& device, int ticks)
{
  HapticTick tick;
  for (int n = 0; n < ticks; ++n)
    tick = step.Tick(device);
  return tick;
}

/// A step in whose scene everything has grown to its full weight, at z = 5.
inline HapticStep Ready(const HapticStepSettings& settings, std::unique_ptr<HapticScene> scene)
{
  HapticStep step(settings);
  step.Swap(scene);
  step.Place(At(0, 0, 5));
  Ticks(step, At(0, 0, 5), 200);
  return step;
}

} // namespace hasp::testing
