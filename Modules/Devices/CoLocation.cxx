#include "Devices/CoLocation.h"

#include "Devices/RigidFit.h"

#include <sstream>
#include <stdexcept>
#include <utility>

namespace hasp
{

namespace
{
constexpr const char* What = "co-location";
/// Devices are out by some percent at the ends of their arms; units by a factor of 10 or more.
constexpr double MostOff = 0.1;
} // namespace

CoLocationFit FitCoLocation(std::span<const CoLocationPair> pairs)
{
  std::vector<PointPair> points;
  for (const CoLocationPair& pair : pairs)
    points.push_back({ pair.deviceMm, pair.worldMm });
  RigidFit fit = FitRigid(points, { What, "for the device", "in the world", "the device" });
  if (!(fit.spreadRatio >= 1.0 - MostOff && fit.spreadRatio <= 1.0 + MostOff))
  {
    std::ostringstream text;
    text << What << ": points lie " << fit.spreadRatio
         << " times as wide in the world as for the device, must be 1 within " << MostOff
         << "; are both in mm, is the device homed, and is the scene drawn at its own size?";
    throw std::invalid_argument(text.str());
  }
  return { { fit.shift, fit.turn }, std::move(fit.residualsMm), fit.rmsMm, fit.spreadRatio };
}

} // namespace hasp
