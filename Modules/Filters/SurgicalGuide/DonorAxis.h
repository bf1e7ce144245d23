#pragma once
#include "FragmentCutter.h"

#include <vector>

namespace hasp
{

/// The middle line of a long bone from tip to tip: both tips, and between them the middle of the
/// bone's samples in slices 10 mm thick, square on the line between the tips.
///
/// The bone is the island nearest to the middle between the tips. Samples farther than three radii
/// from the straight line are another bone's. A canal without bone does no harm as long as it is in
/// the middle.
/// tips       of one bone, mm
/// radiusMm   of it, > 0; the island must be that near, and its bow on top of that
/// Throws std::invalid_argument: no bone there; a slice without bone ("45 mm along donor.axis");
/// tips less than 30 mm apart. Any thread; O(samples).
std::vector<glm::dvec3> FindDonorAxis(const BoneImage& donor, double isovalue,
  double ignoreBelowMm3, const glm::dvec3& firstTip, const glm::dvec3& lastTip, double radiusMm,
  const ProgressFunction& progress = {});

} // namespace hasp
