#pragma once
#include "Grid/GridGeometry.h"
#include "Planning/GuideRecipe.h"

#include <cstdint>
#include <string>

namespace hasp
{

/// What is known of a recipe beforehand.
enum class GuideOutcome
{
  Refused, ///< the named error
  Either   ///< a sound guide, or any error that names what is wrong
};

/// A guide as a tired or hurried planner may ask for it.
struct RandomGuide
{
  GuideRecipe recipe;
  GridGeometry scan; ///< of the phantom around it: small, turned anyhow
  const char* kind;  ///< what was done to it: "plain", "hole in air" ...
  GuideOutcome outcome = GuideOutcome::Either;
  std::string words; ///< of a refusal, the error has these
};

/// The guide of a seed on the vault of the phantom with its default settings. Kinds, one after the
/// other with the seed: plain, landmark off the bone, collinear, doubled, hole in air, crossing
/// slots, painted, all at once, nonsense. Slots, holes, flanges, labels and numbers are drawn anew
/// from every seed; the same seed gives the same recipe everywhere. Any thread.
RandomGuide RandomGuideRecipe(std::uint32_t seed);
inline constexpr std::uint32_t RandomGuideKinds = 9;

} // namespace hasp
