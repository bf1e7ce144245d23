#include "RandomTree.h"

#include "Distance/Csg.h"
#include "Distance/NearSurface.h"
#include "Distance/SolidShapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace hasp
{
namespace
{

using Kind = SolidNode::Kind;

class Trees
{
public:
  Trees(std::uint32_t seed, const RandomTreeSettings& settings) : Random(seed), Settings(settings)
  {
  }
  SolidNode Any()
  {
    SolidNode tree = this->Tree(this->Settings.depth);
    return this->Pick(4) == 0
             ? SolidNode{ Kind::Difference, {}, {}, {}, 0.0, { std::move(tree), this->Slot() } }
             : tree;
  }

private:
  int Pick(int of) { return static_cast<int>(this->Random() % static_cast<unsigned>(of)); }
  double Spread(double spread)
  {
    return spread *
           (2.0 * static_cast<double>(this->Random()) / static_cast<double>(std::mt19937::max()) -
             1.0);
  }
  glm::dvec3 Place(bool onLattice, double spread)
  {
    const double x = this->Spread(spread), y = this->Spread(spread), z = this->Spread(spread);
    const glm::dvec3 place(x, y, z);
    const double step = this->Settings.latticeMm;
    return onLattice ? step * glm::round(place / step) : place;
  }
  glm::dvec3 Axis(bool onLattice)
  {
    if (!onLattice)
      return glm::normalize(this->Place(false, 1.0) + glm::dvec3(0.0, 0.0, 1e-3));
    glm::dvec3 axis(0.0);
    axis[this->Pick(3)] = this->Pick(2) == 0 ? 1.0 : -1.0;
    return axis;
  }
  SolidNode Shape()
  {
    constexpr Kind all[] = { Kind::Box, Kind::Box, Kind::Cylinder, Kind::Capsule, Kind::Plane,
      Kind::Slab, Kind::RoundedBox };
    const bool onLattice = this->Pick(2) == 0;
    SolidNode shape;
    shape.kind = all[this->Pick(this->Settings.meshes ? 4 : 7)];
    shape.at = this->Place(onLattice, 3.0);
    shape.size = this->Settings.latticeMm + glm::abs(this->Place(onLattice, 1.5));
    shape.axis = this->Axis(onLattice);
    shape.mm = shape.kind == Kind::RoundedBox ? 0.5 * this->Settings.latticeMm : shape.size.y;
    return shape;
  }
  /// Through everything, its sides on planes of the lattice.
  SolidNode Slot()
  {
    const int axis = this->Pick(3);
    const double half = 0.5 * this->Settings.latticeMm * (1 + this->Pick(2));
    SolidNode slot;
    slot.axis = glm::dvec3(0.0);
    slot.axis[axis] = 1.0;
    slot.size = { half, 12.0, 12.0 };
    slot.at = this->Place(true, 2.0);
    slot.at[axis] += half;
    slot.at[(axis + 1) % 3] += 12.0; // ends in the solid
    return slot;
  }
  SolidNode Tree(int depth)
  {
    if (depth == 0)
      return this->Shape();
    SolidNode node;
    switch (this->Pick(this->Settings.meshes ? 4 : 7))
    {
      case 0:
        node.kind = Kind::Union;
        node.parts = { this->Tree(depth - 1), this->Tree(depth - 1),
          this->Tree(this->Pick(depth)) };
        return node;
      case 1:
        node.kind = Kind::Intersection;
        break;
      case 4:
        node.kind = Kind::Offset;
        node.mm = 0.5 * this->Settings.latticeMm * (this->Pick(5) - 2);
        node.parts = { this->Tree(depth - 1) };
        return node;
      case 5:
        node.kind = Kind::Shell;
        node.mm = 0.5 * this->Settings.latticeMm * (1 + this->Pick(2));
        node.parts = { this->Tree(depth - 1) };
        return node;
      case 6:
        node.kind = Kind::SmoothUnion;
        node.mm = 0.5 * this->Settings.latticeMm * (1 + this->Pick(4));
        node.parts = { this->Shape(), this->Shape() };
        return node;
      default:
        node.kind = Kind::Difference;
    }
    node.parts = { this->Tree(depth - 1), this->Tree(depth - 1) };
    return node;
  }

  std::mt19937 Random; // not the standard's distributions, which differ between libraries
  RandomTreeSettings Settings;
};

} // namespace

glm::dmat3 FrameOf(const glm::dvec3& axis)
{
  const glm::dvec3 other = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 y = glm::normalize(glm::cross(axis, other));
  return { axis, y, glm::cross(axis, y) };
}

SolidNode RandomTree(std::uint32_t seed, const RandomTreeSettings& settings)
{
  if (settings.depth < 0 || settings.depth > 8 || !(settings.latticeMm > 0.0))
    throw std::invalid_argument("random tree: depth must be in [0, 8], the lattice above 0");
  return Trees(seed, settings).Any();
}

SolidPointer SolidOf(const SolidNode& node)
{
  std::vector<SolidPointer> parts;
  for (const SolidNode& part : node.parts)
    parts.push_back(SolidOf(part));
  const glm::dvec3 half = node.size.x * node.axis;
  switch (node.kind)
  {
    case Kind::Plane:
      return MakePlane(node.at, node.axis);
    case Kind::Slab:
      return MakeSlab(node.at, node.axis, node.size.x);
    case Kind::Box:
      return MakeBox(node.at, FrameOf(node.axis), node.size);
    case Kind::RoundedBox:
      return MakeRoundedBox(node.at, FrameOf(node.axis), node.size, node.mm);
    case Kind::Cylinder:
      return MakeCylinder(node.at - half, node.at + half, node.mm);
    case Kind::Capsule:
      return MakeCapsule(node.at - half, node.at + half, node.mm);
    case Kind::Union:
      return MakeUnion(std::move(parts));
    case Kind::Intersection:
      return MakeIntersection(std::move(parts));
    case Kind::Difference:
      return MakeDifference(parts[0], parts[1]);
    case Kind::SmoothUnion:
      return MakeSmoothUnion(parts[0], parts[1], node.mm);
    case Kind::Offset:
      return MakeOffset(parts[0], node.mm);
    case Kind::Shell:
      return MakeShell(parts[0], -node.mm, node.mm);
  }
  throw std::invalid_argument("solid: a node of no kind");
}

double VolumeOf(const ImplicitSolid& solid, double halfMm, double cellMm)
{
  const int n = static_cast<int>(std::ceil(2.0 * halfMm / cellMm));
  const GridGeometry grid{ glm::ivec3(n), glm::dvec3(-0.5 * (n - 1) * cellMm), glm::dvec3(cellMm),
    glm::dmat3(1.0) };
  const NearSurface field = EvaluateNearSurface(solid, grid, 2.0 * cellMm);
  double cells = 0.0;
  for (const float value : DenseValues(field))
    cells += std::clamp(0.5 - value / cellMm, 0.0, 1.0);
  return cells * cellMm * cellMm * cellMm;
}

} // namespace hasp
