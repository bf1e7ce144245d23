#pragma once
#include "Haptics/BlockKernels.h"

namespace hasp
{

/// Those of all instruction sets that this processor has and this library was compiled for.
std::vector<BlockKernels> LanesBlockKernels();

} // namespace hasp
