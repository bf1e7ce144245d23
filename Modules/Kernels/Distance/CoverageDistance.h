#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <span>
#include <vector>

namespace hasp
{

/// Signed Euclidean distance to a partially covered mask, the guides' transform (after Gustavson
/// and Strand 2011; the thesis uses the weighted <3,4,5> transform with the same purpose, Eq. 2.2,
/// which is ChamferDistance here).
///
/// coverage   dims.x*dims.y*dims.z values in [0,1], x fastest; 1 inside; see Coverage.h
/// Returns mm, NEGATIVE INSIDE, same shape. +infinity everywhere if nothing is covered, -infinity
/// if all is. Method: surface elements (SurfaceElements.h); within four voxels the distance is to
/// the surface that the elements around the foot point span together (implicit moving least squares
/// with its curvature made up for), farther out to the element of the nearest voxel that has one,
/// bent as the surface is there.
///
/// Error on smooth surfaces of 12 voxels' radius and more: 0.001 to 0.002 voxel rms and 0.02 at
/// most within three voxels, below 0.02 rms out to 40; where voxels of length h lie along a surface
/// of radius R, h^2 / (8 R). Sharp edges are not kept: within three voxels of the edges of boxes,
/// turned nine ways and of exact coverage, 0.19 voxels rms and 0.8 at most (TestCoverageDistance
/// prints and holds it), because elements of the faces turn towards each other; five voxels from
/// the edges 0.005. Away from the surface the sign is that of the voxel's own coverage. Neighbours
/// along an axis never differ by more than 1.01 times their spacing, also in noise and in walls of
/// a voxel (DistanceBounds.h). Throws as ExtractSurfaceElements; Cancelled. Any thread; all cores,
/// the same result with any number of them. O(voxels); 20 bytes a voxel.
std::vector<float> CoverageDistance(const GridGeometry& geometry, std::span<const float> coverage,
  const ProgressFunction& progress = {});

/// The same within four voxels (the smallest spacing) of the surface, +-4 voxels beyond: a narrow
/// band. It costs what the surface costs; of all voxels only the coverage is read and the sign
/// written. 8 bytes a voxel, and about 100 an element.
std::vector<float> CoverageDistanceBand(const GridGeometry& geometry,
  std::span<const float> coverage, const ProgressFunction& progress = {});

/// The same of a grey image as it is, to its trilinear isosurface; inside is value >= isovalue. For
/// scans that nobody made coverage of: true to what the scanner saw, which rounds a surface of
/// radius R by sigma^2 / R at a blur of sigma. Noise is measured, by how far elements lie off their
/// neighbours; that of 1 % of the step and more is smoothed along the surface (edges of a voxel or
/// two with it). Within three voxels, at a blur of 0.8 voxel and 3 % noise: 0.027 voxel rms at R =
/// 80, 0.031 at 40, of which the blur's share is 0.014 and 0.022; a single voxel may be 0.25 off.
/// NaN is refused: std::invalid_argument. 24 bytes a voxel.
std::vector<float> GreyDistance(
  const AnyGridView& image, double isovalue, const ProgressFunction& progress = {});

/// Of an image in [0,1] of unknown origin: CoverageDistance if its edges are as wide as coverage's
/// (MeasureEdges), else GreyDistance at 0.5. Taking one for the other is wrong by up to a voxel.
std::vector<float> ImageDistance(
  const GridView<const float>& image, const ProgressFunction& progress = {});

} // namespace hasp
