#pragma once
#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace hasp
{

/// A saw slot: cuts right through the guide along its plane.
struct GuideSlot
{
  glm::dvec3 point{ 0.0 }; ///< middle of the slot, world mm
  glm::dvec3 normal{ 1.0, 0.0,
    0.0 };                ///< of the saw plane; unit, not along the withdrawal direction
  double widthMm = 1.0;   ///< the saw's kerf and its play, (0, 20]
  double lengthMm = 20.0; ///< in the saw plane, across the withdrawal direction, (0, 500]

  bool operator==(const GuideSlot&) const noexcept = default;
};

/// A pin or drill hole: a cylinder right through the guide.
struct GuideHole
{
  glm::dvec3 point{ 0.0 };          ///< on the axis, world mm
  glm::dvec3 axis{ 0.0, 0.0, 1.0 }; ///< unit
  double diameterMm = 2.0;          ///< (0, 20]

  bool operator==(const GuideHole&) const noexcept = default;
};

enum class GuideOutline
{
  Open,   ///< a band along the landmarks
  Closed, ///< a ring: the last landmark joins the first
  Filled  ///< all bone inside the ring too, seen along the withdrawal direction
};

/// Everything a guide is made from, besides the CT. World = patient LPS, mm. A plain value.
struct GuideRecipe
{
  std::string note;                  ///< free text, kept
  double isovalue = 226.0;           ///< bone is value >= isovalue (226 HU: InVesalius' preset)
  std::vector<glm::dvec3> landmarks; ///< on the bone, in order; two or more, three for a ring
  GuideOutline outline = GuideOutline::Open;
  glm::dvec3 withdrawal{ 0.0, 0.0, 1.0 }; ///< unit; the guide lifts off along it
  double gapMm = 0.3;                     ///< bone to inner wall, [0, 10]; 0.2 to 0.5 is usual
  double thicknessMm = 2.5;               ///< inner to outer wall, (0, 50]
  double widthMm = 14.0;                  ///< of the band around the landmarks, (0, 200]
  double spacingMm = 0.4;                 ///< of the working grid, [0.05, 2]
  double ignoreBelowMm3 = 100.0; ///< pieces of "bone" smaller than this do not count, [0, 1e6]
  std::vector<GuideSlot> slots;
  std::vector<GuideHole> holes;

  bool operator==(const GuideRecipe&) const noexcept = default;
};

/// Throws std::invalid_argument unless every number is finite and in its range, directions are unit
/// within 1e-3, there are enough landmarks and no two neighbours are the same point, and the grid
/// is fine enough for what it must show (thickness, slot widths, hole diameters: two spacings at
/// least). The message names the key as it stands in the file, its value and the legal range.
void ValidateGuideRecipe(const GuideRecipe& recipe);

} // namespace hasp
