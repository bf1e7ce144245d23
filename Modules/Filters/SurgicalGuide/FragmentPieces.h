#pragma once
#include "Blade.h"
#include "FragmentCutter.h"

#include <span>
#include <utility>
#include <vector>

namespace hasp
{

/// Which triangles of a closed mesh a ray along x meets, by bins across it.
class MeshRays
{
public:
  /// Keeps a reference.
  explicit MeshRays(const TriangleMesh& mesh);

  /// The triangles that the ray from a place towards +x passes through; each, once.
  std::vector<std::uint32_t> Hits(const glm::dvec3& from) const;

private:
  const TriangleMesh& Mesh;
  glm::dvec2 Low;
  glm::ivec2 Bins;
  std::vector<std::vector<std::uint32_t>> Triangles; ///< that reach into each bin
};

/// The pieces of a contour as fragments, numbered by volume, hollows with the piece around them.
/// A hollow that no piece is around is left out: such are the walls of nothing.
std::vector<BoneFragment> FragmentsOf(const TriangleMesh& mesh, double crumbBelowMm3);

/// A place that stands for a fragment lies in it, or this near to it.
inline constexpr double FarthestSeedMm = 3.0;

/// The fragment that a place lies in, and 0; else the one with the nearest point, and how far that
/// is, 1e30 if there is none. rays   of each fragment's mesh
std::pair<std::size_t, double> NearestFragment(
  std::span<const BoneFragment> fragments, std::span<const MeshRays> rays, const glm::dvec3& place);

/// Whether each place can lie in a fragment, to be asked before there are any. bone   1: that is
/// cut. Throws std::runtime_error "resected[n] …".
void CheckResected(
  const GridGeometry& ct, std::span<const std::uint8_t> bone, std::span<const glm::dvec3> places);

/// Marks the fragment that each place lies in, or within 3 mm of. Throws std::runtime_error
/// "resected[n] …" where there is none.
void MarkResected(std::vector<BoneFragment>& fragments, std::span<const glm::dvec3> places);

/// Whether a piece of bone has a face of a blade: on its front (+1) or its back (-1), and of bone
/// that the tool took. `toleranceMm`: how far points of a plane face may be off it.
bool HasFace(const TriangleMesh& piece, const CutTool& tool, int side, double toleranceMm);

/// mm^3, signed: positive if triangles face outward.
double VolumeOf(const TriangleMesh& mesh);

} // namespace hasp
