#pragma once
#include "Distance/CreasePoints.h"
#include "Distance/DividedTetrahedron.h"
#include "Distance/KuhnTetrahedra.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace hasp
{

struct ContourLimits
{
  double tolerance; ///< mm, of a curve from straight sides of triangles
  double step;      ///< mm, of the floats that the points are rounded to
};

/// The sharp contour (SharpContour.h) of one block of cells, which knows nothing of other blocks:
/// each point is made of the corners of its edge, triangle or tetrahedron alone, in an order that
/// follows from their places, and so has the same bits in every block that it belongs to.
///
/// One thread; one object for one block.
class BlockContour
{
public:
  /// Keeps references.
  BlockContour(const BoundedSolid& solid, const GridGeometry& grid, const ContourLimits& limits);

  /// Cells [first, first + size) of the grid, with no more than what of it lies in the grid.
  /// Halves what may hold surface, and leaves out the rest.
  void Contour(const glm::ivec3& first, int size);
  /// Frees what only Contour needs: ten times what it has made.
  void FreeWork();

  std::vector<glm::dvec3> Indices;   ///< of the points before they were rounded, no two the same
  std::vector<glm::dvec3> Points;    ///< mm, world, of 32-bit floats
  std::vector<glm::uvec3> Triangles; ///< counter-clockwise from outside in a right-handed grid
  std::size_t Cells = 0, Splits = 0, CreasePoints = 0, KeptInside = 0;
  double LeastSteps = 1e30; ///< of floats, that the parts of divided tetrahedra are high

private:
  static constexpr std::uint32_t None = ~0U;
  static constexpr double FarShare = 0.04; ///< of a cell: what is further off is divided
  /// Squares of cells, of triangles that look away from their faces: above, a fan is folded.
  static constexpr double MostTurned = 0.001;
  using Tetrahedron = std::array<std::uint32_t, 4>;

  struct Vertex
  {
    glm::dvec3 index, world;
    ImplicitSolid::Sample sample;
    int level; ///< 0 for the grid's points, one more for each edge that it halves
  };
  struct Edge
  {
    std::uint32_t split = None; ///< the vertex that halves it
    std::uint32_t point = None; ///< of the surface
    EdgeCrossing crossing;      ///< exact; the point keeps away from the ends
  };
  struct Face
  {
    std::uint32_t split = None; ///< the vertex that divides it by three
    std::uint32_t from = None;  ///< the first of the triangle's crossings
    std::uint32_t point[2]{};   ///< of the surface, where it bends
    Bends bends;
    CrossedTriangle triangle; ///< by the rounded points
  };

  /// The closed line on a tetrahedron's boundary: crossings of edges, and bends between.
  struct Loop
  {
    std::array<glm::dvec3, 4> index, world; ///< of the tetrahedron's corners
    Shell shell;                            ///< the boundary, divided by the line
    std::vector<std::uint32_t> points;      ///< counter-clockwise in a right-handed grid
    std::vector<FacePlace> places;
    glm::dvec3 start{ 0.0 };   ///< the middle of the crossings
    glm::dvec4 safe{ 0.0 };    ///< the same, kept away from the ends of edges, as shares
    glm::dvec3 creases{ 0.0 }; ///< sum of
    int creaseCount = 0;
  };

  /// Of some places on flat parts of a surface the one that is furthest off the solid's.
  struct Furthest
  {
    glm::dvec3 at{ 0.0 };
    double value = 0.0;

    void Offer(const glm::dvec3& place, double here)
    {
      if (std::abs(here) > std::abs(this->value))
        this->at = place, this->value = here;
    }
    void Offer(const BoundedSolid& solid, const glm::dvec3& place)
    {
      this->Offer(place, solid.At(place));
    }
  };
  struct Fan
  {
    glm::dvec3 center; ///< in index coordinates
    double steps;      ///< of floats, that its parts are high
    bool kept;         ///< not where it would be
    double turned;     ///< of its triangles, away from the solid's own faces; squares of cells
    Furthest furthest;
  };

  bool Inside(std::uint32_t vertex) const { return this->Vertices[vertex].sample.value < 0.0; }
  bool Before(std::uint32_t a, std::uint32_t b) const;
  bool EarlierEdge(
    const std::array<std::uint32_t, 2>& a, const std::array<std::uint32_t, 2>& b) const;
  std::uint32_t AddVertex(const glm::dvec3& index, int level);
  std::uint32_t GridVertex(const glm::ivec3& place);
  glm::dvec3 Rounded(const glm::dvec3& index) const;
  std::uint32_t AddPoint(const glm::dvec3& index);
  Edge& FindEdge(std::uint32_t a, std::uint32_t b);
  const Face& FindFace(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void Cell(const glm::ivec3& cell);
  int Level(std::span<const std::uint32_t> simplex) const;
  TipLimits Tips(std::span<const std::uint32_t> simplex) const;
  void Refine(const Tetrahedron& corners);
  void Divide(
    const Tetrahedron& corners, std::span<const std::uint32_t> around, std::uint32_t split);
  template <std::size_t N>
  std::uint32_t DivideFar(const std::array<std::uint32_t, N>& simplex, const Furthest& furthest);
  std::array<std::uint32_t, 2> SplitEdge(const Tetrahedron& corners, std::uint32_t& split);
  std::array<std::uint32_t, 3> SplitFace(const Tetrahedron& corners, std::uint32_t& split);
  void Bend(Face& face, const std::array<std::uint32_t, 3>& corners);
  void Surface(const Tetrahedron& corners);
  void Follow(Loop& loop, const Tetrahedron& corners, const TetrahedronSides& sides, int n);
  void Enclose(Loop& loop, const Tetrahedron& corners);
  bool IsPlain(const Loop& loop, std::size_t first);
  Fan FanAt(const Loop& loop, const glm::dvec3& corner);
  void Fit(const Loop& loop, Fan& fan) const;
  Fan FirstFan(const Loop& loop);
  void Improve(const Loop& loop, Fan& fan);
  /// Two fans beside each other: of the line's parts from `first` up to `last`, and of the others.
  struct TwoFans
  {
    std::array<glm::dvec3, 2> center; ///< in index coordinates
    std::size_t first = 0, last = 0;
    double turned = 0.0, steps = 0.0;
  };
  std::optional<TwoFans> BestTwoFans(const Loop& loop, double most) const;
  std::vector<glm::dvec3> CreaseCenters(const Loop& loop) const;
  double Turned(const std::array<glm::dvec3, 3>& triangle, const glm::dvec3& gradient) const;
  double StepsOf(const Loop& loop, const TwoFans& fans) const; ///< of floats, that parts are high
  void AddFans(const Loop& loop, const TwoFans& fans);
  void OfferFaces(const Loop& loop, Fan& best);
  void OfferSteps(const Loop& loop, Fan& best);
  void Offer(const Loop& loop, const glm::dvec3& corner, Fan& best);

  const BoundedSolid& Solid;
  const GridGeometry& Grid;
  ContourLimits Limits;
  std::vector<Vertex> Vertices;
  std::vector<Edge> EdgeList;
  std::unordered_map<std::uint64_t, std::uint32_t> VertexAt, EdgeBetween;
  std::unordered_map<std::uint64_t, Face> FaceBetween;
};

} // namespace hasp
