#pragma once
#include "Haptics/ContactPoints.h"

#include <span>

namespace hasp
{

/// A point of a shell as a picture shows it: a disc that covers the share of the surface that the
/// point stands for. 32 bytes, as GPUs read them.
struct ShellDisc
{
  glm::vec3 center{ 0.0F }; ///< mm, in the axes of the points
  float areaMm2 = 0.0F;     ///< of the disc, without any overlap with its neighbours
  glm::vec3 normal{ 0.0F }; ///< outward, unit
  std::uint32_t level = 0;  ///< of a static shell; 0 in a dynamic one
};
static_assert(sizeof(ShellDisc) == 32);

/// Copies the points that are there, in order, until `out` is full, and says how many: those that
/// only fill a vector up, and a ring's dead ones, are left out. O(points); takes no memory: HAPTIC
/// may call it.
std::uint32_t CopyDiscs(
  const ContactPoints& points, std::uint32_t level, std::span<ShellDisc> out) noexcept;

} // namespace hasp
