#include "StereoLayout.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace hasp
{
namespace
{

constexpr std::array<std::pair<StereoLayout, const char*>, 10> Names{ {
  { StereoLayout::Mono, "mono" },
  { StereoLayout::SideBySide, "side-by-side" },
  { StereoLayout::TopBottom, "top-bottom" },
  { StereoLayout::Left, "left" },
  { StereoLayout::Right, "right" },
  { StereoLayout::Anaglyph, "anaglyph" },
  { StereoLayout::Interlaced, "interlaced" },
  { StereoLayout::Checkerboard, "checkerboard" },
  { StereoLayout::DualWindow, "dual-window" },
  { StereoLayout::QuadBuffer, "quad-buffer" },
} };

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
  return layout != StereoLayout::Mono && layout != StereoLayout::Left &&
         layout != StereoLayout::Right;
}

bool IsOnePicture(StereoLayout layout)
{
  return layout != StereoLayout::DualWindow && layout != StereoLayout::QuadBuffer;
}

} // namespace hasp
