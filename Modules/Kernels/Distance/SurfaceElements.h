#pragma once
#include "Grid/GridGeometry.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hasp
{

/// Small planes of a surface, one in each voxel that it passes through, and where to find them.
/// Lengths are in units of the smallest spacing, along the grid's own axes.
struct SurfaceElements
{
  /// What is known of one plane; `curvature` only after Refine (ElementLanes.h).
  struct Element
  {
    float point[3];  ///< from the centre of its voxel
    float curvature; ///< mean, positive where the solid is convex
    float normal[3]; ///< outward, unit; 0 if the gradient vanishes
    float weight;    ///< how well the plane is known: less where it cuts off a corner only
  };
  struct Place
  {
    std::int32_t x, y, z;
    std::int32_t voxel; ///< (z * dims.y + y) * dims.x + x
  };

  glm::ivec3 dims{ 0 };
  glm::vec3 sides{ 1.0F }; ///< of a voxel; the smallest is 1
  double unit = 1.0;       ///< mm: the smallest spacing
  std::vector<Element> elements;
  std::vector<Place> places;       ///< of elements, raster order
  std::vector<std::int32_t> at;    ///< per voxel: its element, or None
  std::vector<std::uint32_t> bits; ///< per voxel a bit, rows padded: has it one?
  std::size_t wordsPerRow = 0;     ///< of bits
  float section = 0.0F; ///< times curvature and squared sides: how much too deep planes lie
  static constexpr std::int32_t None = -1;
};

/// What tells coverage, whose edges are a voxel wide, from a grey image, where they are wider.
struct EdgeFacts
{
  std::size_t partial = 0; ///< voxels of 0.03 to 0.97
  std::size_t blurred = 0; ///< of these, on a slope that goes on over partial voxels to both sides
  std::size_t stray = 0;   ///< of these, all of 3^3 voxels below 0.25, or above 0.75: noise

  /// Measured: coverage of anything thicker than half a voxel has at most 0.03 blurred voxels of
  /// all partial ones, and no stray ones. A scan's edges of 0.5 voxel (sigma) have 0.085, of 0.8
  /// voxel 0.14 (spongy bone) to 0.24; coverage with noise of 3 % has 0.35 stray ones and more.
  bool Coverage() const
  {
    return double(this->blurred) <= 0.06 * double(this->partial) &&
           double(this->stray) <= 0.2 * double(this->partial);
  }
};
/// Of values in [0,1]. Throws as ExtractSurfaceElements, but for what it finds.
EdgeFacts MeasureEdges(const GridGeometry& geometry, std::span<const float> values);

/// Elements of the surface behind a coverage image: each voxel covered by 0.03 to 0.97 gives the
/// plane that cuts off just that share of the voxel's box, along the gradient at first, then turned
/// to where the planes around lie. Voxels of one kind that meet the other kind face to face, with
/// nothing partial between, give the face.
///
/// coverage   dims.x*dims.y*dims.z values in [0,1], x fastest; 1 inside
/// The image must be coverage. A blurred grey image has "partial" voxels far from its surface, and
/// would be wrong by a voxel: it is refused if MeasureEdges says so. Throws std::invalid_argument
/// if so, if sizes differ, values are not in [0,1], the geometry is invalid or has 2^31 voxels or
/// more. Any thread; all cores. About 80 bytes an element and 4 a voxel.
///
/// sides      if not empty, as many as coverage: receives -beyond in covered voxels (0.5 and more),
///            +beyond in others. It spares who fills in distances another pass.
SurfaceElements ExtractSurfaceElements(const GridGeometry& geometry,
  std::span<const float> coverage, std::span<float> sides = {}, float beyond = 0.0F);

/// Elements of the trilinear surface between values below 0.5 and others, of any size: each voxel
/// whose box holds a crossing of the surface with a grid line gives the plane at the foot of its
/// centre. For grey images; coverage saturates, and its trilinear surface is up to 0.09 voxel off.
/// Otherwise as above; NaN is refused.
SurfaceElements ExtractIsosurfaceElements(const GridGeometry& geometry,
  std::span<const float> values, std::span<float> sides = {}, float beyond = 0.0F);

/// Signed distance, mm, from the centre of a box to the plane with unit normal `normal` that leaves
/// the share `covered` in (0,1) of the box on its inner side; negative if the centre is inside.
/// sides   of the box, mm. Exact plane-box volume, inverted by safeguarded Newton steps to 1e-9.
double PlaneDistanceFromCoverage(const glm::dvec3& normal, const glm::dvec3& sides, double covered);

} // namespace hasp
