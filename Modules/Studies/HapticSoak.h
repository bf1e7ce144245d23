#pragma once
#include "Grid/Progress.h"

#include <cstdint>

namespace hasp
{

/// What came of very many ticks in which everything that can change does, and much that must not
/// happen happens.
struct SoakFigures
{
  std::uint64_t ticks = 0, badPoses = 0, badContacts = 0, touched = 0, changes = 0;
  std::uint64_t notFinite = 0; ///< wrenches, or tools: to be 0
  std::uint64_t overLimit = 0; ///< wrenches beyond the limiter's limits: to be 0
  std::uint64_t overSlew = 0;  ///< that grew faster than its slew: to be 0
  double largestForceN = 0.0, limitN = 0.0;
  double cpuS = 0.0;
};

/// Coupling, friction, passivity controller and limiter before bodies in closed form that change
/// every two seconds, as do stiffness (0 to 10 kN/mm), spring and limits; a device that walks,
/// jumps, spins and is lost now and then; distances that are no numbers. 600,000 ticks are 10
/// minutes at 1 kHz, 86.4 million a day. Deterministic by seed. WORKER; about 1 us a tick. Throws
/// Cancelled.
SoakFigures RunSoak(
  std::uint64_t ticks, std::uint32_t seed = 1, const ProgressFunction& progress = {});

/// The same through HapticStep, the whole of a tick: shells of one and two bodies before baked maps
/// (ground, ball, thin plate; even, skewed and turned; two at once; none), scenes swapped in
/// contact every two seconds, stiffness to 10 N/mm per mm^2, attraction that comes and goes, levels
/// limited and let go, the tool placed anew now and then, friction and the passivity controller on.
/// badContacts stays 0: maps hold numbers. With the kernels that are the fastest here; otherwise as
/// RunSoak. WORKER; about 6 us a tick.
SoakFigures RunStepSoak(
  std::uint64_t ticks, std::uint32_t seed = 1, const ProgressFunction& progress = {});

} // namespace hasp
