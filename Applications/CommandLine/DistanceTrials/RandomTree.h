#pragma once
#include "Distance/ImplicitSolid.h"

#include <glm/mat3x3.hpp>

#include <cstdint>
#include <vector>

namespace hasp
{

/// A tree of shapes as plain values: a solid can be made of it, and meshes of its leaves.
struct SolidNode
{
  enum class Kind
  {
    Plane,      ///< outwards along `axis`
    Slab,       ///< mm wide
    Box,        ///< size: half its sides
    RoundedBox, ///< mm: of its edges
    Cylinder,   ///< size.x: half its length, mm: radius
    Capsule,    ///< the same
    Union,
    Intersection,
    Difference, ///< parts: body, tool
    SmoothUnion,
    Offset,
    Shell ///< from -mm to mm
  };
  Kind kind = Kind::Box;
  glm::dvec3 at{ 0.0 }, axis{ 1.0, 0.0, 0.0 }, size{ 1.0 };
  double mm = 0.0;
  std::vector<SolidNode> parts;
};

/// Two directions upright on it and on each other, with it the first column.
glm::dmat3 FrameOf(const glm::dvec3& axis);

struct RandomTreeSettings
{
  int depth = 2; ///< nodes above the leaves, in [0, 8]
  double latticeMm =
    0.5;               ///< half of the shapes lie on it, along the axes: they share planes, touch
  bool meshes = false; ///< boxes, cylinders and capsules in unions, intersections and differences
                       ///< alone: what meshes can follow
};

/// Within some 5 mm of the origin; the same for a seed on any machine. A quarter of the trees ends
/// with a slot along planes of the lattice, one or two steps wide.
SolidNode RandomTree(std::uint32_t seed, const RandomTreeSettings& settings);

SolidPointer SolidOf(const SolidNode& node);

/// Of the solid within the cube of that half side around the origin, mm^3: cells count by the depth
/// of their middles. It shares nothing with contours.
double VolumeOf(const ImplicitSolid& solid, double halfMm, double cellMm);

} // namespace hasp
