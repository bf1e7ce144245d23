#pragma once
#include "Haptics/ImplicitField.h"

#include <array>
#include <cstdint>

namespace hasp
{

struct PointProxySettings
{
  double stiffness = 0.33; ///< N/mm between device and proxy; > 0
  double forceLimit = 4.0; ///< N; F_limit tanh(k d / F_limit); > 0
  /// Of the ball that touches, mm; >= 0. 0: a point, the god-object (Zilles and Salisbury 1995);
  /// else Ruspini's sphere (1997), whose middle is held this far off the surface.
  double radiusMm = 0.0;
  double friction = 0.0; ///< Coulomb's mu; >= 0
  /// Of one step, past what is known to be free, mm; > 0. Under the thickness of the thinnest wall.
  double stepMm = 0.1;
  int steps = 32; ///< at most, a tick; > 0
};

struct ProxyTick
{
  glm::dvec3 onDevice{ 0.0 }; ///< N
  glm::dvec3 proxy{ 0.0 };    ///< the ball's middle, mm
  glm::dvec3 normal{ 0.0 };   ///< of the surface where it touches; {0} if it does not
  bool touches = false;
  bool settled = false; ///< false: steps ran out, or the device has no position
  int samples = 0;      ///< of the field
};

/// A point for three degrees of freedom that stays outside of an implicit surface while the device
/// goes in: the place on the surface that the device would drag it to. A thin plate holds however
/// deep the device goes, since the proxy knows which side it came from.
///
/// Each step goes towards the nearest point to the device that the planes touched nearby allow
/// (one, two in an edge, three in a corner), never farther than the field is free there and stepMm
/// more; what gets in is brought back to the surface on its way. Field values are taken for
/// distances by value / |gradient|, so grey values minus an isovalue work as well as distances do.
/// With friction the proxy rests while the device is within the cone of mu around the normal.
/// Threads: one, HAPTIC once constructed; no memory, nothing throws. A sample or two of the field a
/// step; 2 or 3 steps a tick at rest.
class PointProxy
{
public:
  /// Throws std::invalid_argument with the value and its legal range.
  explicit PointProxy(const PointProxySettings& settings = {});
  void Place(const glm::dvec3& at) noexcept { this->At = at; }
  const glm::dvec3& Position() const noexcept { return this->At; }
  ProxyTick Tick(const glm::dvec3& device, const ImplicitField& field) noexcept;

private:
  struct Plane
  {
    glm::dvec3 at, normal;
  };
  struct Near
  {
    double distance = 0.0; ///< to where the ball touches; NaN: no gradient
    glm::dvec3 normal{ 0.0 };
  };
  class Walk;

  PointProxySettings Settings;
  glm::dvec3 At{ 0.0 };
};

/// The nearest point to `goal` for which (x - at) . normal >= 0 of up to three planes; `goal` where
/// they leave no room. Any thread.
glm::dvec3 NearestAbove(
  const glm::dvec3& goal, const glm::dvec3* at, const glm::dvec3* normals, int planes) noexcept;

} // namespace hasp
