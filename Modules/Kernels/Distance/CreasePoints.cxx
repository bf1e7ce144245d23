#include "Distance/CreasePoints.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace hasp
{

namespace
{
using Sample = ImplicitSolid::Sample;

constexpr double RootShare = 1e-7;   ///< of a cell: a root is good
constexpr double LeastSine = 0.03;   ///< of faces that meet: below, they are one
constexpr double CornerSlack = 0.02; ///< of a tetrahedron: a corner may be so far outside
constexpr double TipDepth = 0.007;   ///< of an edge
constexpr double LeastTip = 1e-3;    ///< of an edge: how wide it is
constexpr double MostMargin = 0.3;   ///< of an edge: above, and there is no room for a tip
} // namespace

EdgeCrossing FindCrossing(const BoundedSolid& solid, const glm::dvec3& a, double valueA,
  const glm::dvec3& b, double valueB) noexcept
{
  // False position, Illinois' way: an end that stays counts half, so that both ends come.
  double low = 0.0, high = 1.0, atLow = valueA, atHigh = valueB;
  EdgeCrossing crossing;
  int stayed = 0;
  for (int n = 0; n < 40; ++n)
  {
    const double share = low + (high - low) * atLow / (atLow - atHigh);
    crossing.share = share > low && share < high ? share : 0.5 * (low + high);
    crossing.at = a + crossing.share * (b - a);
    crossing.sample = solid.SampleAt(crossing.at);
    const double value = crossing.sample.value;
    if (std::abs(value) < RootShare * solid.Cell())
      break;
    if ((value < 0.0) == (valueA < 0.0))
    {
      low = crossing.share, atLow = value;
      atHigh *= stayed == 1 ? 0.5 : 1.0;
      stayed = 1;
    }
    else
    {
      high = crossing.share, atHigh = value;
      atLow *= stayed == 2 ? 0.5 : 1.0;
      stayed = 2;
    }
  }
  return crossing;
}

namespace
{
/// The least of the cubic with these values and slopes at 0 and 1, at a few places.
double LeastOfCubic(double v0, double s0, double v1, double s1)
{
  double least = std::min(v0, v1);
  for (const double t : { 0.25, 0.5, 0.75 })
  {
    const double u = 1.0 - t;
    least = std::min(
      least, v0 * u * u * (1 + 2 * t) + s0 * u * u * t + v1 * t * t * (1 + 2 * u) - s1 * t * t * u);
  }
  return least;
}

/// A place in [from, to] of the edge that is deeper than `depth` on the other side, by halving
/// where the slope of 1 allows one, but for tips narrower than a thousandth of the edge: along a
/// face that is just so deep, it would never end.
std::optional<double> FindDeep(const BoundedSolid& solid, const glm::dvec3& a,
  const glm::dvec3& along, double side, double depth, const glm::dvec2& from,
  const glm::dvec2& to) noexcept
{
  const double length = (to.x - from.x) * glm::length(along);
  if (0.5 * (from.y + to.y - length) > -depth || to.x - from.x < LeastTip)
    return std::nullopt;
  const double middle = 0.5 * (from.x + to.x);
  const glm::dvec2 here(middle, side * solid.At(a + middle * along));
  if (here.y < -depth)
    return middle;
  const auto first = FindDeep(solid, a, along, side, depth, from, here);
  return first ? first : FindDeep(solid, a, along, side, depth, here, to);
}
} // namespace

std::optional<double> FindTip(const BoundedSolid& solid, const glm::dvec3& a, const Sample& sampleA,
  const glm::dvec3& b, const Sample& sampleB, const TipLimits& limits) noexcept
{
  const glm::dvec3 along = b - a;
  const double length = glm::length(along), depth = std::max(TipDepth * length, limits.depth);
  const double side = sampleA.value < 0.0 ? -1.0 : 1.0;
  const double va = side * sampleA.value, vb = side * sampleB.value;
  if (0.5 * (va + vb - length) > -depth || limits.margin > MostMargin)
    return std::nullopt;
  if (sampleA.face == sampleB.face && LeastOfCubic(va, side * glm::dot(sampleA.gradient, along), vb,
                                        side * glm::dot(sampleB.gradient, along)) > -depth)
    return std::nullopt;
  const auto deep = FindDeep(solid, a, along, side, depth, { 0.0, va }, { 1.0, vb });
  if (!deep)
    return std::nullopt;
  const glm::dvec3 at = a + *deep * along;
  const double value = solid.At(at);
  const double first = *deep * FindCrossing(solid, a, sampleA.value, at, value).share;
  const double last =
    *deep + (1.0 - *deep) * FindCrossing(solid, at, value, b, sampleB.value).share;
  const double middle = 0.5 * (first + last);
  const double share = std::clamp(middle, limits.margin, 1.0 - limits.margin);
  return share > first && share < last ? std::optional(share) : std::nullopt;
}

std::optional<double> FindTip(const BoundedSolid& solid, const glm::dvec3& a, const Sample& sampleA,
  const glm::dvec3& b, const Sample& sampleB, const EdgeCrossing& crossing,
  const TipLimits& limits) noexcept
{
  const double before = crossing.share, behind = 1.0 - before;
  Sample sample = crossing.sample;
  sample.value = 0.0;
  if (const auto tip =
        FindTip(solid, a, sampleA, crossing.at, sample, { limits.margin / before, limits.depth }))
    return before * *tip;
  if (const auto tip =
        FindTip(solid, b, sampleB, crossing.at, sample, { limits.margin / behind, limits.depth }))
    return 1.0 - behind * *tip;
  return std::nullopt;
}

std::optional<glm::dvec3> FindTip(const BoundedSolid& solid,
  const std::array<glm::dvec3, 3>& triangle, bool inside, const TipLimits& limits) noexcept
{
  if (limits.margin > MostMargin)
    return std::nullopt;
  const glm::dvec3 normal =
    glm::normalize(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
  const double depth = std::max(TipDepth * glm::distance(triangle[0], triangle[1]), limits.depth);
  glm::dvec3 x = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  // From face to face of the corner, each time to where that face alone is deep enough.
  for (int n = 0; n < 12; ++n)
  {
    const Sample sample = solid.SampleAt(x);
    const double value = inside ? -sample.value : sample.value;
    const glm::dvec3 share = Barycentric(triangle, x);
    if (value < -depth)
      return std::min({ share.x, share.y, share.z }) >= limits.margin ? std::optional(share)
                                                                      : std::nullopt;
    glm::dvec3 slope = inside ? -sample.gradient : sample.gradient;
    slope -= glm::dot(slope, normal) * normal;
    const double squared = glm::dot(slope, slope);
    if (!(squared > 1e-4) || std::min({ share.x, share.y, share.z }) < -0.5)
      return std::nullopt;
    x -= slope * ((value + 1.5 * depth) / squared);
  }
  return std::nullopt;
}

namespace
{
/// What a point is to meet: a face of the solid, continued, or a plane.
struct Condition
{
  bool plane;
  std::uint32_t face;
  glm::dvec3 normal, point;

  static Condition Face(std::uint32_t face) { return { false, face, {}, {} }; }
  static Condition Plane(const glm::dvec3& normal, const glm::dvec3& point)
  {
    return { true, 0, normal, point };
  }
};

/// Newton's method on three conditions. Nothing where two of them are one, or it leads far away.
std::optional<glm::dvec3> Meet(const BoundedSolid& solid,
  const std::array<Condition, 3>& conditions, const glm::dvec3& start, double reach) noexcept
{
  glm::dvec3 x = start;
  double step = reach;
  for (int n = 0; n < 8 && step > 1e-7 * reach; ++n)
  {
    double value[3];
    glm::dvec3 normal[3];
    for (int c = 0; c < 3; ++c)
    {
      const Condition& condition = conditions[c];
      if (condition.plane)
        normal[c] = condition.normal, value[c] = glm::dot(x - condition.point, condition.normal);
      else
      {
        const Sample sample = solid.FaceAt(condition.face, x);
        const double slope = glm::length(sample.gradient);
        if (!(slope > 1e-6))
          return std::nullopt;
        normal[c] = sample.gradient / slope, value[c] = sample.value / slope;
      }
    }
    const glm::dvec3 bc = glm::cross(normal[1], normal[2]), ca = glm::cross(normal[2], normal[0]),
                     ab = glm::cross(normal[0], normal[1]);
    const double determinant = glm::dot(normal[0], bc);
    if (!(std::abs(determinant) > LeastSine))
      return std::nullopt;
    const glm::dvec3 move = (value[0] * bc + value[1] * ca + value[2] * ab) / determinant;
    step = glm::length(move);
    x -= move;
    if (!(glm::distance(x, start) < reach))
      return std::nullopt;
  }
  return step < 1e-3 * reach ? std::optional(x) : std::nullopt;
}

/// The best of some places: on the surface within the tolerance, and the first of those; else the
/// one that is nearest to it.
class Best
{
public:
  Best(const BoundedSolid& solid, double tolerance) : Solid(solid), Tolerance(tolerance) {}
  bool Found() const { return this->Off <= this->Tolerance; }
  void Offer(const std::optional<glm::dvec3>& at, std::uint32_t a, std::uint32_t b)
  {
    if (!at || this->Found())
      return;
    const double off = std::abs(this->Solid.At(*at));
    if (off < this->Off)
      this->Point = BendPoint{ *at, { a, b } }, this->Off = off;
  }

  void Offer(const Best& other)
  {
    if (!this->Found() && other.Off < this->Off)
      this->Point = other.Point, this->Off = other.Off;
  }

  std::optional<BendPoint> Point;

private:
  const BoundedSolid& Solid;
  double Tolerance, Off = 1e30;
};

glm::dvec3 AnyNormal(const glm::dvec3& direction)
{
  const glm::dvec3 a = glm::abs(direction);
  const glm::dvec3 least = a.x <= a.y && a.x <= a.z ? glm::dvec3(1, 0, 0)
                           : a.y <= a.z             ? glm::dvec3(0, 1, 0)
                                                    : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(direction, least));
}
} // namespace

Bends FindBends(const BoundedSolid& solid, const glm::dvec3& planeNormal, const EdgeCrossing& p,
  const EdgeCrossing& q, double tolerance) noexcept
{
  const glm::dvec3 chord = q.at - p.at, middle = 0.5 * (p.at + q.at);
  const double length = glm::length(chord);
  if (!(length > tolerance))
    return {};
  const glm::dvec3 along = chord / length;
  const Condition plane = Condition::Plane(planeNormal, middle),
                  across = Condition::Plane(along, middle);
  const std::uint32_t a = p.sample.face, b = q.sample.face;
  // A curve that leaves its chord at these slopes is an eighth of their difference off half way.
  if (a == b &&
      std::abs(glm::dot(p.sample.gradient - q.sample.gradient, chord)) < 8.0 * tolerance * 0.5)
    return {};
  const double reach = 2.0 * length + 2.0 * solid.Cell();
  const auto meet = [&](std::uint32_t one, std::uint32_t other) {
    return Meet(solid, { Condition::Face(one), Condition::Face(other), plane }, middle, reach);
  };
  Best best(solid, tolerance);
  const auto corner = a != b ? meet(a, b) : std::nullopt;
  best.Offer(corner, a, b);
  if (!best.Found())
  {
    // What is there instead, or between.
    for (const glm::dvec3& at : { corner.value_or(middle), middle })
    {
      const std::uint32_t third = solid.SampleAt(at).face;
      if (third == a || third == b)
        continue;
      Best first(solid, tolerance), last(solid, tolerance);
      first.Offer(meet(a, third), a, third);
      last.Offer(meet(third, b), third, b);
      if (first.Found() && last.Found())
        return { 2, { *first.Point, *last.Point } };
      best.Offer(first);
      best.Offer(last);
    }
    const std::uint32_t face = solid.SampleAt(middle).face;
    best.Offer(Meet(solid, { Condition::Face(face), plane, across }, middle, reach), face, face);
  }
  if (!best.Point)
    return {};
  const glm::dvec3 off = best.Point->at - middle;
  const double beyond = std::max(std::abs(glm::dot(off, along)) - 0.5 * length, 0.0);
  const double beside = glm::length(off - glm::dot(off, along) * along);
  return std::hypot(beyond, beside) > tolerance ? Bends{ 1, { *best.Point, {} } } : Bends{};
}

glm::dvec3 Barycentric(const std::array<glm::dvec3, 3>& t, const glm::dvec3& point) noexcept
{
  const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0], w = point - t[0];
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
  const double wu = glm::dot(w, u), wv = glm::dot(w, v), determinant = uu * vv - uv * uv;
  const double a = (wu * vv - wv * uv) / determinant, b = (wv * uu - wu * uv) / determinant;
  return { 1.0 - a - b, a, b };
}

