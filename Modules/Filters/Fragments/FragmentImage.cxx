#include "FragmentImage.h"

#include "LabelBlocks.h"
#include "SawnFaces.h"

#include "Grid/LabelGrid.h"
#include "Grid/ParallelFor.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <type_traits>

namespace hasp
{

namespace
{
constexpr int ImageMargin = 2; ///< samples: gradients at the surface read no others

constexpr double MostIsovalue = 1e6; ///< a plan's

/// Holds all samples of a scan of T, and what they are mirrored to.
template <typename T>
using ImageSample =
  std::conditional_t<std::is_same_v<T, std::int16_t> || std::is_same_v<T, std::uint8_t>,
    std::int16_t, float>;

template <typename T>
FragmentImage CropFragment(const GridView<const T>& grey,
  const GridView<const std::uint16_t>& labels, const FragmentLevel& level,
  const LabelExtent& extent)
{
  using Sample = ImageSample<T>;
  const glm::ivec3 first = glm::max(extent.low - ImageMargin, 0);
  const glm::ivec3 last = glm::min(extent.high + ImageMargin, grey.geometry.dims - 1);
  FragmentImage image{ grey.geometry, {} };
  image.geometry.dims = last - first + 1;
  image.geometry.origin = grey.geometry.IndexToWorld(glm::dvec3(first));
  const glm::ivec3 dims = image.geometry.dims;
  std::vector<Sample>& samples = image.samples.emplace<std::vector<Sample>>(image.geometry.Size());
  const GreySide<Sample> side(level.isovalue);
  ParallelFor(0, std::int64_t(dims.y) * dims.z, 64,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        const std::size_t from =
          grey.Offset(first.x, first.y + int(row % dims.y), first.z + int(row / dims.y));
        Sample* to = &samples[std::size_t(row) * dims.x];
        for (int i = 0; i < dims.x; ++i)
        {
          const auto value = Sample(grey.data[from + i]);
          to[i] = labels.data[from + i] == level.label ? value : side.Mirrored(value);
        }
      }
    });
  for (const SawnBox& box : level.sawn)
    FlattenFaces(GridView<Sample>{ samples.data(), image.geometry }, grey, labels,
      { first, level.label, level.isovalue, box });
  return image;
}

void CheckLevel(const FragmentLevel& level)
{
  if (level.label == 0)
    throw std::invalid_argument("fragment images: label 0 is nothing, and has no image");
  if (std::abs(level.isovalue) <= MostIsovalue)
    return;
  std::ostringstream text;
  text << "fragment images: the isovalue of label " << level.label << " is " << level.isovalue
       << ", must be in [-1e6, 1e6]";
  throw std::invalid_argument(text.str());
}
} // namespace

std::vector<FragmentImage> FragmentImages(const AnyGridView& grey,
  const GridView<const std::uint16_t>& labels, std::span<const FragmentLevel> levels,
  const ProgressFunction& progress)
{
  GeometryOf(grey).Validate();
  CheckLabelGrid("fragment images", GeometryOf(grey), labels.geometry);
  for (const FragmentLevel& level : levels)
    CheckLevel(level);
  ReportProgress(progress, 0.0);
  const LabelBlocks blocks(labels);
  std::vector<FragmentImage> images(levels.size());
  for (std::size_t n = 0; n < levels.size(); ++n)
  {
    ReportProgress(progress, 0.5 + 0.5 * double(n) / double(levels.size()));
    const auto found = blocks.Extents().find(levels[n].label);
    if (found == blocks.Extents().end())
      images[n].geometry.dims = glm::ivec3(0);
    else
      images[n] = std::visit([&](const auto& view)
        { return CropFragment(view, labels, levels[n], found->second); },
        grey);
  }
  return images;
}

} // namespace hasp
