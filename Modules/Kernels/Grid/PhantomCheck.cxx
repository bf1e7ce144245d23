#include "Grid/PhantomAnatomy.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hasp
{
namespace
{

void Require(bool holds, const char* name, double value, const char* range)
{
  if (!holds || !std::isfinite(value))
    throw std::invalid_argument(
      "phantom: " + std::string(name) + " is " + std::to_string(value) + ", must be " + range);
}
void RequireFinite(double value, const char* name)
{
  Require(true, name, value, "finite");
}
void RequirePositive(double value, const char* name)
{
  Require(value > 0.0, name, value, "> 0");
}
void RequireNotNegative(double value, const char* name)
{
  Require(value >= 0.0, name, value, ">= 0");
}

} // namespace

void CheckPhantom(const PhantomSettings& s)
{
  for (int a = 0; a < 3; ++a)
  {
    RequireFinite(s.center[a], "center");
    RequireFinite(s.skinRadii[a], "skinRadii");
    RequireNotNegative(s.blurMm[a], "blurMm");
  }
  RequirePositive(s.scalpMm, "scalpMm");
  RequirePositive(s.skullMm, "skullMm");
  const double thinnest = std::min({ s.skinRadii.x, s.skinRadii.y, s.skinRadii.z });
  if (!(thinnest - s.scalpMm - s.skullMm >= 30.0))
    throw std::invalid_argument("phantom: the smallest of skinRadii is " +
                                std::to_string(thinnest) +
                                " mm, must leave 30 mm inside scalp and skull");
  RequireFinite(s.skullBaseMm, "skullBaseMm");
  RequirePositive(s.tableMm, "tableMm");
  RequirePositive(s.jawCortexMm, "jawCortexMm");
  RequirePositive(s.fibulaCortexMm, "fibulaCortexMm");
  RequirePositive(s.enamelMm, "enamelMm");
  for (const double hu : { s.airHU, s.softHU, s.boneHU, s.diploeHU, s.jawMarrowHU, s.fibulaMarrowHU,
         s.dentineHU, s.enamelHU })
    RequireFinite(hu, "a tissue's HU");
  RequirePositive(s.edgeMm, "edgeMm");
  RequireNotNegative(s.sliceMm, "sliceMm");
  RequireNotNegative(s.noiseHU, "noiseHU");
  RequireNotNegative(s.fieldRadiusMm, "fieldRadiusMm");
  RequireFinite(s.metal.crownHU, "metal.crownHU");
  RequireNotNegative(s.metal.streakHU, "metal.streakHU");
  RequireNotNegative(s.metal.bandHU, "metal.bandHU");
  RequirePositive(s.metal.decayMm, "metal.decayMm");
  RequirePositive(s.metal.sliceMm, "metal.sliceMm");
  RequirePositive(s.coneBeam.scale, "coneBeam.scale");
  RequireFinite(s.coneBeam.offset, "coneBeam.offset");
  Require(s.coneBeam.cupping >= 0.0 && s.coneBeam.cupping < 1.0, "coneBeam.cupping",
    s.coneBeam.cupping, "in [0, 1)");
  RequirePositive(s.coneBeam.cupRadiusMm, "coneBeam.cupRadiusMm");
}

} // namespace hasp
