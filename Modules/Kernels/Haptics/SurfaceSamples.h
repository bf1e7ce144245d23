#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Haptics/PointShell.h"

#include <vector>

namespace hasp
{

/// Points on the zero surface of a distance, negative inside, evenly per area and in the order of
/// the cells they lie in; and the surface's area.
struct SurfaceSamples
{
  std::vector<SurfacePoint> points; ///< world, mm, relative to the origin given
  double area = 0.0;                ///< mm^2
};

/// `count` points, or some fewer: a point is left out where the surface is not to be found within a
/// tenth of a voxel (a field full of noise). Cells with a sample that is not finite hold no
/// surface.
///
/// The area is that of the surface of a division into tetrahedra: for a sphere of r voxels it is
/// off by about 0.3 / r^2 of it. The points lie on the trilinear surface, their normals are its
/// gradient. Any thread; all cores; the same with any number of them. Throws Cancelled. O(samples +
/// count).
SurfaceSamples SampleSurface(const GridView<const float>& distances, const glm::dvec3& origin,
  std::size_t count, std::uint32_t seed, const ProgressFunction& progress);

} // namespace hasp
