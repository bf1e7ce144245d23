#include "Evaluation/PartClaims.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace hasp
{

namespace
{
void RequireRange(const std::string& what, double value, double above, double least, double most)
{
  if (value > above && value >= least && value <= most)
    return;
  std::ostringstream text;
  text << "claims: " << what << " is " << value << ", must be "
       << (above >= least ? "above " : "from ") << (above >= least ? above : least) << " to "
       << most;
  throw std::invalid_argument(text.str());
}

void RequireAbove0(const std::string& what, double value, double most)
{
  RequireRange(what, value, 0.0, 0.0, most);
}

void RequireFrom0(const std::string& what, double value, double most)
{
  RequireRange(what, value, -1.0, 0.0, most);
}

void RequirePlace(const std::string& what, const glm::dvec3& p)
{
  if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
    throw std::invalid_argument("claims: " + what + " is not finite");
}

void RequireUnit(const std::string& what, const glm::dvec3& d)
{
  if (!(std::abs(glm::length(d) - 1.0) <= 1e-3))
    throw std::invalid_argument(
      "claims: " + what + " has length " + std::to_string(glm::length(d)) + ", must have 1");
}
} // namespace

std::string NameOfHole(const ClaimedHole& hole, std::size_t number)
{
  return hole.name.empty() ? "holes[" + std::to_string(number) + "]" : hole.name;
}

bool ClaimFit(const PartClaims& claims)
{
  return claims.shell || claims.withdrawal || !claims.slots.empty() || !claims.holes.empty();
}

void ValidateClaims(const PartClaims& claims)
{
  if (!std::isfinite(claims.isovalue))
    throw std::invalid_argument("claims: isovalue is not finite");
  RequireFrom0("ignoreBelowMm3", claims.ignoreBelowMm3, 1e6);
  RequireFrom0("leastWallMm", claims.leastWallMm, 50.0);
  RequireFrom0("leastUncutMm", claims.leastUncutMm, 50.0);
  if (claims.withdrawal)
    RequireUnit("withdrawal", *claims.withdrawal);
  if (claims.shell)
  {
    RequireFrom0("gapMm", claims.shell->gapMm, 10.0);
    RequireAbove0("gapToleranceMm", claims.shell->gapToleranceMm, 10.0);
    RequireFrom0("leastGapShare", claims.shell->leastGapShare, 1.0);
    RequireAbove0("thicknessMm", claims.shell->thicknessMm, 50.0);
    RequireAbove0("thicknessToleranceMm", claims.shell->thicknessToleranceMm, 50.0);
    RequireFrom0("besideMm3", claims.shell->besideMm3, 1e7);
  }
  for (std::size_t n = 0; n < claims.slots.size(); ++n)
  {
    const ClaimedSlot& slot = claims.slots[n];
    const std::string name = "slots[" + std::to_string(n) + "].";
    RequirePlace(name + "point", slot.point);
    RequireUnit(name + "normal", slot.normal);
    RequireUnit(name + "along", slot.along);
    if (std::abs(glm::dot(slot.normal, slot.along)) > 1e-3)
      throw std::invalid_argument("claims: " + name + "along is not upright on its normal");
    RequireAbove0(name + "widthMm", slot.widthMm, 20.0);
    RequireAbove0(name + "lengthMm", slot.lengthMm, 500.0);
    RequireAbove0(name + "toleranceMm", slot.toleranceMm, 10.0);
  }
  for (std::size_t n = 0; n < claims.holes.size(); ++n)
  {
    const ClaimedHole& hole = claims.holes[n];
    const std::string name = NameOfHole(hole, n) + ".";
    RequirePlace(name + "point", hole.point);
    RequireUnit(name + "axis", hole.axis);
    RequireAbove0(name + "diameterMm", hole.diameterMm, 50.0);
    RequireAbove0(name + "toleranceMm", hole.toleranceMm, 10.0);
    RequireRange(name + "lowMm", hole.lowMm, -2000.0, -1000.0, 1000.0);
    RequireRange(name + "highMm", hole.highMm, hole.lowMm, -1000.0, 1000.0);
    RequireFrom0(name + "clearMm", hole.clearMm, 1000.0);
    RequireFrom0(name + "roomMm", hole.roomMm, 50.0);
  }
}

} // namespace hasp
