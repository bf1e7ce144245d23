#pragma once
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <string>
#include <vector>

namespace hasp
{

/// A screw's hole through a plate: a bore, and above it room for a countersunk head.
struct PlateScrew
{
  glm::dvec3 point{ 0.0 }; ///< on the bone below the plate, within 3 mm, world mm
  std::optional<glm::dvec3> axis =
    std::nullopt;              ///< unit, out of the bone; none: upright on the plate
  double diameterMm = 2.4;     ///< of the bore, (0, 20]
  double headDiameterMm = 4.0; ///< of the head's room, at the outer face; [diameterMm, 30]
  double headDepthMm = 0.3;    ///< straight room from the outer face down to the cone, [0, 20]
  double headAngleDeg = 90.0;  ///< of the cone from there down to the bore, whole, [30, 150]
  double lengthMm = 8.0;       ///< of the screw below the plate, (0, 200]

  bool operator==(const PlateScrew&) const noexcept = default;
};

/// A piece of bone and where it shall be: what is at p comes to lie at position + orientation * p.
struct PlateFragment
{
  int label = 1;                                ///< its value in the labels, [1, 65535]
  glm::dvec3 position{ 0.0 };                   ///< mm, [-4000, 4000]
  glm::dquat orientation{ 1.0, 0.0, 0.0, 0.0 }; ///< (w, x, y, z), unit within 1e-6

  bool operator==(const PlateFragment&) const noexcept = default;
};

/// Everything an osteosynthesis plate is made from, besides the CT and its labels: a ribbon of one
/// section along landmarks. World = patient LPS, mm; of fragments that are moved, where they shall
/// be. A plain value. Width, thickness and bevel are those of SlicerBoneReconstructionPlanner.
struct PlateRecipe
{
  std::string note;                  ///< free text, kept
  double isovalue = 226.0;           ///< bone is value >= isovalue (226 HU: InVesalius' preset)
  double ignoreBelowMm3 = 100.0;     ///< "bone" in smaller pieces is none, without fragments, [0,
                                     ///< 1e6]
  std::vector<glm::dvec3> landmarks; ///< on the bone, in order, 2 to 200; the plate's middle line
                                     ///< is a Catmull-Rom curve through them, laid on the bone
  double gapMm = 0.2;                ///< bone to plate, [0, 5]; 0 to 0.3 is usual
  double thicknessMm = 2.5;          ///< (0, 20]
  double widthMm = 7.0;              ///< (0, 100]; the ends are round
  double bevelMm = 0.75; ///< cut off the outer edges along both faces, 0 or [spacingMm, 0.8
                         ///< thicknessMm], at most a third of the width
  double bridgeMm = 0.0; ///< lines of fracture and grooves that a ball of this radius does not
                         ///< enter are bridged, 0 or [spacingMm, 10]
  double edgeDistanceMm = 1.0;    ///< least, from a hole's rim to the plate's edge, [0, 20]
  double holeDistanceMm = 1.0;    ///< least, between the rims of two holes, [0, 20]
  double spacingMm = 0.4;         ///< of the working grid, [0.05, 2]
  std::vector<PlateScrew> screws; ///< at most 100
  std::vector<PlateFragment>
    fragments; ///< pieces that are moved, each label once, at most 100; none: bone as scanned

  bool operator==(const PlateRecipe&) const noexcept = default;
};

/// Throws std::invalid_argument unless every number is finite and in its range, directions are unit
/// within 1e-3, no two neighbouring landmarks are the same point, heads fit into the thickness, and
/// the grid is fine enough for what it must show (thickness, bores: two spacings at least). The
/// message names the key as it stands in the file, its value and the legal range.
void ValidatePlateRecipe(const PlateRecipe& recipe);

/// From the outer face to the bore, mm: headDepthMm and the cone.
double ScrewHeadDepth(const PlateScrew& screw);

} // namespace hasp
