#include "Evaluation/SelfIntersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hasp
{

std::vector<std::array<std::uint32_t, 2>> FindSelfIntersections(const TriangleMesh& mesh)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  vertices.reserve(mesh.points.size());
  for (const glm::dvec3& p : mesh.points)
    vertices.push_back(surface.add_vertex({ p.x, p.y, p.z }));
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n)
  {
    const glm::uvec3& t = mesh.triangles[n];
    if (CGAL::collinear(surface.point(vertices.at(t.x)), surface.point(vertices.at(t.y)),
          surface.point(vertices.at(t.z))))
      throw std::invalid_argument(
        "self-intersections: triangle " + std::to_string(n) + " has no area; see CheckMesh");
    if (surface.add_face(vertices[t.x], vertices[t.y], vertices[t.z]) == Surface::null_face())
      throw std::invalid_argument("self-intersections: triangle " + std::to_string(n) +
                                  " makes the mesh no oriented 2-manifold; see CheckMesh");
  }
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(pairs));
  std::vector<std::array<std::uint32_t, 2>> found;
  for (const auto& [a, b] : pairs) // faces are numbered in the order they were added
    found.push_back({ static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b) });
  return found;
}

std::size_t CountSelfIntersections(const TriangleMesh& mesh)
{
  return FindSelfIntersections(mesh).size();
}

} // namespace hasp
