#pragma once
#include <memory>

// A dynamic shell's ticks, update and evaluation, behind an interface that names no type of the
// library: DynamicTicks.cxx is compiled twice, over the library as it is, and over its sources a
// second time, plain C++ at -O2 in a namespace of their own.
namespace ticks
{

enum class Way
{
  Along,   ///< in contact, 100 mm/s along the surface
  Jumps,   ///< somewhere else each 12 ticks
  Isovalue ///< at rest, the surface 0.05 mm higher or lower in each tick
};

struct Tick
{
  double updateUs = 0.0, evaluateUs = 0.0; ///< of processor time
  double force[3] = {};
  unsigned points = 0, contacts = 0;
};

class Runner
{
public:
  virtual ~Runner() = default;
  /// The n-th tick of the way; call them in order.
  virtual Tick Run(Way way, int n) = 0;
};

/// Two bumpy balls, so many samples wide, 1 mm apart; 16,384 points' room, 512 a tick.
namespace lanes
{
std::unique_ptr<Runner> Make(int samples);
}
namespace plain
{
std::unique_ptr<Runner> Make(int samples);
}

} // namespace ticks
