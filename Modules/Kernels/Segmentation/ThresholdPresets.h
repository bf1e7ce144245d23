#pragma once
#include <span>

namespace hasp
{

/// A range of grey values that stands for a tissue: lowest <= value <= highest.
struct ThresholdPreset
{
  const char* name; ///< lower case, English
  double lowest, highest;
};

/// Ranges that are in use for CT of adults and children, in Hounsfield units (InVesalius has the
/// same). They overlap. They say nothing of scans whose values are no HU, as those of cone beam
/// scanners: ProposeThreshold (ThresholdProposal.h) is for these. Any thread.
std::span<const ThresholdPreset> ThresholdPresets();

} // namespace hasp
