#pragma once
#include "Grid/GridView.h"
#include "Grid/Phantom.h"
#include "PartLine.h"
#include "Planning/ImplantRecipe.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hasp
{

/// What is wrong with a recipe of an implant.
enum class ImplantNonsense
{
  None,
  OffBone,       ///< a point of the outline in the air, or in the brain
  Collinear,     ///< its points
  Doubled,       ///< a point twice
  TwiceAround,   ///< the hole
  Crossing,      ///< two points exchanged
  NoHole,        ///< whole bone within the outline
  HalfRound,     ///< the hole
  CrowdedHoles,  ///< as near to each other as recipes allow: can be made
  NoRoom,        ///< for any hole
  MirrorAside,   ///< beside the head's middle, by 10 mm to 200
  AxisAlong,     ///< the bone, or into the head
  ThickClearance ///< a hole too narrow for what is left
};
inline constexpr int ImplantNonsenses = 13; ///< with None

const char* ImplantNonsenseName(ImplantNonsense nonsense);

/// A phantom's skull with its hole, as a scanner sees it.
struct ImplantSkull
{
  PhantomSettings settings;
  GridGeometry scan;
  std::vector<std::int16_t> grey;

  AnyGridView View() const { return GridView<const std::int16_t>{ this->grey.data(), this->scan }; }
};
/// Four that differ in size, voxels, place, turn and noise. About a second each.
inline constexpr std::uint32_t ImplantSkulls = 4;
ImplantSkull MakeImplantSkull(std::uint32_t skull);

/// A recipe drawn by a seed, for skull `seed % ImplantSkulls`.
struct RandomImplant
{
  ImplantNonsense nonsense = ImplantNonsense::None;
  ImplantRecipe recipe;
  std::string says; ///< words of the error it must get; empty: it must be made
};
/// Every other one is sound, the others take the nonsenses in turn. O(1).
RandomImplant RandomImplantRecipe(std::uint32_t seed, const ImplantSkull& skull);

/// The implant before it is made, for JudgePart.
TriedPart TriedImplant(const RandomImplant& implant);

} // namespace hasp
