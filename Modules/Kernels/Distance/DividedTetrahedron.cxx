#include "Distance/DividedTetrahedron.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hasp
{

namespace
{
constexpr double Most = std::numeric_limits<double>::max();

/// Calls part(a, b, c, whether it is on the side of the lone corner) for each part of a triangle.
template <class Part>
void ForEachPart(const CrossedTriangle& t, const Part& part)
{
  const glm::dvec3 &first = t.crossing[0], &last = t.crossing[1];
  const auto quad =
    [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
  {
    if (t.diagonal)
      part(a, b, c, false), part(a, c, d, false);
    else
      part(a, b, d, false), part(b, c, d, false);
  };
  if (t.bends == 0)
  {
    part(t.lone, first, last, true);
    quad(first, t.ends[0], t.ends[1], last);
    return;
  }
  const glm::dvec3 &from = t.bend[0], &to = t.bend[t.bends - 1];
  part(t.lone, first, from, true);
  part(t.lone, to, last, true);
  part(first, t.ends[0], from, false);
  part(to, t.ends[1], last, false);
  if (t.bends == 1)
    return part(from, t.ends[0], t.ends[1], false);
  part(t.lone, from, to, true);
  quad(from, t.ends[0], t.ends[1], to);
}

double LeastPart(const CrossedTriangle& t) noexcept
{
  const glm::dvec3 normal = glm::normalize(glm::cross(t.ends[0] - t.lone, t.ends[1] - t.lone));
  double least = Most;
  ForEachPart(t,
    [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, bool)
    {
      const double longest =
        std::max({ glm::distance(a, b), glm::distance(b, c), glm::distance(c, a) });
      least = std::min(least, glm::dot(glm::cross(b - a, c - a), normal) / longest);
    });
  return least;
}
} // namespace

void Divide(const CrossedTriangle& t, bool turned, Shell& shell)
{
  ForEachPart(t,
    [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, bool lone) {
      shell.push_back({ { a, turned ? c : b, turned ? b : c }, lone == t.inside });
    });
}

double ChooseDiagonal(CrossedTriangle& t) noexcept
{
  t.diagonal = true;
  const double other = LeastPart(t);
  t.diagonal = false;
  const double one = LeastPart(t);
  t.diagonal = other > one;
  return std::max(one, other);
}

double LeastHeight(const glm::dvec3& center, std::span<const ShellTriangle> shell) noexcept
{
  double least = Most;
  for (const ShellTriangle& triangle : shell)
  {
    const glm::dvec3 a = triangle.at[0] - center, b = triangle.at[1] - center,
                     c = triangle.at[2] - center;
    const glm::dvec3 ab = glm::cross(a, b), bc = glm::cross(b, c), ca = glm::cross(c, a);
    const glm::dvec3 out = ab + bc + ca;
    const double largest =
      std::max({ glm::dot(ab, ab), glm::dot(bc, bc), glm::dot(ca, ca), glm::dot(out, out) });
    least = std::min(least, glm::dot(a, bc) / std::sqrt(largest));
  }
  return least;
}

double LeastHeight(
  std::span<const ShellTriangle> shell, std::span<const std::array<glm::dvec3, 3>> surface)
{
  double least = Most;
  Shell part;
  for (const bool inside : { false, true })
  {
    part.clear();
    for (const ShellTriangle& triangle : shell)
      if (triangle.inside == inside)
        part.push_back(triangle);
    for (const auto& t : surface)
      part.push_back({ { t[0], inside ? t[1] : t[2], inside ? t[2] : t[1] }, inside });
    glm::dvec3 center(0.0);
    for (const ShellTriangle& triangle : part)
      center += (triangle.at[0] + triangle.at[1] + triangle.at[2]) / (3.0 * double(part.size()));
    least = std::min(least, LeastHeight(center, part));
  }
  return least;
}

} // namespace hasp
