#pragma once
#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hasp
{

/// The plane that a head is mirrored at.
struct MirrorPlane
{
  glm::dvec3 point{ 0.0 };
  glm::dvec3 normal{ 1.0, 0.0, 0.0 }; ///< unit, either way

  bool operator==(const MirrorPlane&) const noexcept = default;
};

/// Everything that an implant for a hole in the skull is made from, besides the CT: its healthy
/// side, mirrored, cut to the hole. World = patient LPS, mm. A plain value.
struct ImplantRecipe
{
  std::string note;              ///< free text, kept
  double isovalue = 226.0;       ///< bone is value >= isovalue (226 HU: InVesalius' preset)
  double ignoreBelowMm3 = 100.0; ///< pieces of "bone" smaller than this do not count, [0, 1e6]
  std::optional<MirrorPlane> mirror = std::nullopt; ///< none: the plane of best symmetry is fitted
  std::vector<glm::dvec3> outline; ///< on the outer table around the hole, in order, 3 to 200: all
                                   ///< of the hole and bone all around it
  std::optional<glm::dvec3> axis = std::nullopt; ///< unit, out of the head: it is put in against
                                                 ///< it; none: upright on the outline
  double clearanceMm = 0.5; ///< to the hole's edge, seen along the axis, [0, 5]
  double thicknessMm = 4.0; ///< below the mirrored outer table, (0, 20]
  double spacingMm = 0.5;   ///< of the working grid, [0.1, 2]
  double holeDiameterMm =
    0.0;                    ///< perforation, along the axis: 0, or up to 20; for fluids and growth
  double holePitchMm = 8.0; ///< between the middles of neighbouring holes, [1, 100]
  double holeEdgeMm = 3.0;  ///< least, from a hole's rim to the implant's edge, [0.5, 50]

  bool operator==(const ImplantRecipe&) const noexcept = default;
};

/// Throws std::invalid_argument unless every number is finite and in its range, directions are unit
/// within 1e-3, no two neighbours of the outline are the same point, holes leave at least a spacing
/// between them, and the grid is fine enough for what it must show (thickness, holes: two spacings
/// at least). The message names the key as it stands in the file, its value and the legal range.
void ValidateImplantRecipe(const ImplantRecipe& recipe);

} // namespace hasp
