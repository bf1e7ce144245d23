#pragma once
#include <functional>

namespace hasp
{

/// Runs two works that share nothing they write, and returns when both are done: `here` on the
/// calling thread, so that it may report progress (Progress.h), `beside` on the pool meanwhile, or
/// on the calling thread where no other is free or there is no oneTBB. Both may use ParallelFor.
///
/// An exception of either reaches the caller when both have ended; of two that of `here`.
void SideBySide(const std::function<void()>& beside, const std::function<void()>& here);

} // namespace hasp
