#pragma once
#include "SeededPart.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hasp
{

/// How a certificate did on parts of which it is known what is wrong with them.
struct CertificateTrial
{
  std::size_t parts = 0;
  std::size_t found = 0; ///< of parts with a defect: red for that very reason
  std::size_t red = 0;   ///< for any reason; of clean parts: false alarms
  std::size_t triangles = 0;
  double milliseconds = 0.0;      ///< of certifying, all parts
  std::vector<std::string> wrong; ///< what was missed, or which clean part was flagged and why
};

/// Certifies `count` parts with this defect (None: clean ones), from this seed on.
/// Self-intersections need CGAL; without it all parts are red. All cores.
CertificateTrial TryCertificate(SeededDefect defect, std::uint32_t firstSeed, std::size_t count);

} // namespace hasp
