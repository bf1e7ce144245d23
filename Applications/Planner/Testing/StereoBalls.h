#pragma once
#include "BallScan.h"
#include "LayoutEntries.h"

#include <algorithm>
#include <array>
#include <cmath>

/// Two balls, seen from the front in life size by two eyes before a screen.
namespace stereo
{

using Vector = std::array<double, 3>; ///< in the room: right, up, towards the viewer, mm

inline constexpr std::array<double, 2> ScreenMm{ 320.0, 400.0 }; // of one eye: as its pixels are
/// Above and before the screen, below and behind it.
inline constexpr BallScan::Place Near{ -20, -60, 40 }, Far{ 20, 60, -40 };
inline constexpr std::array<BallScan::Place, 2> Balls{ Near, Far };

/// From the front: the patient's left is at the right, and his face towards the viewer.
inline Vector InRoom(const BallScan::Place& lps)
{
  return { lps[0], lps[2], -lps[1] };
}

/// A viewer before the middle of the screen.
struct Head
{
  Vector at{ 0, 0, 600 };
  double tiltDegrees = 0.0; ///< to his left: the right eye is the higher one
  double eyesMm = 63.0;
};

/// Middles of the balls, each of them as the left eye and as the right one sees it, in pixels of
/// the screen that is theirs, from its upper left.
using Seen = std::array<std::array<std::array<double, 2>, 2>, 2>; // [eye][ball][x or y]

/// By similar triangles.
inline Seen Expected(const Head& head, const layout::Rect& window)
{
  const std::array<double, 2> pixels{ window[2] / 2.0, double(window[3]) };
  const double tilt = head.tiltDegrees * M_PI / 180.0;
  Seen seen{};
  for (int eye = 0; eye < 2; ++eye)
    for (int ball = 0; ball < 2; ++ball)
    {
      const double aside = (eye == 0 ? -0.5 : 0.5) * head.eyesMm;
      const Vector from{ head.at[0] + aside * std::cos(tilt), head.at[1] + aside * std::sin(tilt),
        head.at[2] };
      const Vector to = InRoom(Balls[std::size_t(ball)]);
      const double share = from[2] / (from[2] - to[2]);
      const double x = from[0] + share * (to[0] - from[0]), y = from[1] + share * (to[1] - from[1]);
      seen[std::size_t(eye)][std::size_t(ball)] = { (0.5 + x / ScreenMm[0]) * pixels[0],
        (0.5 - y / ScreenMm[1]) * pixels[1] };
    }
  return seen;
}

inline double Farthest(const Seen& a, const Seen& b)
{
  double most = 0.0;
  for (const std::size_t n : { 0U, 1U, 2U, 3U })
    most = std::max({ most, std::abs(a[n / 2][n % 2][0] - b[n / 2][n % 2][0]),
      std::abs(a[n / 2][n % 2][1] - b[n / 2][n % 2][1]) });
  return most;
}

} // namespace stereo
