#pragma once
#include <cstdint>
#include <string>

namespace hasp
{

struct Session;

/// A phantom with fractures: `hasp phantom --broken`.
struct BrokenPhantomChoices
{
  std::string which; ///< "head", "mandible"; empty: none is asked for
  double spacingMm = 0.8;
  bool moved = false, coneBeam = false;
  std::uint64_t seed = 1;
  std::string output, truth; ///< truth: .seg.nrrd, or empty
};

/// Writes the scan, and which fragment each voxel is of. Throws what its parts do.
void WriteBrokenPhantom(const BrokenPhantomChoices& choices, Session& session);

} // namespace hasp
