#include "Surfaces/PartText.h"
#include "Surfaces/SurfaceOutput.h"

#include <glm/geometric.hpp>

#include <charconv>
#include <string>

namespace hasp
{
namespace
{

/// The machine is little-endian, and so are the formats.
template <typename T>
void AddVector(const glm::dvec3& v, PieceWriter& into)
{
  for (int a = 0; a < 3; ++a)
    into.Add(static_cast<T>(v[a]));
}

void AddText(const std::string& text, PieceWriter& into)
{
  into.Add(text.data(), text.size());
}

/// The shortest decimal that reads back as the same number.
template <typename T>
void AddDecimal(T number, char after, PieceWriter& into)
{
  char text[40];
  char* end = std::to_chars(text, text + sizeof(text) - 1, number).ptr;
  *end++ = after;
  into.Add(text, end - text);
}

} // namespace

void WriteStl(const TriangleMesh& mesh, bool, const PartLabel& label, PieceWriter& into)
{
  std::string header = PartText(label, 80);
  header.resize(80, ' ');
  AddText(header, into);
  into.Add(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const glm::uvec3& triangle : mesh.triangles)
  {
    const glm::dvec3 &a = mesh.points[triangle.x], &b = mesh.points[triangle.y],
                     &c = mesh.points[triangle.z];
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double length = glm::length(cross);
    AddVector<float>(length > 0.0 ? cross / length : glm::dvec3(0.0), into); // 0: reader's business
    for (const glm::dvec3& corner : { a, b, c })
      AddVector<float>(corner, into);
    into.Add(std::uint16_t(0));
  }
}

void WritePly(const TriangleMesh& mesh, bool narrow, const PartLabel& label, PieceWriter& into)
{
  const std::string type = narrow ? "float" : "double";
  AddText("ply\nformat binary_little_endian 1.0\ncomment " + PartText(label) + "\nelement vertex " +
            std::to_string(mesh.points.size()) + "\nproperty " + type + " x\nproperty " + type +
            " y\nproperty " + type + " z\nelement face " + std::to_string(mesh.triangles.size()) +
            "\nproperty list uchar int vertex_indices\nend_header\n",
    into);
  for (const glm::dvec3& point : mesh.points)
    narrow ? AddVector<float>(point, into) : AddVector<double>(point, into);
  for (const glm::uvec3& triangle : mesh.triangles)
  {
    into.Add(std::uint8_t(3));
    into.Add(triangle);
  }
}

/// OBJ declares no counts; the comment does, so that a file that was cut off is noticed.
void WriteObj(const TriangleMesh& mesh, bool, const PartLabel& label, PieceWriter& into)
{
  AddText("# " + PartText(label) + "; POINTS=" + std::to_string(mesh.points.size()) +
            "; TRIANGLES=" + std::to_string(mesh.triangles.size()) + "\n",
    into);
  if (!label.name.empty())
    AddText("o " + label.name + "\n", into);
  for (const glm::dvec3& point : mesh.points)
  {
    AddText("v ", into);
    AddDecimal(point.x, ' ', into);
    AddDecimal(point.y, ' ', into);
    AddDecimal(point.z, '\n', into);
  }
  for (const glm::uvec3& triangle : mesh.triangles)
  {
    AddText("f ", into);
    AddDecimal(triangle.x + std::uint64_t(1), ' ', into);
    AddDecimal(triangle.y + std::uint64_t(1), ' ', into);
    AddDecimal(triangle.z + std::uint64_t(1), '\n', into);
  }
}

} // namespace hasp
