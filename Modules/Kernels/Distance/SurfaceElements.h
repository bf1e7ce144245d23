#pragma once
#include "Grid/GridGeometry.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace hasp
{

/// A small plane of the surface that passes through a partially covered voxel.
struct SurfaceElement
{
  glm::dvec3 point;  ///< mm along the grid's own axes, sample (0,0,0) at 0
  glm::dvec3 normal; ///< outward unit normal along the grid's own axes; 0 if the gradient vanishes
};

/// All elements of a coverage image and where to find them.
struct SurfaceElements
{
  std::vector<SurfaceElement> elements;
  std::vector<std::uint32_t> at; ///< per voxel: its element, or None
  static constexpr std::uint32_t None = 0xffffffffU;
};

/// Elements of the surface behind a coverage image: each voxel covered by 0.03 to 0.97 gives the
/// plane that cuts off just that share of the voxel's box along the smoothed gradient. Voxels of
/// one kind that meet the other kind face to face, with nothing partial between, give the face.
///
/// coverage   dims.x*dims.y*dims.z values in [0,1], x fastest; 1 inside
/// The image must be coverage, whose edges are a voxel wide. A blurred grey image has "partial"
/// voxels far from its surface, and would be wrong by more than a voxel: it is refused, by the
/// share of partial voxels that have only partial neighbours, if above a fifth. Throws
/// std::invalid_argument if so, if sizes differ or the geometry is invalid. Any thread; all cores.
SurfaceElements ExtractSurfaceElements(
  const GridGeometry& geometry, std::span<const float> coverage);

/// Signed distance, mm, from the centre of a box to the plane with unit normal `normal` that leaves
/// the share `covered` in (0,1) of the box on its inner side; negative if the centre is inside.
/// sides   of the box, mm. Exact plane-box volume, inverted by safeguarded Newton steps to 1e-9.
double PlaneDistanceFromCoverage(const glm::dvec3& normal, const glm::dvec3& sides, double covered);

} // namespace hasp
