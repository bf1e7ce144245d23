#pragma once
#include "Planning/Plan.h"

#include <optional>
#include <span>
#include <vector>

/// A transplant by the line that its segments lie along, as a hand touches it in the jaw. Pure; any
/// thread; mm.
namespace hasp
{

/// Where the joints of a transplant of the plan are planned, ends in their faces: what AlongPath
/// takes.
std::vector<glm::dvec3> PathOf(const Plan& plan, const PlanTransplant& transplant);

/// The transplant with its joints along a path: mitres inside, and at its ends the faces of its
/// cuts, or, where it names none, a square cut at the path's end (JointsOf of TransplantRecipe.h).
/// Directions outward go with their segments; new segments get the last one's.
///
/// path   2 to 6 places, where the plan puts the jaw. Its first and last leg are cut or lengthened
/// to
///        the faces
/// Throws std::invalid_argument as JointsOf, but for cuts, which are named as the plan names them.
PlanTransplant AlongPath(const Plan& plan, PlanTransplant transplant,
  std::span<const glm::dvec3> path, double leastSegmentMm = 20.0);

/// One place more, in the middle of the longest leg; one less: the inner place at which the path
/// bends least. The same path where there is no room for more, or nothing to leave out.
std::vector<glm::dvec3> PathWithOneMore(std::vector<glm::dvec3> path);
std::vector<glm::dvec3> PathWithOneLess(std::vector<glm::dvec3> path);
inline constexpr std::size_t MostPathPlaces = 6;

/// The stump that a cut leaves: of the pieces that are kept beyond its blade, as the other cut sees
/// it, the one whose seed is nearest to the blade's middle; 0: there is none.
PlanId StumpOf(const Plan& plan, const PlanCut& cut, const PlanCut& other);

/// Upright on the line of a path at one of its places, as near to `direction` as that can be: unit.
/// Nothing where `direction` is within 30 degrees of the line, as on a face that was sawn.
std::optional<glm::dvec3> AcrossPath(
  std::span<const glm::dvec3> path, std::size_t place, const glm::dvec3& direction);

/// The side of a donor bone that a touched place is on: unit, from the axis to it, upright on the
/// piece of the axis that is nearest. Throws std::invalid_argument: fewer than two places, a place
/// on the axis.
glm::dvec3 LateralTowards(std::span<const glm::dvec3> axis, const glm::dvec3& place);

} // namespace hasp
