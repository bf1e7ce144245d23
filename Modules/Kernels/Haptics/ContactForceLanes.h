// Private to ContactForce: the kernels of vectors.
#pragma once
#include "Haptics/ContactForce.h"

namespace hasp
{

/// Of each instruction set that this processor has, the least capable first.
std::vector<ContactKernels> LanesContactKernels();

} // namespace hasp
