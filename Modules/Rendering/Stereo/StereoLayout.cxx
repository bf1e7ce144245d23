#include "StereoLayout.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace hasp
{
namespace
{

constexpr std::array<std::pair<StereoLayout, const char*>, 6> Names{ {
  { StereoLayout::Mono, "mono" },
  { StereoLayout::SideBySide, "side-by-side" },
  { StereoLayout::TopBottom, "top-bottom" },
  { StereoLayout::Left, "left" },
  { StereoLayout::Right, "right" },
  { StereoLayout::Anaglyph, "anaglyph" },
} };

/// Rec. 601 luma in integers; the weights sum to 256, so white stays 255.
std::uint8_t Luminance(const std::uint8_t* rgb)
{
  return static_cast<std::uint8_t>((77 * rgb[0] + 150 * rgb[1] + 29 * rgb[2] + 128) >> 8);
}

} // namespace

const char* StereoLayoutName(StereoLayout layout)
{
  return std::find_if(Names.begin(), Names.end(), [&](auto& n) { return n.first == layout; })
    ->second;
}

StereoLayout StereoLayoutFromName(const std::string& name)
{
  std::string known;
  for (const auto& [layout, layoutName] : Names)
  {
    if (name == layoutName)
      return layout;
    known += (known.empty() ? "" : ", ") + std::string(layoutName);
  }
  throw std::invalid_argument("stereo layout '" + name + "' is not known; known are " + known);
}

bool NeedsSecondEye(StereoLayout layout)
{
  return layout == StereoLayout::SideBySide || layout == StereoLayout::TopBottom ||
         layout == StereoLayout::Anaglyph;
}

glm::ivec2 ComposedSize(StereoLayout layout, glm::ivec2 eyeSize)
{
  return { eyeSize.x * (layout == StereoLayout::SideBySide ? 2 : 1),
    eyeSize.y * (layout == StereoLayout::TopBottom ? 2 : 1) };
}

std::vector<std::uint8_t> ComposeStereo(StereoLayout layout, glm::ivec2 eyeSize,
  std::span<const std::uint8_t> left, std::span<const std::uint8_t> right)
{
  if (!NeedsSecondEye(layout))
    throw std::invalid_argument(std::string("stereo layout '") + StereoLayoutName(layout) +
                                "' has one eye: nothing to compose");
  if (eyeSize.x < 1 || eyeSize.y < 1)
    throw std::invalid_argument("stereo: an eye's picture is " + std::to_string(eyeSize.x) + " x " +
                                std::to_string(eyeSize.y) + " pixels, must be at least 1 x 1");
  const std::size_t row = 3 * static_cast<std::size_t>(eyeSize.x);
  const std::size_t bytes = row * static_cast<std::size_t>(eyeSize.y);
  if (left.size() != bytes || right.size() != bytes)
    throw std::invalid_argument("stereo: pictures of " + std::to_string(left.size()) + " and " +
                                std::to_string(right.size()) + " bytes, must both have " +
                                std::to_string(bytes));
  std::vector<std::uint8_t> result;
  if (layout == StereoLayout::TopBottom) // rows run from the bottom, so the right eye comes first
  {
    result.assign(right.begin(), right.end());
    result.insert(result.end(), left.begin(), left.end());
  }
  else if (layout == StereoLayout::SideBySide)
  {
    result.reserve(2 * bytes);
    for (std::size_t start = 0; start < bytes; start += row)
      for (const auto& eye : { left, right })
        result.insert(result.end(), eye.begin() + start, eye.begin() + start + row);
  }
  else
  {
    result.assign(right.begin(), right.end());
    for (std::size_t p = 0; p < bytes; p += 3)
      result[p] = Luminance(&left[p]);
  }
  return result;
}

} // namespace hasp
