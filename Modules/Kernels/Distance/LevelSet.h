#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"

#include <openvdb/openvdb.h>

#include <vector>

namespace hasp
{

/// Distances in and out of OpenVDB: narrow bands, which take memory where a surface is only. A
/// second library of this folder, Hasp::KernelLevelSet, there with HASP_ENABLE_OPENVDB; nothing
/// else knows of OpenVDB. Signed, mm, NEGATIVE INSIDE, as OpenVDB's level sets are; the grids'
/// class is GRID_LEVEL_SET. Any thread; all cores, the same result with any number of them. Who
/// writes grids to files calls openvdb::initialize() first.

/// The samples of `distances` within `bandVoxels` (of the smallest spacing) of the surface, as they
/// are; all others have the band's width, which is the background, with their sign. What reaches
/// the outermost samples is cut off flat there, as MakeGridSolid does: a level set is closed.
///
/// bandVoxels  at most 1000, and no less than a voxel's diagonal: 1.74 if voxels are cubes, more
/// the
///             longer one side is, so that all samples around a surface are in the band
/// The transform is that of the geometry. OpenVDB's own tools (its CSG, filters, meshes) ask for
/// cubic voxels. Throws std::invalid_argument if the geometry is invalid or an axis has one sample,
/// the band is out of range, or a value is NaN (infinite is far); Cancelled. O(samples); memory of
/// the band: 2.3 kB for each 8^3 voxels it touches.
openvdb::FloatGrid::Ptr LevelSetOf(const GridView<const float>& distances, double bandVoxels = 3.0,
  const ProgressFunction& progress = {});

/// A closed mesh as a level set with cubic voxels of `spacing` mm, `bandVoxels` of them to each
/// side (OpenVDB's meshToVolume: Euclidean distance to the triangles). Voxel (0,0,0) lies at 0 of
/// the world. Whatever the triangles' winding, what a flood from outside does not reach is inside:
/// shells within a solid count as solid. Throws std::invalid_argument as RequireClosedMesh (closed,
/// finite, indices), if there are no triangles, spacing is not above 0 and finite, bandVoxels is
/// not in [1.74, 1000], or the mesh is more than 2^20 voxels long or from 0; Cancelled. O(area);
/// uses all of oneTBB's threads.
openvdb::FloatGrid::Ptr LevelSetOf(const TriangleMesh& mesh, double spacing,
  double bandVoxels = 3.0, const ProgressFunction& progress = {});

/// The other way round: a level set at the samples of `geometry`, trilinear between its own; where
/// it has none, the background's value with the sign. Throws std::invalid_argument if the geometry
/// is invalid, or the level set has a transform that is not affine (a frustum). O(samples).
std::vector<float> SampleLevelSet(const openvdb::FloatGrid& levelSet, const GridGeometry& geometry);

} // namespace hasp
