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
  static constexpr std::int32_t None = -1;
};

/// Elements of the surface behind a coverage image: each voxel covered by 0.03 to 0.97 gives the
/// plane that cuts off just that share of the voxel's box along the smoothed gradient. Voxels of
/// one kind that meet the other kind face to face, with nothing partial between, give the face.
///
/// coverage   dims.x*dims.y*dims.z values in [0,1], x fastest; 1 inside
/// The image must be coverage, whose edges are a voxel wide. A blurred grey image has "partial"
/// voxels far from its surface, and would be wrong by more than a voxel: it is refused, by the
/// share of partial voxels that have only partial neighbours, if above a fifth. Throws
/// std::invalid_argument if so, if sizes differ, values are not in [0,1], the geometry is invalid
/// or has 2^31 voxels or more. Any thread; all cores. About 60 bytes an element and 4 a voxel.
///
/// sides      if not empty, as many as coverage: receives -beyond in covered voxels (0.5 and more),
///            +beyond in others. It spares who fills in distances another pass.
SurfaceElements ExtractSurfaceElements(const GridGeometry& geometry,
  std::span<const float> coverage, std::span<float> sides = {}, float beyond = 0.0F);

/// Signed distance, mm, from the centre of a box to the plane with unit normal `normal` that leaves
/// the share `covered` in (0,1) of the box on its inner side; negative if the centre is inside.
/// sides   of the box, mm. Exact plane-box volume, inverted by safeguarded Newton steps to 1e-9.
double PlaneDistanceFromCoverage(const glm::dvec3& normal, const glm::dvec3& sides, double covered);

} // namespace hasp
