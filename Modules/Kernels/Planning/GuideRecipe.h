#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace hasp
{

/// What printers add to a wall, mm: resin (SLA) and filament (FDM). See GuideRecipe::clearanceMm.
inline constexpr double SlaClearanceMm = 0.25, FdmClearanceMm = 0.4;

/// Of a saw plane's normal with the withdrawal direction: the saw must come in along that.
inline constexpr double MostSawCosine = 0.9;

/// A saw slot: a finite blade cut through the guide, and the box that leads the saw. Both are
/// upright in the saw plane (SawAxes); upwards the blade has no end, so that the saw comes in.
struct GuideSlot
{
  glm::dvec3 point{ 0.0 }; ///< middle of the slot, on the bone, world mm
  glm::dvec3 normal{ 1.0, 0.0,
    0.0 };                ///< of the saw plane; unit, not along the withdrawal direction
  double kerfMm = 1.0;    ///< the saw's; the slot is SlotWidthMm wide, (0, 20]
  double lengthMm = 20.0; ///< across, in the saw plane, (0, 500]
  double depthMm = 20.0;  ///< below the point nothing deeper is cut: the far side stays, (0, 500]
  double guidingHeightMm = 15.0; ///< of the box above the point; 0: no box, [0, 100]

  bool operator==(const GuideSlot&) const noexcept = default;
};

/// A wall to lay the saw along: the box of a slot without its other half, and nothing before it.
struct GuideFlange
{
  glm::dvec3 point{ 0.0 };            ///< on the bone, in the middle of the cut, world mm
  glm::dvec3 normal{ 1.0, 0.0, 0.0 }; ///< of the saw plane, from the wall to the saw; as of a slot
  double kerfMm = 1.0;    ///< the wall is half of it and the clearance behind the plane, (0, 20]
  double lengthMm = 20.0; ///< across, in the saw plane, (0, 500]
  double heightMm = 15.0; ///< of the wall above the point, (0, 100]
  double depthMm = 20.0;  ///< below the point nothing deeper is freed, (0, 500]
  double freeMm = 10.0;   ///< before the plane there is no guide for so long, (0, 100]

  bool operator==(const GuideFlange&) const noexcept = default;
};

/// A pin or drill hole, and the sleeve around it. Upwards it has no end.
struct GuideHole
{
  glm::dvec3 point{ 0.0 };          ///< on the axis; for a sleeve on the bone, world mm
  glm::dvec3 axis{ 0.0, 0.0, 1.0 }; ///< unit; up is the end that points along the withdrawal
  double diameterMm = 3.0;          ///< as printed, (0, 20]
  double depthMm = 20.0;            ///< below the point nothing deeper is drilled, (0, 500]
  double sleeveHeightMm = 6.0;      ///< above the point; 0: no sleeve, [0, 100]

  bool operator==(const GuideHole&) const noexcept = default;
};

enum class GuideLabelKind
{
  Text, ///< as it stands in the recipe
  Case  ///< case, side and plan, said when the part is made: WithCaseLabels. A plan's hash would
        ///< change if a recipe in the plan had it
};

/// A line of text on the outer wall, read from outside.
struct GuideLabel
{
  std::string text;        ///< A to Z, 0 to 9, space and . - / + : up to 40; of the kind Case empty
  glm::dvec3 point{ 0.0 }; ///< below its middle, on the bone, world mm
  glm::dvec3 right{ 1.0, 0.0, 0.0 }; ///< direction of writing; unit, along the wall
  double heightMm = 5.0;             ///< of letters; their strokes are a sixth of it, [3.6, 50]
  double depthMm = 1.0;              ///< letters stand out so far, or are cut in, (0, 5]
  bool engraved = false;             ///< cut in: at most half the thickness
  GuideLabelKind kind = GuideLabelKind::Text;

  bool operator==(const GuideLabel&) const noexcept = default;
};

/// What a round brush painted on the bone, or wiped off again: all through the shell, as wide as
/// the brush as seen along the withdrawal direction.
struct GuideStroke
{
  std::vector<glm::dvec3> points; ///< of its middle, one or more, world mm
  double radiusMm = 5.0;          ///< (0, 100]
  bool erased = false;

  bool operator==(const GuideStroke&) const noexcept = default;
};

enum class GuideOutline
{
  Open,   ///< a band along the landmarks
  Closed, ///< a ring: the last landmark joins the first
  Filled  ///< all bone inside the ring too, seen along the withdrawal direction
};

/// Everything a guide is made from, besides the CT. World = patient LPS, mm. A plain value.
/// Defaults are those of SlicerBoneReconstructionPlanner, where it has them.
struct GuideRecipe
{
  std::string note;                  ///< free text, kept
  double isovalue = 226.0;           ///< bone is value >= isovalue (226 HU: InVesalius' preset)
  std::vector<glm::dvec3> landmarks; ///< on the bone, in order; two or more, three for a ring; none
                                     ///< if the outline is Open and an area is painted
  GuideOutline outline = GuideOutline::Open;
  std::vector<GuideStroke> strokes; ///< one after the other, added to the outline or taken from it
  glm::dvec3 withdrawal{ 0.0, 0.0, 1.0 }; ///< unit; the guide lifts off along it
  double axisSearchDeg = 0.0; ///< take the direction of least undercut this near to withdrawal
                              ///< instead, [0, 60]; 0: withdrawal as it is
  double gapMm = 0.3;         ///< bone to inner wall, [0, 10]; 0.2 to 0.5 is usual
  double thicknessMm = 4.0;   ///< inner to outer wall, (0, 50]
  double widthMm = 14.0;      ///< of the band around the landmarks, (0, 200]
  double edgeRadiusMm = 0.5;  ///< outer edges are rounded from so far before them, [0, 5], at most
                              ///< half the thickness and half of walls; 0: sharp
  double clearanceMm = SlaClearanceMm; ///< slots are wider by this on either side, [0, 2]
  double wallMm = 3.0;                 ///< of the boxes of slots, and of flanges, (0, 20]
  double sleeveWallMm = 2.0;           ///< of sleeves, (0, 20]
  double spacingMm = 0.4;              ///< of the working grid, [0.05, 2]
  double ignoreBelowMm3 = 100.0; ///< pieces of "bone" smaller than this do not count, [0, 1e6]
  std::vector<GuideSlot> slots;
  std::vector<GuideFlange> flanges;
  std::vector<GuideHole> holes;
  std::vector<GuideLabel> labels;

  bool operator==(const GuideRecipe&) const noexcept = default;
};

/// Throws std::invalid_argument unless every number is finite and in its range, directions are unit
/// within 1e-3, there are enough landmarks or strokes and no two neighbouring landmarks are the
/// same point, and the grid is fine enough for what it must show (thickness, walls, slot widths,
/// hole diameters, strokes of letters: two spacings at least). The message names the key as it
/// stands in the file, its value and the legal range, and never a text. At most 1,000 landmarks,
/// strokes and points of one stroke, and 100 of what else is listed.
void ValidateGuideRecipe(const GuideRecipe& recipe);

/// What is printed: the kerf and the clearance on both sides, mm.
inline double SlotWidthMm(const GuideRecipe& recipe, double kerfMm)
{
  return kerfMm + 2.0 * recipe.clearanceMm;
}

/// Of a saw plane: its normal, the direction of lengthMm, and up, which is the withdrawal direction
/// as seen in the plane; unit columns, right-handed. Of a recipe that is valid.
glm::dmat3 SawAxes(const glm::dvec3& normal, const glm::dvec3& withdrawal);

enum class BodySide
{
  None,
  Left,
  Right
};

/// Which case, which side, which state of the plan: "CASE 7 L 3FA41B2C", in letters that can be
/// written; others become "-". Of the hash, as hexadecimal digits, the first eight; of the case
/// what there is room for.
std::string GuideLabelText(
  const std::string& caseLabel, BodySide side, const std::string& planHash);

/// There is a label of the kind Case.
bool HasCaseLabel(const GuideRecipe& recipe);

/// The recipe to make a part from: its labels of the kind Case have become that text. Throws
/// std::invalid_argument, naming the label, if there is one and nothing is known for it to say.
GuideRecipe WithCaseLabels(
  GuideRecipe recipe, const std::string& caseLabel, BodySide side, const std::string& planHash);

} // namespace hasp
