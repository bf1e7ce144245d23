#pragma once
#include "Grid/GridView.h"
#include "Grid/TriangleMesh.h"
#include "Planning/ImplantRecipe.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace hasp
{

/// How implants of random recipes did (RandomImplants.h).
struct ImplantTrial
{
  std::size_t recipes = 0;
  std::size_t made = 0;    ///< closed, 2-manifold, outward, one piece, not meeting themselves
  std::size_t refused = 0; ///< by the error that names what is wrong
  std::vector<std::string> wrong; ///< what went otherwise, with its seed
};

/// Makes an implant of a volume, or throws what is wrong.
using MakeImplantFunction = std::function<TriangleMesh(const AnyGridView&, const ImplantRecipe&)>;

/// Makes `count` of them, seeds `firstSeed`, `firstSeed + step` and so on; they are
/// judged AsWritten. Self-intersections are looked for where CGAL is there.
ImplantTrial TryImplants(
  std::uint32_t firstSeed, std::size_t count, std::uint32_t step, const MakeImplantFunction& make);

} // namespace hasp
