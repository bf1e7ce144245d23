#include "EyeCulling.h"

#include <algorithm>
#include <array>

const hasp::VisibleClusters& EyeCulling::Visible(
  const View& view, const glm::dmat4& otherIndexToClip, const Cull& cull)
{
  const auto find = [&](const View& wanted)
  {
    return std::find_if(this->Lists.begin(), this->Lists.end(),
      [&](const Known& known) { return known.view == wanted; });
  };
  if (const auto known = find(view); known != this->Lists.end())
  {
    known->age = 0;
    return known->visible;
  }
  View other = view;
  other.indexToClip = otherIndexToClip;
  const bool both = find(other) == this->Lists.end(); // identical eyes have one list
  const std::array<glm::dmat4, 2> matrices{ view.indexToClip, otherIndexToClip };
  std::vector<hasp::VisibleClusters> visible =
    cull(std::span(matrices).first(both && !(other == view) ? 2 : 1));
  ++this->PassCount;
  if (visible.size() > 1)
    this->Lists.push_back({ other, std::move(visible[1]), 0 });
  return this->Lists.emplace_back(Known{ view, std::move(visible[0]), 0 }).visible;
}

void EyeCulling::BeginFrame()
{
  constexpr int most = 2; // one of the other eye, and the one that begins
  this->Lists.remove_if([](Known& known) { return ++known.age > most; });
}

std::size_t EyeCulling::Bytes() const
{
  std::size_t bytes = 0;
  for (const Known& known : this->Lists)
    bytes +=
      (known.visible.points.size() + known.visible.rectangles.size()) * sizeof(std::uint32_t);
  return bytes;
}
