#pragma once
#include "Grid/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>

namespace hasp
{

/// What a mesh must be before it is printed.
struct MeshCheck
{
  std::size_t points = 0, triangles = 0;
  std::size_t borderEdges = 0;   ///< edges of one triangle: holes
  std::size_t crowdedEdges = 0;  ///< edges of three triangles or more
  std::size_t turnedEdges = 0;   ///< edges whose two triangles run the same way round
  std::size_t pinchedPoints = 0; ///< points whose triangles are not one fan
  std::size_t degenerate = 0;    ///< triangles with a repeated point or no area at all
  std::size_t pieces = 0;        ///< connected through edges
  double volumeMm3 = 0.0;        ///< signed; positive if triangles face outward
  double areaMm2 = 0.0;
  ///@{
  /// Where the first of each is, mm; nothing if there is none.
  std::optional<glm::dvec3> borderAt, crowdedAt, turnedAt, pinchedAt, degenerateAt;
  ///@}

  /// No border.
  bool Closed() const { return this->triangles > 0 && this->borderEdges == 0; }
  /// Every edge has one or two triangles, every point one fan of them.
  bool TwoManifold() const { return this->crowdedEdges == 0 && this->pinchedPoints == 0; }
  /// Consistently oriented, and the whole encloses a positive volume.
  bool Outward() const { return this->turnedEdges == 0 && this->volumeMm3 > 0.0; }
  bool Sound() const
  {
    return this->Closed() && this->TwoManifold() && this->Outward() && this->degenerate == 0;
  }
};

/// Looks at every edge, point and triangle. Points are told apart by index: weld the mesh first
/// (WeldPoints). Throws std::invalid_argument if a triangle names a point that is not there.
/// Any thread; O(triangles log triangles), one core. Self-intersections: see SelfIntersections.h.
MeshCheck CheckMesh(const TriangleMesh& mesh);

/// The mesh with points of equal coordinates made one, as after reading an STL file, which repeats
/// the corners of every triangle. Triangles that collapse are kept, for CheckMesh to count.
/// Throws std::invalid_argument, naming the point, on coordinates that are not finite.
TriangleMesh WeldPoints(const TriangleMesh& mesh);

} // namespace hasp
