#include "BoxTree.h"

#include <numeric>

namespace hasp
{

namespace
{
/// What has no end is taken to end here, so that a middle exists.
constexpr double FarMm = 1e9;

glm::dvec3 Twice(const ImplicitSolid::Box& box)
{
  return glm::clamp(box.low, -FarMm, FarMm) + glm::clamp(box.high, -FarMm, FarMm);
}
} // namespace

BoxTree::BoxTree(const std::vector<ImplicitSolid::Box>& boxes)
{
  std::vector<std::uint32_t> items(boxes.size());
  std::iota(items.begin(), items.end(), 0u);
  this->Nodes.reserve(2 * boxes.size());
  this->Build(boxes, items.data(), items.data() + items.size());
}

void BoxTree::Build(
  const std::vector<ImplicitSolid::Box>& boxes, std::uint32_t* first, std::uint32_t* last)
{
  const std::size_t at = this->Nodes.size();
  this->Nodes.push_back({ boxes[*first], 0, *first });
  if (last - first == 1)
    return;
  glm::dvec3 low = Twice(boxes[*first]), high = low;
  ImplicitSolid::Box hull = boxes[*first];
  for (const std::uint32_t* n = first; n != last; ++n)
  {
    hull.low = glm::min(hull.low, boxes[*n].low);
    hull.high = glm::max(hull.high, boxes[*n].high);
    low = glm::min(low, Twice(boxes[*n]));
    high = glm::max(high, Twice(boxes[*n]));
  }
  this->Nodes[at].box = hull;
  const glm::dvec3 size = high - low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::uint32_t* middle = first + (last - first) / 2;
  std::sort(first, last,
    [&](std::uint32_t a, std::uint32_t b)
    {
      const double x = Twice(boxes[a])[axis], y = Twice(boxes[b])[axis];
      return x < y || (x == y && a < b);
    });
  this->Build(boxes, first, middle);
  this->Nodes[at].second = static_cast<std::uint32_t>(this->Nodes.size());
  this->Build(boxes, middle, last);
}

} // namespace hasp