glm::dvec4 Barycentric(const std::array<glm::dvec3, 4>& t, const glm::dvec3& point) noexcept
{
  const glm::dvec3 u = t[1] - t[0], v = t[2] - t[0], w = t[3] - t[0], x = point - t[0];
  const double volume = glm::dot(u, glm::cross(v, w));
  const glm::dvec3 share = glm::dvec3(glm::dot(x, glm::cross(v, w)), glm::dot(x, glm::cross(w, u)),
                             glm::dot(x, glm::cross(u, v))) /
                           volume;
  return { 1.0 - share.x - share.y - share.z, share };
}

namespace
{
/// The faces of some places, each once: those that are one there, as of two shapes in one plane,
/// count as one.
struct FaceSet
{
  static constexpr int Most = 6;
  std::uint32_t face[Most];
  glm::dvec3 normal[Most];
  int count = 0;

  FaceSet(const BoundedSolid& solid, std::span<const FacePlace> places, double tolerance)
  {
    for (const FacePlace& place : places)
    {
      const glm::dvec3 gradient = solid.FaceAt(place.face, place.at).gradient;
      bool known = this->count == Most;
      for (int n = 0; n < this->count && !known; ++n)
        known = this->face[n] == place.face ||
                (glm::dot(this->normal[n], gradient) > 0.999 &&
                  std::abs(solid.FaceAt(this->face[n], place.at).value) < tolerance);
      if (!known)
        this->face[this->count] = place.face, this->normal[this->count++] = gradient;
    }
  }
};
} // namespace

