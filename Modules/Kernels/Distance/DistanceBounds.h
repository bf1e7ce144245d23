#pragma once
#include "Grid/GridGeometry.h"

#include <span>
#include <vector>

namespace hasp
{

/// Takes out of signed distances what no distance can be. In walls as thin as a voxel elements of
/// one side are taken for those of the other, and distances come out as much as two voxels too
/// large; whoever interpolates between them meets slopes that no distance has. Where a surface
/// folds, the element of the nearest voxel may be that of the farther slope, since its surface
/// passes anywhere in the voxel: distances come out up to a third of a voxel too large, and shells
/// as much too thin. `distance`: mm, changed in place; nobody's is larger than before. Any thread;
/// all cores, the same result with any number of them.

/// No farther than where a grid line crosses the surface, and on the side of the value. For
/// surfaces of the trilinear interpolant alone, since those crossings are on it. `values`: inside
/// is >= 0.5. O(voxels).
void BoundByCrossings(
  const GridGeometry& geometry, std::span<const float> values, std::vector<float>& distance);

/// Voxels from `near` to `far` of the surface, mm, that fall towards it 1.03 times as steeply as
/// distances do, in any direction, come no farther than any voxel on their side that is within
/// `near`, and on from there in a straight line; then those around them that are too steep now.
/// What neighbours tell of a slope is rough where a surface is round: it says only where to look,
/// and no distance that is right can move. Two spacings near the surface hold enough voxels to come
/// within 0.05 of a spacing. True if any moved. O(voxels), and `far`^3 voxels for each that is too
/// steep.
bool BoundByNearVoxels(
  const GridGeometry& geometry, float near, float far, std::vector<float>& distance);

/// Neighbours along an axis differ by at most 1.01 times their spacing afterwards: what is larger
/// gives way, or both where the surface is between them. Distances below `least`, mm, stay as they
/// are, and others do not fall below it. O(voxels), and a few bytes for each voxel that is wrong.
void BoundByNeighbours(const GridGeometry& geometry, float least, std::vector<float>& distance);

} // namespace hasp
