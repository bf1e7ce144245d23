#pragma once
#include <functional>

namespace hasp
{

/// Runs `work` on the caller, whose ParallelFor then uses `threads` threads, also beyond the
/// machine's cores; 0: one for each core, as without this. Without oneTBB it is always one. What
/// `work` throws reaches the caller. Throws std::invalid_argument unless threads is in [0, 1024].
void WithThreadLimit(int threads, const std::function<void()>& work);

} // namespace hasp
