#pragma once
#include <glm/vec3.hpp>

#include <vector>

namespace hasp
{

/// A thickness, the area that it was found on, and where.
struct ThinPlace
{
  double mm = 0.0;
  double areaMm2 = 0.0;
  glm::dvec3 at{ 0.0 };
};

/// The smallest detail that counts as thin: 0.4 x 0.4 mm, what resin printers engrave (Formlabs'
/// design guide). Triangles along an edge may leave flakes below it that no printer makes.
inline constexpr double ThinDetailMm = 0.4;

/// The least thickness such that places that are no thicker make up ThinDetailMm^2 of area, of each
/// of `sides` that were measured, within a cube of 1.5 ThinDetailMm; of all the places if there is
/// less. The place is that of the last that was needed. mm 0: there are no places. A fin along an
/// edge counts once it is as wide as a third of the detail. Any thread; O(n log n).
ThinPlace ThinnestPlace(std::vector<ThinPlace> places, int sides);

} // namespace hasp
