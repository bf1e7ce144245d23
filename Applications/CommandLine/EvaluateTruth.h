#pragma once
#include "Grid/RigidPose.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hasp
{

/// Where a fragment of a broken scan belongs.
struct TrueFragment
{
  std::uint32_t label = 0; ///< of the case's label map
  std::string name;
  RigidPose scanToPlanned; ///< the right reduction
};

/// The fragments of a truth.json (Formats.md, fracture-case/1). Throws Failure: BadInput.
std::vector<TrueFragment> ReadTruth(const std::string& path);

} // namespace hasp
