#pragma once
#include "Evaluation/PartClaims.h"
#include "Evaluation/TriangleTree.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>

namespace hasp
{

/// A round hole as it is in a mesh. mm.
struct HoleFit
{
  std::size_t sections = 0;  ///< along the axis, each with a wall around it; 0: no hole
  double touchedShare = 0.0; ///< of the wall there is around the axis, at best, in [0, 1]
  double guideMm = 0.0;      ///< the height of the sections: what guides a drill or pin
  double diameterMm = 0.0;   ///< of the cylinder fitted to its wall
  double leastMm = 0.0;      ///< of the widest pin along that cylinder's axis that goes through
  double roundnessMm = 0.0;  ///< 95 % of what faces it lie within that of the cylinder
  double tiltDegrees = 0.0;  ///< between the fitted axis and the claimed one
  double offsetMm = 0.0;     ///< of the fitted axis from the claimed one, in the middle of the hole
  glm::dvec3 middle{ 0.0 };  ///< on the fitted axis
  std::optional<glm::dvec3> blockedAt; ///< material on the axis, if there is any
};

/// Looks for the hole where it is claimed to be, by rays from its axis.
///
/// Sections are 0.25 mm apart, wherever the axis, which has no ends, is within the mesh's box and
/// the claim's bore; each has 48 rays. Between sections of the bore and clearMm beyond both its
/// ends it is looked whether material is in the way. A wall faces the axis within 60 degrees, and
/// lies within 0.75 diameters + 0.5 mm; a section counts if 36 rays meet one. The cylinder is
/// fitted to the walls of these that face the axis within 30 degrees, since an oblique side that
/// the hole ends in is around the axis, too, and turns no drill; by least squares (Gauss-Newton on
/// its axis and radius; its axis' direction only where the hole is at least half as high as wide).
/// Its roundness is of those walls; the pin goes by all of them. The pin may lie beside that axis,
/// as one does that a single burr pushes aside; its place is looked for by steps down to a
/// thousandth of the radius. The mesh should be closed: see FitSlot. Any thread; one core; about 50
/// us a section.
HoleFit FitHole(const TriangleTree& tree, const ClaimedHole& hole);

} // namespace hasp
