#include "Files/AtomicFile.h"
#include "Volumes/VolumeFormat.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{

constexpr std::size_t HeaderBytes = 80, TriangleBytes = 50;

void CheckMesh(vtkPolyData* surface, const TriangleMesh& mesh)
{
  if (surface->GetNumberOfStrips() > 0)
    throw std::invalid_argument("surface: has triangle strips; run vtkTriangleFilter first");
  if (mesh.triangles.empty())
    throw std::invalid_argument("surface: has no triangles, there is nothing to write");
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument("surface: has " + std::to_string(mesh.triangles.size()) +
                                " triangles, STL holds 4294967295; split it");
  for (std::size_t n = 0; n < mesh.points.size(); ++n)
    for (int a = 0; a < 3; ++a)
      if (!std::isfinite(static_cast<float>(mesh.points[n][a])))
        throw std::invalid_argument("surface: point " + std::to_string(n) + " has the coordinate " +
                                    Text(mesh.points[n][a]) + ", must be finite in float32");
}

/// Twelve little-endian floats (normal, corners) and two zero bytes. The machine is little-endian.
void Append(const TriangleMesh& mesh, const glm::uvec3& triangle, std::vector<char>& into)
{
  const glm::dvec3 a = mesh.points[triangle.x], b = mesh.points[triangle.y],
                   c = mesh.points[triangle.z];
  const glm::dvec3 cross = glm::cross(b - a, c - a);
  const double length = glm::length(cross);
  const glm::dvec3 normal = length > 0.0 ? cross / length : glm::dvec3(0.0); // 0: reader's business
  std::array<float, 12> numbers;
  float* at = numbers.data();
  for (const glm::dvec3& v : { normal, a, b, c })
    for (int n = 0; n < 3; ++n)
      *at++ = static_cast<float>(v[n]);
  const std::size_t start = into.size();
  into.resize(start + TriangleBytes, 0);
  std::memcpy(into.data() + start, numbers.data(), sizeof(numbers));
}

} // namespace

void WriteSurface(vtkPolyData* surface, const std::string& path,
  const std::function<void(const std::string&)>& inspect)
{
  const TriangleMesh mesh = MakeTriangleMesh(surface);
  CheckMesh(surface, mesh);
  const std::filesystem::path file = std::filesystem::u8path(path);
  if (LowerExtension(file) != ".stl")
    ThrowFileError(file, "surfaces are written as .stl; give the name this ending");
  AtomicFile output(file);
  std::string header = "Hasp " HASP_VERSION " SPACE=LPS; UNIT=mm";
  header.resize(HeaderBytes, ' ');
  output.Write(header.data(), header.size());
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  output.Write(&count, sizeof(count));
  std::vector<char> piece;
  for (const glm::uvec3& triangle : mesh.triangles)
  {
    Append(mesh, triangle, piece);
    if (piece.size() >= TriangleBytes << 14)
    {
      output.Write(piece.data(), piece.size());
      piece.clear();
    }
  }
  output.Write(piece.data(), piece.size());
  if (inspect)
    inspect(output.TemporaryName().string());
  output.Commit();
}

} // namespace hasp
