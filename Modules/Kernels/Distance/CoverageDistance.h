#pragma once
#include "Grid/GridGeometry.h"
#include "Grid/Progress.h"

#include <span>
#include <vector>

namespace hasp
{

/// Anti-aliased signed Euclidean distance to a partially covered mask (after Gustavson and Strand
/// 2011; the thesis' guides use the weighted <3,4,5> transform with the same purpose, Eq. 2.2).
///
/// coverage   dims.x*dims.y*dims.z values in [0,1], x fastest; 1 inside; see Coverage.h
/// Returns mm, NEGATIVE INSIDE, same shape. +infinity everywhere if nothing is covered, -infinity
/// if all is. Method: surface elements (SurfaceElements.h); the exact feature transform brings each
/// voxel the nearest; within four voxels the distance is to the surface that the elements around
/// the foot point span together (implicit moving least squares), farther out to the nearest
/// element's disc. Error on smooth surfaces: about 0.01 voxel rms within three voxels, against 0.24
/// of a binary transform, and where voxels of length h lie along a surface of radius R, h^2 / (8
/// R). Sharp edges are not kept: within three voxels of the edges of boxes, turned nine ways and of
/// exact coverage, 0.25 voxels rms and 1.65 at most (TestCoverageDistance prints and holds it). The
/// most is outside: elements of the faces reach over an edge, and a voxel up to one spacing outside
/// of it is told to be as much as 0.65 inside. Inside 0.87 at most; five voxels from the edges
/// 0.01. Throws as ExtractSurfaceElements; Cancelled. Any thread; all cores; O(voxels), 21 bytes a
/// voxel.
std::vector<float> CoverageDistance(const GridGeometry& geometry, std::span<const float> coverage,
  const ProgressFunction& progress = {});

} // namespace hasp
