#pragma once
#include "Grid/GridGeometry.h"
#include "Grid/Progress.h"
#include "Grid/TriangleMesh.h"

#include <vector>

namespace hasp
{

/// Share in [0,1] of each voxel of `target` that lies inside a closed triangle mesh: the partner of
/// Coverage.h for surfaces.
///
/// mesh           closed: triangles pass each edge as often one way as the other. Points need not
///                be shared between triangles, only equal. What is wound the other way round counts
///                as inside, too; so does what is inside twice.
/// target         any geometry; a voxel is the box of one spacing a side around its sample
/// linesPerAxis   lines along x through a voxel's sides in y and in z, each in [1, 16]; along them
///                the share is exact
/// Throws std::invalid_argument if the mesh is not closed or its triangles are wound against each
/// other (says where, mm), a point is not finite, a triangle names a point that is not there, or
/// another argument is out of its range; Cancelled. Any thread; all cores; the same with any number
/// of them. O(voxels + crossings of triangles and lines + edges log edges); 24 bytes a crossing of
/// the slices at work.
std::vector<float> MeshCoverage(const TriangleMesh& mesh, const GridGeometry& target,
  int linesPerAxis = 4, const ProgressFunction& progress = {});

} // namespace hasp
