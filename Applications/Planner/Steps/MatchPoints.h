#pragma once
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <vector>

namespace hasp
{

/// What stands at touched places (pins, screws), after the places have been edited by hand: who
/// stands at a place that was there before stays, who was dragged goes along, and a new place gets
/// a `fresh` one. Items have a `point`. Any thread.
template <typename Item>
std::vector<Item> MatchPoints(
  const std::vector<Item>& old, const std::vector<glm::dvec3>& points, const Item& fresh)
{
  constexpr double SameMm = 1e-9;
  std::vector<Item> items;
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    const auto same = std::find_if(old.begin(), old.end(),
      [&](const Item& item) { return glm::distance(item.point, points[n]) < SameMm; });
    items.push_back(same != old.end() ? *same : points.size() == old.size() ? old[n] : fresh);
    items.back().point = points[n];
  }
  return items;
}

template <typename Item>
std::vector<glm::dvec3> PointsOf(const std::vector<Item>& items)
{
  std::vector<glm::dvec3> points;
  for (const Item& item : items)
    points.push_back(item.point);
  return points;
}

} // namespace hasp
