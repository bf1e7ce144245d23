#pragma once
#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace hasp
{

struct FlipSettings
{
  /// Of the viewer's sight, in [1, 1000]. Default: 3840 pixels on 0.7 m, seen from 0.7 m.
  double pixelsPerDegree = 67.02064327658226;
};

/// How visible the difference of two pictures is to somebody who flips between them: FLIP
/// (Andersson et al. 2020), the variant for pictures of low dynamic range. 0 where nothing is to be
/// seen, 1 at most.
///
/// reference, test   sRGB in [0,1], row by row, `width` pixels each; which row is first is all one.
/// Returns           the same shape.
///
/// Colours are blurred as the eye's contrast sensitivity does it, and compared in a space where
/// hues are even; a difference of edges or points between the pictures makes more of it.
/// Throws std::invalid_argument if the pictures differ in size, are empty, are not whole rows or
/// leave [0,1] (NaN does), or settings are out of range. Any thread; uses all cores inside. About
/// 0.3 us a pixel and core.
std::vector<float> Flip(std::span<const glm::vec3> reference, std::span<const glm::vec3> test,
  int width, const FlipSettings& settings = {});

} // namespace hasp
