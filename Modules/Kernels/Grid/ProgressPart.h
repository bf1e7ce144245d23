#pragma once
#include "Grid/Progress.h"

namespace hasp
{

/// Part [from, to] of the whole. Good for longer than `progress` itself.
inline ProgressFunction PartOf(const ProgressFunction& progress, double from, double to)
{
  if (!progress)
    return {};
  return [progress, from, to](double share) { return progress(from + share * (to - from)); };
}

} // namespace hasp
