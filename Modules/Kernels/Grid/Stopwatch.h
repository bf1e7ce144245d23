#pragma once
#include <chrono>

namespace hasp
{

/// Time since it was made. Any thread.
class Stopwatch
{
public:
  double Milliseconds() const
  {
    return std::chrono::duration<double, std::milli>(Clock::now() - this->Start).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point Start = Clock::now();
};

} // namespace hasp
