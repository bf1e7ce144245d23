#pragma once
#include "Grid/Progress.h"
#include "Reduction/BakeFitBody.h"
#include "Reduction/FitTerms.h"

#include <cstdint>
#include <vector>

namespace hasp
{

struct BrokenPotSettings
{
  int sherds = 12;        ///< [2, 60]
  double wallMm = 6.0;    ///< [2, 20]
  double roughMm = 0.5;   ///< height of the faces, root mean square, [0, 3]
  double erodedMm = 0.0;  ///< the most that each face lost, from place to place, [0, 2]
  double spacingMm = 0.6; ///< of the grids that sherds are sampled on, [0.2, 2]
  std::uint64_t seed = 1; ///< of where it broke
};

/// A pot of 110 mm width and 110 mm height, all of one wall around a profile, broken into sherds:
/// cells around places spread over it, with rough faces between neighbours. In closed form, so that
/// nothing was scanned; both sides of a face are one surface. World: the pot stands on z = 0.
struct BrokenPot
{
  std::vector<PlacedBody> sherds; ///< where they belong
  std::vector<double> areaMm2;    ///< of their surfaces
};

/// Throws std::invalid_argument with value and range; std::runtime_error for a sherd of nothing;
/// Cancelled. All cores, the same with any number of them; about 0.5 s a sherd.
BrokenPot MakeBrokenPot(
  const BrokenPotSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp
