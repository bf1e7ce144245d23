#pragma once
#include "FragmentModels.h"
#include "LabelBlocks.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hasp
{

/// The part of a scan that a label is in, with a sample more on each side, whose cells its surface
/// may cross. A copy: the label map may change.
struct FragmentCrop
{
  std::uint16_t label = 0;
  glm::ivec3 first{ 0 };          ///< the scan's sample that is the crop's first
  GridGeometry geometry;          ///< of the crop, in the world
  std::vector<std::uint8_t> keep; ///< 1 where the label is, one a sample of the crop
};

/// Any thread; O(samples of the box).
FragmentCrop CropLabel(
  const GridView<const std::uint16_t>& labels, std::uint16_t label, const LabelExtent& extent);

enum FragmentModelKind
{
  MapKind,
  ShellKind,
  SurfaceKind,
  FragmentModelKinds ///< how many
};

/// Models, and what each took: what several share counts with the first of them.
struct BakedFragment
{
  FragmentModel model;
  std::array<double, FragmentModelKinds> milliseconds{};
  std::size_t samples = 0; ///< of the grids
};

/// grey      the whole scan: read within the crop alone
/// settings  spacing and range are set, not 0
/// Throws std::runtime_error (no bone, too thin), std::invalid_argument (too many samples, before
/// they are taken), both beginning with the label; Cancelled. Any thread; all cores; O(samples of
/// the crop and of the grids). Memory: 3 bytes a sample of the crop (5 of floats), 25 a sample of
/// the larger grid.
BakedFragment BakeFragment(const AnyGridView& grey, double isovalue, const FragmentCrop& crop,
  const FragmentSettings& settings, const FragmentWants& wants, const glm::dvec3& origin,
  const ProgressFunction& progress);

} // namespace hasp
