#pragma once
#include <chrono>
#include <thread>

namespace hasp::test
{

/// Whether `holds` becomes true in time. In the guest nothing is there at once, kernel threads
/// bring it; and how long they take, on an emulated processor of a machine that is busy, is
/// anybody's guess: so long that only what hangs does not.
template <typename Holds>
bool Becomes(Holds&& holds, std::chrono::seconds inTime = std::chrono::seconds(60))
{
  const auto end = std::chrono::steady_clock::now() + inTime;
  while (!holds())
  {
    if (std::chrono::steady_clock::now() > end)
      return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

} // namespace hasp::test