glm::dvec3 FindCorner(const BoundedSolid& solid, const std::array<glm::dvec3, 4>& tetrahedron,
  std::span<const FacePlace> places, const glm::dvec3& start, double tolerance) noexcept
{
  const FaceSet set(solid, places, tolerance);
  const auto face = [&](int n) { return Condition::Face(set.face[n]); };
  double reach = 0.0;
  for (int n = 0; n < 4; ++n)
    reach = std::max(reach, 2.0 * glm::distance(tetrahedron[n], tetrahedron[(n + 1) % 4]));
  Best best(solid, tolerance);
  for (int i = 0; i < set.count; ++i)
    for (int j = i + 1; j < set.count; ++j)
      for (int k = j + 1; k < set.count; ++k)
      {
        const auto corner = Meet(solid, { face(i), face(j), face(k) }, start, reach);
        if (!corner)
          continue;
        const glm::dvec4 share = Barycentric(tetrahedron, *corner);
        if (std::min({ share.x, share.y, share.z, share.w }) > -CornerSlack)
          best.Offer(corner, set.face[i], set.face[j]);
      }
  for (int i = 0; i < set.count; ++i)
    for (int j = i + 1; j < set.count; ++j)
    {
      const glm::dvec3 along = glm::cross(set.normal[i], set.normal[j]);
      if (glm::length(along) > LeastSine)
        best.Offer(Meet(solid, { face(i), face(j), Condition::Plane(glm::normalize(along), start) },
                     start, reach),
          set.face[i], set.face[j]);
    }
  const Sample here = solid.SampleAt(start);
  if (glm::length(here.gradient) > 1e-6)
  {
    const glm::dvec3 across = AnyNormal(here.gradient);
    best.Offer(Meet(solid,
                 { Condition::Face(here.face), Condition::Plane(across, start),
                   Condition::Plane(glm::normalize(glm::cross(here.gradient, across)), start) },
                 start, reach),
      here.face, here.face);
  }
  return best.Point ? best.Point->at : start;
}

} // namespace hasp
