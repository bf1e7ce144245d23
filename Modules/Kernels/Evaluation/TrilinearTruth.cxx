#include "Evaluation/TrilinearTruth.h"
#include "Grid/Trilinear.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hasp
{
namespace
{

using Real = long double;
using Vector = glm::vec<3, Real>;

constexpr Real Infinity = std::numeric_limits<Real>::infinity();

/// The trilinear polynomial of one cell minus the isovalue, along the ray.
struct CellAlongRay
{
  std::array<Real, 8> corners{};
  Vector origin, direction; ///< in the cell's own coordinates

  Real operator()(Real t) const
  {
    const Vector p = this->origin + t * this->direction;
    const auto lerp = [](Real a, Real b, Real s) { return (1 - s) * a + s * b; };
    const auto& c = this->corners;
    return lerp(lerp(lerp(c[0], c[1], p.x), lerp(c[2], c[3], p.x), p.y),
      lerp(lerp(c[4], c[5], p.x), lerp(c[6], c[7], p.x), p.y), p.z);
  }
};

/// Where the cubic through four values at s = 0, 1/3, 2/3, 1 turns, ascending, in [0,1]; 1 where it
/// does not.
std::array<Real, 2> TurningPoints(Real v0, Real v1, Real v2, Real v3)
{
  const Real a = 4.5L * (-v0 + 3 * v1 - 3 * v2 + v3), b = 4.5L * (2 * v0 - 5 * v1 + 4 * v2 - v3),
             c = 0.5L * (-11 * v0 + 18 * v1 - 9 * v2 + 2 * v3); // a s^3 + b s^2 + c s + v0
  const Real discriminant = b * b - 3 * a * c;
  if (!(discriminant >= 0))
    return { 1, 1 };
  const Real q = -(b + std::copysign(std::sqrt(discriminant), b));
  const auto inRange = [](Real s) { return s > 0 && s < 1 ? s : Real(1); }; // also NaN of 0 / 0
  const Real s1 = inRange(q / (3 * a)), s2 = inRange(c / q);
  return { std::min(s1, s2), std::max(s1, s2) };
}

/// The first t in (from, to] on the other side than `inside`.
std::optional<Real> FirstChange(const CellAlongRay& f, Real from, Real to, bool inside)
{
  const Real third = (to - from) / 3;
  const auto turns = TurningPoints(f(from), f(from + third), f(to - third), f(to));
  Real low = from;
  for (const Real s : { turns[0], turns[1], Real(1) })
  {
    Real high = s < 1 ? from + s * (to - from) : to;
    if ((f(high) >= 0) == inside)
    {
      low = high;
      continue;
    }
    while (true)
    {
      const Real middle = low + (high - low) / 2;
      if (!(middle > low && middle < high))
        return high;
      ((f(middle) >= 0) == inside ? low : high) = middle;
    }
  }
  return std::nullopt;
}

/// The walk through one grid.
template <typename T>
class Walk
{
public:
  Walk(const GridView<const T>& grid, Real isovalue, const Vector& origin, const Vector& direction)
    : Grid(grid),
      Isovalue(isovalue),
      Origin(origin),
      Direction(direction)
  {
  }

  /// Gives the changes of side to `meet` one after the other, until it returns false.
  template <typename Meet>
  void Go(const Meet& meet)
  {
    if (!this->Enter())
      return;
    while (this->Now <= this->End)
    {
      const int axis = this->NextAxis();
      const Real leave = std::min(this->Next[axis], this->End);
      while (const auto t = this->ChangeInCell(leave))
      {
        if (!meet(this->HitAt(*t)))
          return;
        this->Inside = !*this->Inside;
        this->Now = *t;
      }
      this->Cell[axis] += this->Direction[axis] > 0 ? 1 : -1;
      if (this->Next[axis] > this->End || this->Cell[axis] < 0 ||
          this->Cell[axis] >= this->Grid.geometry.dims[axis] - 1)
        return;
      this->Now = leave;
      this->Next[axis] = this->WallAhead(axis);
    }
  }

private:
  Real WallAhead(int a) const
  {
    if (this->Direction[a] == 0)
      return Infinity;
    const int wall = this->Cell[a] + (this->Direction[a] > 0 ? 1 : 0);
    return (wall - this->Origin[a]) / this->Direction[a]; // from the start each time: no drift
  }

  int NextAxis() const
  {
    const auto& n = this->Next;
    return n.x <= n.y && n.x <= n.z ? 0 : n.y <= n.z ? 1 : 2;
  }

  bool Enter()
  {
    this->End = Infinity;
    for (int a = 0; a < 3; ++a)
    {
      const Real size = this->Grid.geometry.dims[a] - 1;
      if (!(size >= 1) || !std::isfinite(this->Origin[a]) || !std::isfinite(this->Direction[a]))
        return false;
      if (this->Direction[a] == 0)
      {
        if (this->Origin[a] < 0 || this->Origin[a] > size)
          return false;
        continue;
      }
      const Real u = -this->Origin[a] / this->Direction[a];
      const Real v = (size - this->Origin[a]) / this->Direction[a];
      this->Now = std::max(this->Now, std::min(u, v));
      this->End = std::min(this->End, std::max(u, v));
    }
    if (!(this->Now <= this->End && this->End < Infinity))
      return false;
    for (int a = 0; a < 3; ++a)
    {
      const Real at = this->Origin[a] + this->Now * this->Direction[a];
      this->Cell[a] = std::clamp(int(std::floor(at)), 0, this->Grid.geometry.dims[a] - 2);
    }
    for (int a = 0; a < 3; ++a)
      this->Next[a] = this->WallAhead(a);
    return true;
  }

  /// Where the ray changes sides between Now and `leave`, in the current cell or on the face it
  /// entered by.
  std::optional<Real> ChangeInCell(Real leave)
  {
    CellAlongRay f;
    const auto samples = CellCorners(this->Grid, this->Cell);
    int inside = 0;
    for (int n = 0; n < 8; ++n)
    {
      if (!std::isfinite(samples[n]))
      {
        this->Inside.reset(); // no polynomial: whatever side the ray was on is forgotten
        return std::nullopt;
      }
      f.corners[n] = samples[n] - this->Isovalue;
      inside += f.corners[n] >= 0;
    }
    const bool whole = inside == 0 || inside == 8; // by convexity
    f.origin = this->Origin - Vector(this->Cell);
    f.direction = this->Direction;
    const bool here = whole ? inside == 8 : f(this->Now) >= 0;
    if (this->Inside && *this->Inside != here)
      return this->Now; // the root is on the face, to the last bit
    this->Inside = here;
    if (whole || !(leave > this->Now))
      return std::nullopt;
    return FirstChange(f, this->Now, leave, here);
  }

  TrilinearHit HitAt(Real t) const
  {
    const GridGeometry& g = this->Grid.geometry;
    const glm::dvec3 index(this->Origin + t * this->Direction);
    const glm::dvec3 local = glm::clamp(index - glm::dvec3(this->Cell), 0.0, 1.0);
    return { double(t), g.IndexToWorld(index),
      g.GradientToWorld(TrilinearGradient(CellCorners(this->Grid, this->Cell), local)),
      this->Cell };
  }

  const GridView<const T>& Grid;
  Real Isovalue;
  Vector Origin, Direction;
  glm::ivec3 Cell{ 0 };
  Vector Next{ 0 };
  Real Now = 0, End = 0;
  std::optional<bool> Inside; ///< side at the end of the last cell
};

template <typename Meet>
void GoAlong(const AnyGridView& grid, Real isovalue, const glm::dvec3& origin,
  const glm::dvec3& direction, const Meet& meet)
{
  const GridGeometry& g = GeometryOf(grid);
  const glm::mat<3, 3, Real> toAxes(glm::transpose(g.direction));
  const Vector o = toAxes * (Vector(origin) - Vector(g.origin)) / Vector(g.spacing);
  const Vector d = toAxes * Vector(direction) / Vector(g.spacing);
  std::visit([&](const auto& view) { Walk(view, isovalue, o, d).Go(meet); }, grid);
}

} // namespace

std::optional<TrilinearHit> FirstTrilinearHit(
  const AnyGridView& grid, double isovalue, const glm::dvec3& origin, const glm::dvec3& direction)
{
  std::optional<TrilinearHit> first;
  GoAlong(grid, isovalue, origin, direction,
    [&](const TrilinearHit& hit)
    {
      first = hit;
      return false;
    });
  return first;
}

std::vector<TrilinearHit> AllTrilinearHits(
  const AnyGridView& grid, double isovalue, const glm::dvec3& origin, const glm::dvec3& direction)
{
  std::vector<TrilinearHit> all;
  GoAlong(grid, isovalue, origin, direction,
    [&](const TrilinearHit& hit)
    {
      all.push_back(hit);
      return true;
    });
  return all;
}

} // namespace hasp
