#pragma once
#include "Grid/Phantom.h"
#include "Grid/TriangleMesh.h"
#include "PartLine.h"
#include "Planning/PlateRecipe.h"

#include <cstdint>
#include <string>

namespace hasp
{

/// What is known of a recipe beforehand.
enum class PlateOutcome
{
  Sound,   ///< a plate comes of it
  Refused, ///< the named error
  Either   ///< a sound plate, or any error that begins as plates' do
};

/// A plate as a tired or hurried planner may ask for it.
struct RandomPlate
{
  PlateRecipe recipe;
  const char* kind; ///< what was done to it: "plain", "hole in air" ...
  PlateOutcome outcome;
  std::string words; ///< of a refusal, the error has these: the object that is wrong, and how
};

/// The plate of a seed on the phantom with these settings, anatomy Head: for vtkHaspPlateFilter, or
/// BuildPlate, with a scan of it (SamplePhantom, spacing up to 2 mm) and without labels. Eleven
/// kinds, one after the other with the seed:
///  plain, along the jaw, landmark off the bone, straight through the air or bone, doubled, hole in
///  air, clashing screws, screw at the edge, nonsense, anywhere, there and back.
/// Each is drawn anew from every seed; the same seed gives the same recipe everywhere. Any thread.
RandomPlate RandomPlateRecipe(std::uint32_t seed, const PhantomSettings& head = {});
inline constexpr std::uint32_t RandomPlateKinds = 11;

/// A scan that holds them all: the default head, voxels of 1.5 mm.
GridGeometry RandomPlateScan();

/// The plate before it is made, for JudgePart.
TriedPart TriedPlate(const RandomPlate& plate);

/// What is wrong with what came of it; empty: nothing.
///
/// error   what the builder threw or the filter reported; empty if nothing
/// mesh    the plate, as read back from its file and welded; empty after an error
/// As JudgePart says. Any thread.
std::string WrongWithPlate(
  const RandomPlate& plate, const std::string& error, const TriangleMesh& mesh);

} // namespace hasp
