#include "Distance/TetrahedraContour.h"
#include "Distance/KuhnTetrahedra.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr double EdgeMargin = 0.02;
constexpr std::uint32_t NoPoint = std::numeric_limits<std::uint32_t>::max();

/// Marching over two slices of grid points at a time.
class Marcher
{
public:
  explicit Marcher(const GridView<const float>& field) : Field(field), Dims(field.geometry.dims)
  {
    const std::size_t slice = std::size_t(this->Dims.x) * this->Dims.y;
    for (auto& ids : this->PointOnEdge)
      ids.assign(7 * slice, NoPoint);
    this->Mirrored = glm::determinant(field.geometry.direction) < 0.0;
  }

  /// The cells between slices k and k + 1.
  void Slab(int k)
  {
    std::swap(this->PointOnEdge[0], this->PointOnEdge[1]);
    std::fill(this->PointOnEdge[1].begin(), this->PointOnEdge[1].end(), NoPoint);
    for (int j = 0; j + 1 < this->Dims.y; ++j)
      for (int i = 0; i + 1 < this->Dims.x; ++i)
        this->Cell({ i, j, k });
  }

  TriangleMesh Mesh;

private:
  float Value(const glm::ivec3& p) const
  {
    const float v = this->Field(p.x, p.y, p.z);
    const bool border = p.x == 0 || p.y == 0 || p.z == 0 || p.x == this->Dims.x - 1 ||
                        p.y == this->Dims.y - 1 || p.z == this->Dims.z - 1;
    // Never 0, which has no side, nor infinite, which has no crossing.
    constexpr float least = std::numeric_limits<float>::min(), most = 1e30F;
    return v < 0.0F && !border ? std::clamp(v, -most, -least)
                               : std::clamp(v > 0.0F ? v : least, least, most);
  }

  void Cell(const glm::ivec3& cell)
  {
    std::array<float, 8> value;
    int inside = 0;
    for (int c = 0; c < 8; ++c)
    {
      value[c] = this->Value(cell + CellCorner(c));
      inside |= (value[c] < 0.0F) << c;
    }
    if (inside == 0 || inside == 255)
      return;
    for (const auto& t : KuhnTetrahedra)
      this->Tetrahedron(cell, value, t);
  }

  void Tetrahedron(const glm::ivec3& cell, const std::array<float, 8>& value, const int (&t)[4])
  {
    const TetrahedronSides sides =
      SidesOf({ value[t[0]] < 0.0F, value[t[1]] < 0.0F, value[t[2]] < 0.0F, value[t[3]] < 0.0F });
    std::uint32_t points[4];
    for (int n = 0; n < sides.crossings; ++n)
      points[n] = this->Point(
        cell, value, t[sides.corner[sides.crossing[n][0]]], t[sides.corner[sides.crossing[n][1]]]);
    // A left-handed grid turns every tetrahedron inside out.
    const bool turned = sides.odd != this->Mirrored;
    for (int n = 2; n < sides.crossings; ++n)
      this->Mesh.triangles.push_back(turned ? glm::uvec3(points[0], points[n], points[n - 1])
                                            : glm::uvec3(points[0], points[n - 1], points[n]));
  }

  /// The crossing on the edge between two corners of a cell, made once and found again by every
  /// tetrahedron around the edge.
  std::uint32_t Point(const glm::ivec3& cell, const std::array<float, 8>& value, int a, int b)
  {
    const int low = std::min(a, b), high = std::max(a, b); // Kuhn edges never go down on any axis
    const glm::ivec3 from = cell + CellCorner(low);
    const std::size_t column = std::size_t(from.y) * this->Dims.x + from.x;
    std::uint32_t& id = this->PointOnEdge[from.z - cell.z][7 * column + (high - low) - 1];
    if (id == NoPoint)
    {
      const double v0 = value[low], v1 = value[high];
      const double t = std::clamp(v0 / (v0 - v1), EdgeMargin, 1.0 - EdgeMargin);
      if (this->Mesh.points.size() >= NoPoint)
        throw std::invalid_argument("contour: more than 2^32 - 1 points; use a coarser grid");
      id = static_cast<std::uint32_t>(this->Mesh.points.size());
      this->Mesh.points.push_back(this->Field.geometry.IndexToWorld(
        glm::dvec3(from) + t * glm::dvec3(CellCorner(high - low))));
    }
    return id;
  }

  const GridView<const float>& Field;
  glm::ivec3 Dims;
  bool Mirrored = false;
  std::array<std::vector<std::uint32_t>, 2> PointOnEdge; ///< 7 edges leave each point of a slice
};
} // namespace

TriangleMesh ContourTetrahedra(const GridView<const float>& field, const ProgressFunction& progress)
{
  field.geometry.Validate();
  Marcher marcher(field);
  for (int k = 0; k + 1 < field.geometry.dims.z; ++k)
  {
    marcher.Slab(k);
    ReportProgress(progress, double(k + 1) / double(field.geometry.dims.z));
  }
  return std::move(marcher.Mesh);
}

MeshPieces FindPieces(const TriangleMesh& mesh)
{
  std::vector<std::uint32_t> parent(mesh.points.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t p)
  {
    while (parent[p] != p)
      p = parent[p] = parent[parent[p]];
    return p;
  };
  for (const glm::uvec3& t : mesh.triangles)
  {
    parent[root(t.y)] = root(t.x);
    parent[root(t.z)] = root(t.x);
  }
  MeshPieces pieces;
  std::vector<std::uint32_t> pieceOfRoot(mesh.points.size(), NoPoint);
  for (const glm::uvec3& t : mesh.triangles)
  {
    std::uint32_t& piece = pieceOfRoot[root(t.x)];
    if (piece == NoPoint)
    {
      piece = static_cast<std::uint32_t>(pieces.volume.size());
      pieces.volume.push_back(0.0);
    }
    pieces.pieceOfTriangle.push_back(piece);
    const glm::dvec3& o = mesh.points[mesh.triangles.front().x]; // near: keeps the sum accurate
    pieces.volume[piece] +=
      glm::dot(mesh.points[t.x] - o, glm::cross(mesh.points[t.y] - o, mesh.points[t.z] - o)) / 6.0;
  }
  return pieces;
}

TriangleMesh WithoutSmallPieces(const TriangleMesh& mesh, double leastMm3)
{
  const MeshPieces pieces = FindPieces(mesh);
  TriangleMesh kept;
  std::vector<std::uint32_t> newId(mesh.points.size(), NoPoint);
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n)
  {
    if (std::abs(pieces.volume[pieces.pieceOfTriangle[n]]) < leastMm3)
      continue;
    glm::uvec3 t = mesh.triangles[n];
    for (int c = 0; c < 3; ++c)
    {
      std::uint32_t& id = newId[t[c]];
      if (id == NoPoint)
      {
        id = static_cast<std::uint32_t>(kept.points.size());
        kept.points.push_back(mesh.points[t[c]]);
      }
      t[c] = id;
    }
    kept.triangles.push_back(t);
  }
  return kept;
}

} // namespace hasp
