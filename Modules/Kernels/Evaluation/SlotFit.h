#pragma once
#include "Evaluation/PartClaims.h"
#include "Evaluation/TriangleTree.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>

namespace hasp
{

/// A saw slot as it is in a mesh. mm.
struct SlotFit
{
  std::size_t places = 0;    ///< of its middle plane with a wall on either side; 0: no slot
  double leastWidthMm = 0.0; ///< the narrowest of them: what a blade must pass
  glm::dvec3 leastAt{ 0.0 }; ///< in the middle plane
  double widthMm = 0.0;      ///< between the two planes fitted to its walls, in their middle
  double flatnessMm = 0.0;   ///< 95 % of the walls lie within that of their plane
  double tiltDegrees = 0.0;  ///< between the slot and the wall's plane that is farther off
  double offsetMm = 0.0;     ///< of the middle between both planes from the claimed plane
  double lengthMm = 0.0;     ///< along `along`, from the first to the last place
  double guideMm = 0.0;      ///< across it, in the plane: the height that guides the blade
  std::optional<glm::dvec3> blockedAt; ///< material in the middle plane, if there is any
};

/// Looks for the slot where it is claimed to be, by rays from its middle plane to either side.
///
/// Places are 0.25 mm apart over the claimed length and all of the mesh across it. A wall faces the
/// plane within 20 degrees and lies within twice the claimed width + 1 mm. Planes are fitted by
/// least squares of the distances to the middle plane, to the nearest three quarters of a wall's
/// places; walls more than 1 mm behind them belong to something else and are left out. Of the
/// length, 0.25 mm at either end are left out: ends may be round. The mesh should be closed:
/// whether a place is in material is told from the first wall that a ray meets. Any thread; one
/// core; about 2 us a place.
SlotFit FitSlot(const TriangleTree& tree, const ClaimedSlot& slot);

} // namespace hasp
