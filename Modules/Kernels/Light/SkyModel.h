#pragma once
#include "Light/Environment.h"

namespace hasp
{

struct SkySettings
{
  double sunElevation = 0.8; ///< radians above the horizon, [0, pi/2]
  /// Radians from the centre of the map, which looks forward, to the right: as on a compass.
  double sunAzimuth = 0.6;
  double turbidity = 3;       ///< [2, 10]: 2 is clear, 6 is hazy
  glm::vec3 ground{ 0.3F };   ///< albedo of what lies below the horizon, [0, 1]
  double sunShare = 0.5;      ///< of the horizontal irradiance, from the sun's disc, [0, 1]
  double sunHalfAngle = 0.05; ///< of the disc, radians, [0.002, 0.5]; larger is softer
};

/// Analytic daylight: Preetham, Shirley and Smits 1999 ("A Practical Analytic Model for Daylight"),
/// with a sun, as a map of 2 height x height pixels.
///
/// Linear sRGB, scaled so that a plane that faces up gets the irradiance pi in luminance (0.2126 R
/// + 0.7152 G + 0.0722 B): white and diffuse, it has the radiance 1 under the open sky. Below the
/// horizon all is ground times that irradiance over pi.
///
/// Deviates from the paper: the brightness of the zenith cancels with the scale; how bright the sun
/// is against the sky is a setting; the sun's colour is the paper's Rayleigh and aerosol
/// transmission at 610, 550 and 465 nm, without ozone, other gases and water. Colours that sRGB
/// does not hold are clamped to it. The paper fitted turbidity 2 to 6; above, and with the sun on
/// the horizon, colours are extrapolated.
///
/// The sky is that of a pixel's centre. The sun covers parts of pixels, and its brightness makes up
/// for what that loses, so that its share is right at any height of the map, also for a disc
/// smaller than a pixel. Of a disc that is cut by the horizon the part above has the whole share:
/// on the horizon a disc of 0.05 has radiances of 50,000 to 90,000, a smaller one more.
///
/// Takes 0.1 us a pixel, 15 ms at the default height, and for the smallest sun 40 ms more. Throws
/// std::invalid_argument on settings out of range, or if height is not an even number in [16,
/// 8192].
EnvironmentMap MakeSky(const SkySettings& settings, int height = 256);

} // namespace hasp
