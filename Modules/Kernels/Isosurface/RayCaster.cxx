#include "Isosurface/RayCaster.h"
#include "Grid/Trilinear.h"
#include "Isosurface/RayRoot.h"

#include <cmath>
#include <stdexcept>

namespace hasp
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double BorderSlack = 1e-9; // voxels: what a turn into index coordinates may round off

/// Walks the boxes of one size that a ray passes, in order. Boxes are [0, count) of `side` units
/// each.
class BoxWalk
{
public:
  BoxWalk(const glm::dvec3& origin, const glm::dvec3& direction, double t, double side,
    const glm::ivec3& first, const glm::ivec3& last)
    : First(first),
      Last(last),
      Enter(t)
  {
    for (int a = 0; a < 3; ++a)
    {
      const double at = (origin[a] + t * direction[a]) / side;
      this->Box[a] = std::clamp(static_cast<int>(std::floor(at)), first[a], last[a]);
      this->Step[a] = direction[a] > 0 ? 1 : direction[a] < 0 ? -1 : 0;
      const int wall = this->Box[a] + (direction[a] > 0);
      this->Next[a] = this->Step[a] ? (wall * side - origin[a]) / direction[a] : Infinity;
      this->Delta[a] = this->Step[a] ? side / std::abs(direction[a]) : Infinity;
    }
  }

  const glm::ivec3& Current() const { return this->Box; }
  double EnterT() const { return this->Enter; }
  /// The axis whose wall the ray leaves the current box through.
  int ExitAxis() const
  {
    return this->Next.x < this->Next.y ? (this->Next.x < this->Next.z ? 0 : 2)
                                       : (this->Next.y < this->Next.z ? 1 : 2);
  }
  double ExitT() const { return std::max(this->Enter, this->Next[this->ExitAxis()]); }
  int StepOf(int axis) const { return this->Step[axis]; }

  /// False when the ray leaves the range.
  bool Advance()
  {
    const int axis = this->ExitAxis();
    this->Enter = this->ExitT();
    this->Next[axis] += this->Delta[axis];
    this->Box[axis] += this->Step[axis];
    return this->Step[axis] != 0 && this->Box[axis] >= this->First[axis] &&
           this->Box[axis] <= this->Last[axis];
  }

private:
  glm::ivec3 First, Last, Box{ 0 }, Step{ 0 };
  glm::dvec3 Next{ 0 }, Delta{ 0 };
  double Enter;
};

/// The part of [t0, t1] inside the box [0, size]; empty if t0 > t1 afterwards.
void ClipToBox(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& size,
  double& t0, double& t1)
{
  for (int a = 0; a < 3; ++a)
  {
    if (direction[a] == 0.0)
    {
      if (origin[a] < -BorderSlack || origin[a] > size[a] + BorderSlack)
        t1 = -Infinity;
      continue;
    }
    const double u = -origin[a] / direction[a], v = (size[a] - origin[a]) / direction[a];
    t0 = std::max(t0, std::min(u, v));
    t1 = std::min(t1, std::max(u, v));
  }
}

/// Cells of one block, from t0 to t1. Entry points are carried from cell to cell with the crossed
/// axis snapped to the wall, so that both sides of a face see the same value there: no ray slips
/// through.
template <typename T>
std::optional<RayCellHit> WalkCells(const GridView<const T>& grid, float isovalue,
  const glm::dvec3& origin, const glm::dvec3& direction, double t0, double t1,
  const glm::ivec3& firstCell, const glm::ivec3& lastCell)
{
  BoxWalk walk(origin, direction, t0, 1.0, firstCell, lastCell);
  glm::dvec3 entry = origin + t0 * direction - glm::dvec3(walk.Current());
  entry = glm::clamp(entry, 0.0, 1.0);
  while (true)
  {
    const glm::ivec3 cell = walk.Current();
    const double exitT = std::min(walk.ExitT(), t1);
    const int axis = walk.ExitAxis();
    glm::dvec3 exit = glm::clamp(origin + exitT * direction - glm::dvec3(cell), 0.0, 1.0);
    if (exitT < t1)
      exit[axis] = walk.StepOf(axis) > 0 ? 1.0 : 0.0;

    const auto c = CellCorners(grid, cell);
    glm::vec4 low, high;
    for (int n = 0; n < 4; ++n)
    {
      low[n] = static_cast<float>(c[n]) - isovalue;
      high[n] = static_cast<float>(c[n + 4]) - isovalue;
    }
    float s;
    const glm::vec4 b = glsl::HaspRayBernstein(low, high, glm::vec3(entry), glm::vec3(exit));
    if (glsl::HaspFirstRoot(b, s)) // never if a corner is not finite
      return RayCellHit{ walk.EnterT() + s * (exitT - walk.EnterT()), cell,
        glm::mix(entry, exit, double(s)) };

    if (exitT >= t1 || !walk.Advance())
      return std::nullopt;
    entry = exit;
    entry[axis] = 1.0 - exit[axis];
  }
}

} // namespace

RayCaster::RayCaster(const AnyGridView& grid, const MinMaxBlocks& blocks, double isovalue)
  : Grid(grid),
    Blocks(&blocks),
    Isovalue(static_cast<float>(isovalue))
{
  if (blocks.Blocks() != (GeometryOf(grid).Cells() + MinMaxBlocks::Side - 1) / MinMaxBlocks::Side)
    throw std::invalid_argument("RayCaster: the min-max blocks are of another grid");
}

std::optional<RayCellHit> RayCaster::CastInIndex(
  const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax) const
{
  const GridGeometry& g = GeometryOf(this->Grid);
  double t0 = tMin, t1 = tMax;
  ClipToBox(origin, direction, glm::dvec3(g.dims - 1), t0, t1);
  // Written so that NaN stops here too; t1 is infinite only if the direction is 0.
  if (!(t0 <= t1) || !std::isfinite(t0) || !std::isfinite(t1) || this->Blocks->Count() == 0)
    return std::nullopt;

  constexpr int side = MinMaxBlocks::Side;
  BoxWalk walk(origin, direction, t0, side, glm::ivec3(0), this->Blocks->Blocks() - 1);
  do
  {
    const glm::ivec3 block = walk.Current();
    const double exitT = std::min(walk.ExitT(), t1);
    if (this->Blocks->Active(block, this->Isovalue))
    {
      const glm::ivec3 first = block * side, last = glm::min(first + side, g.dims - 1) - 1;
      const auto hit = std::visit(
        [&](const auto& view) {
          return WalkCells(
            view, this->Isovalue, origin, direction, walk.EnterT(), exitT, first, last);
        },
        this->Grid);
      if (hit)
        return hit;
    }
    if (exitT >= t1)
      return std::nullopt;
  } while (walk.Advance());
  return std::nullopt;
}

std::optional<RayHit> RayCaster::Cast(
  const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax) const
{
  const GridGeometry& g = GeometryOf(this->Grid);
  const glm::dvec3 from = g.WorldToIndex(origin);
  const auto hit = this->CastInIndex(from, g.WorldToIndex(origin + direction) - from, tMin, tMax);
  if (!hit)
    return std::nullopt;
  const auto corners =
    std::visit([&](const auto& view) { return CellCorners(view, hit->cell); }, this->Grid);
  return RayHit{ hit->t, g.IndexToWorld(glm::dvec3(hit->cell) + hit->local),
    g.GradientToWorld(TrilinearGradient(corners, hit->local)), hit->cell };
}

} // namespace hasp
