#pragma once
#include "Grid/TriangleMesh.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace hasp
{

/// A mesh as light needs it.
struct LitMesh
{
  TriangleMesh mesh;              ///< open or closed; either side of a triangle is a surface
  std::vector<glm::vec3> normals; ///< of the points, for smooth shading; empty: triangles are flat
  std::vector<glm::vec3> colors;  ///< of the points, linear, [0, 1]; empty: the material's
};

struct TriangleHit
{
  double t; ///< of the ray
  std::uint32_t triangle;
  glm::vec2 at; ///< barycentric: weights of its second and third point
};

/// Traces rays against triangles with Embree's tree: meshes beside clustered cells.
///
/// Rays are moved in double precision to where they enter the mesh's box before Embree sees them,
/// and hits are computed again in double, so that a mesh far from the origin loses nothing; points
/// are kept in float from the middle of the box: 1e-7 of its size.
/// Threads: all const functions from any thread. About 150 bytes a triangle.
class TriangleTracer
{
public:
  /// O(n log n), all threads. Throws std::invalid_argument on points that are not finite, triangles
  /// of points that are not there (with the first one's number), or normals or colours of another
  /// number; std::runtime_error if Embree fails.
  explicit TriangleTracer(LitMesh mesh);
  ~TriangleTracer();
  TriangleTracer(const TriangleTracer&) = delete;
  TriangleTracer& operator=(const TriangleTracer&) = delete;

  const LitMesh& Mesh() const { return this->Given; }
  const glm::dvec3& Low() const { return this->LowCorner; } ///< of the box; above High if empty
  const glm::dvec3& High() const { return this->HighCorner; }
  std::size_t Bytes() const;

  /// The first triangle at tMin or more, before tMax. direction: not 0; t counts in its length.
  std::optional<TriangleHit> Trace(const glm::dvec3& origin, const glm::dvec3& direction,
    double tMin, double tMax = std::numeric_limits<double>::infinity()) const;
  bool Occluded(const glm::dvec3& origin, const glm::dvec3& direction, double tMin,
    double tMax = std::numeric_limits<double>::infinity()) const;

  /// Unit, by the order of its points; 0 for one without area.
  glm::dvec3 Normal(std::uint32_t triangle) const;
  /// Between the points' normals, unit; Normal where there are none.
  glm::dvec3 ShadingNormal(const TriangleHit& hit) const;
  /// Between the points' colours; nothing if there are none.
  std::optional<glm::vec3> Color(const TriangleHit& hit) const;
  /// By how much a ray must start off a triangle so that it does not meet it again.
  double Clearance() const { return this->StartClearance; }

private:
  class Tree;
  LitMesh Given;
  glm::dvec3 LowCorner, HighCorner, Middle{ 0.0 };
  double StartClearance = 0.0;
  std::unique_ptr<const Tree> Embree;
};

} // namespace hasp
