#pragma once
#include "Planning/Osteotomy.h"

#include <cstddef>
#include <vector>

namespace hasp
{

/// A blade, and how far along it bone is still the bone that it is meant for.
struct BoneCut
{
  Osteotomy blade;
  /// The blade cuts the section of bone that its middle is in, or nearest to, and what else of that
  /// fragment lies in the blade within so much of what it cuts already: the other table of a bone,
  /// the far wall of a sinus. What is farther is the far side, and stays whole. [0, 500] mm
  double reachMm = 8.0;

  bool operator==(const BoneCut&) const noexcept = default;
};

/// What an osteotomy is made from, besides the CT. World = patient LPS, mm. A plain value.
struct CutRecipe
{
  double isovalue = 226.0;       ///< bone is value >= isovalue (226 HU: InVesalius' preset)
  double spacingMm = 0.5;        ///< of the meshes' grid, [0.1, 2]; finer where a kerf needs it
  double ignoreBelowMm3 = 100.0; ///< islands of "bone" smaller than this do not count, [0, 1e6]
  double crumbBelowMm3 = 20.0; ///< pieces smaller than this are crumbs, [0, 1e6]: told, and marked
  std::vector<BoneCut> cuts;   ///< in order: each meets what those before it left; 1 to 100
  std::vector<glm::dvec3>
    resected; ///< in, or within 3 mm of, fragments that are to go; at most 100

  bool operator==(const CutRecipe&) const noexcept = default;
};

/// A kerf in this many steps of the grid is seen wherever it lies: no edge of the grid's tetrahedra
/// is longer.
inline constexpr double StepsAKerf = 1.8;

/// Of the grid that shows every kerf, mm: spacingMm, or finer.
double CutSpacing(const CutRecipe& recipe);

/// Throws std::invalid_argument unless every number is finite and in its range, each blade is one
/// that ValidateOsteotomy takes, and its kerf at least 0.2 mm: a thinner one would need a grid too
/// fine. The message names the key as it stands in the file, its value and the legal range.
void ValidateCutRecipe(const CutRecipe& recipe);

} // namespace hasp
