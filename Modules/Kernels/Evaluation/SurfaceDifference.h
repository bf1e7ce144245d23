#pragma once
#include "Evaluation/MeshSamples.h"
#include "Evaluation/TriangleTree.h"
#include "Grid/RigidPose.h"
#include "Grid/TriangleMesh.h"

#include <cstddef>
#include <vector>

namespace hasp
{

/// A mesh, ready to be measured against others in any pose: places all over it, and its tree.
///
/// leastSamples   [100, 200,000]; there are as many places at least, and one of each triangle; ten
///                thousand are what the evaluation of Paper IV asks for
/// Throws std::invalid_argument on leastSamples out of range, a mesh of which no triangle is higher
/// than SliverMm, a point that is not finite, and a triangle whose points are not there;
/// std::runtime_error as SampleMesh. Immutable; any thread may use it. O(n log n), some 200 bytes a
/// triangle.
class MeasuredSurface
{
public:
  explicit MeasuredSurface(const TriangleMesh& mesh, std::size_t leastSamples = 10'000);

  const TriangleTree& Tree() const { return this->Triangles; }
  /// In the mesh's own place. Weighted by their areas they stand for the surface.
  const std::vector<MeshSample>& Samples() const { return this->Places; }
  /// The points that its triangles have, each once.
  const std::vector<glm::dvec3>& Points() const { return this->Corners; }
  double AreaMm2() const { return this->Area; }        ///< that the samples stand for
  glm::dvec3 Centroid() const { return this->Middle; } ///< of the surface, by area
  /// No part that a sample stands for has a longer side. A distance changes by no more than the way
  /// that one goes: the farthest place of the whole surface is at most 2/3 of this farther than the
  /// farthest sample, and where distances change evenly, means are exact.
  double SpacingMm() const { return this->Spacing; }

private:
  TriangleTree Triangles;
  std::vector<MeshSample> Places;
  std::vector<glm::dvec3> Corners;
  double Area = 0.0, Spacing = 0.0;
  glm::dvec3 Middle{ 0.0 };
};

/// Distances, mm, >= 0, from the places of one surface to another. Shares are of area.
struct DirectedDifference
{
  double meanMm = 0.0, rmsMm = 0.0;
  double p50Mm = 0.0, p95Mm = 0.0, p99Mm = 0.0;
  double maxMm = 0.0;                    ///< of the samples and of the mesh's own points
  glm::dvec3 maxAt{ 0.0 }, maxTo{ 0.0 }; ///< the place of it, and what is nearest to it; world
  double areaMm2 = 0.0;
  std::size_t samples = 0;
  double spacingMm = 0.0; ///< MeasuredSurface::SpacingMm
};

/// How far two surfaces are apart (Paper IV, S2S).
struct SurfaceDifference
{
  DirectedDifference aToB, bToA;
  /// Of all places of both: the mean is the symmetric S2S, the maximum the Hausdorff distance over
  /// the samples. maxAt is on the surface that it was found on.
  DirectedDifference both;
};

/// Distances between two surfaces in their poses; open ones, too. Unsigned, and blind to sliding: a
/// ball that is turned is no distance away. ComparePoses says how far its points are.
///
/// Method: for each sample the nearest place of the other mesh, exactly (TriangleTree::Nearest).
/// Throws std::invalid_argument on a pose that is not finite or not unit within 1e-6. Any thread;
/// all cores; the same bits on any number of them. O(samples log triangles), about 60 ms for two
/// balls of 10,000 samples on two busy cores.
SurfaceDifference MeasureSurfaceDifference(const MeasuredSurface& a, const RigidPose& aToWorld,
  const MeasuredSurface& b, const RigidPose& bToWorld);
/// From the first to the second alone.
DirectedDifference MeasureDistances(const MeasuredSurface& from, const RigidPose& fromToWorld,
  const MeasuredSurface& to, const RigidPose& toToWorld);
/// Where they are.
SurfaceDifference MeasureSurfaceDifference(const MeasuredSurface& a, const MeasuredSurface& b);

/// The pose with an orientation of length 1. Throws std::invalid_argument, "`name`: ...", if it is
/// not finite, or its orientation not unit within 1e-6 already.
RigidPose CheckedPose(const RigidPose& pose, const char* name);

} // namespace hasp
