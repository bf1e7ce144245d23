#pragma once
#include "vtkHaspPartLabel.h"

#include <cstddef>

namespace hasp
{

/// "Hasp 0.1.0 SPACE=LPS; UNIT=mm; DOES NOT HOLD; HASH=0123456789abcdef; PART=fragment 3": what
/// headers, comments and metadata say, as SurfaceNotes reads it. Parts that the label lacks are
/// left out. In `most` bytes the hash has 16 digits, and what does not fit is left out from the
/// end; "DOES NOT HOLD" always fits in 80.
std::string PartText(const PartLabel& label);
std::string PartText(const PartLabel& label, std::size_t most);

} // namespace hasp
