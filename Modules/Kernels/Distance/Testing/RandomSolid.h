#pragma once
#include "Distance/Csg.h"
#include "Distance/SolidShapes.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace hasp
{

/// Trees of shapes within some 5 mm of the origin, `depth` nodes deep, of a seed. Half of the
/// shapes lie on a lattice of 0.5 mm along the axes, so that faces coincide and shapes touch.
class RandomSolids
{
public:
  explicit RandomSolids(unsigned seed) : Random(seed) {}

  SolidPointer Tree(int depth)
  {
    if (depth == 0)
      return this->Shape();
    const int node = this->Pick(7);
    if (node == 0)
      return MakeUnion(
        { this->Tree(depth - 1), this->Tree(depth - 1), this->Tree(this->Pick(depth)) });
    if (node == 6)
    {
      const SolidPointer a = this->Shape(), b = this->Shape();
      return MakeSmoothUnion(a, b, 0.25 * (1 + this->Pick(4)));
    }
    const SolidPointer part = this->Tree(depth - 1);
    if (node == 4)
      return MakeOffset(part, 0.25 * (this->Pick(5) - 2));
    if (node == 5)
    {
      const double from = -0.25 * this->Pick(3);
      return MakeShell(part, from, 0.25 * (1 + this->Pick(2)));
    }
    const SolidPointer other = this->Tree(depth - 1);
    return node == 1 ? MakeIntersection({ part, other }) : MakeDifference(part, other);
  }

  SolidPointer Shape()
  {
    const bool onLattice = this->Pick(2) == 0;
    const glm::dvec3 at = this->Place(onLattice, 3.0), half = glm::abs(this->Place(onLattice, 1.5));
    const glm::dvec3 size = half + 0.5, axis = this->Axis(onLattice);
    switch (this->Pick(7))
    {
      case 0:
        return MakePlane(at, axis);
      case 1:
        return MakeSlab(at, axis, size.x);
      case 2:
        return MakeRoundedBox(at, this->Frame(axis), size, 0.25);
      case 3:
        return MakeCylinder(at - size.x * axis, at + size.x * axis, size.y);
      case 4:
        return MakeCapsule(at, at + half.x * axis, size.y);
      default:
        return MakeBox(at, this->Frame(axis), size);
    }
  }

private:
  int Pick(int of) { return int(this->Random() % unsigned(of)); }
  double Any(double spread)
  {
    return spread * (2.0 * double(this->Random()) / double(std::mt19937::max()) - 1.0);
  }
  glm::dvec3 Place(bool onLattice, double spread)
  {
    const double x = this->Any(spread), y = this->Any(spread), z = this->Any(spread);
    const glm::dvec3 at(x, y, z);
    return onLattice ? 0.5 * glm::round(2.0 * at) : at;
  }
  glm::dvec3 Axis(bool onLattice)
  {
    if (!onLattice)
      return glm::normalize(this->Place(false, 1.0) + glm::dvec3(0, 0, 1e-3));
    glm::dvec3 axis(0.0);
    axis[this->Pick(3)] = this->Pick(2) == 0 ? 1.0 : -1.0;
    return axis;
  }
  static glm::dmat3 Frame(const glm::dvec3& x)
  {
    const glm::dvec3 other = std::abs(x.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 y = glm::normalize(glm::cross(x, other));
    return { x, y, glm::cross(x, y) };
  }

  std::mt19937 Random; // not the standard's distributions, which differ between libraries
};

inline SolidPointer RandomSolid(unsigned seed, int depth)
{
  return RandomSolids(seed).Tree(depth);
}

} // namespace hasp
