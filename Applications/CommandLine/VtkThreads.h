#pragma once
#include <string>

namespace hasp
{

/// VTK's own filters run on so many threads from now on, by oneTBB where VTK has it. Says what came
/// of it: "TBB, 2 threads". RENDER thread.
std::string UseVtkThreads(int threads);

} // namespace hasp
