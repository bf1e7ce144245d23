#include "Surfaces/SurfaceOutput.h"
#include "Files/FileError.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace hasp
{
namespace
{

/// `single`: the format holds float32 alone.
void CheckMesh(vtkPolyData* surface, const TriangleMesh& mesh, bool single)
{
  if (surface->GetNumberOfStrips() > 0)
    throw std::invalid_argument("surface: has triangle strips; run vtkTriangleFilter first");
  if (mesh.triangles.empty())
    throw std::invalid_argument("surface: has no triangles, there is nothing to write");
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument("surface: has " + std::to_string(mesh.triangles.size()) +
                                " triangles, files hold 4294967295; split it");
  for (const glm::uvec3& t : mesh.triangles)
    if (t.x >= mesh.points.size() || t.y >= mesh.points.size() || t.z >= mesh.points.size())
      throw std::invalid_argument("surface: a triangle names a point that is not there; it has " +
                                  std::to_string(mesh.points.size()));
  for (std::size_t n = 0; n < mesh.points.size(); ++n)
    for (int a = 0; a < 3; ++a)
      if (!std::isfinite(single ? static_cast<float>(mesh.points[n][a]) : mesh.points[n][a]))
        throw std::invalid_argument("surface: point " + std::to_string(n) + " has the coordinate " +
                                    Text(mesh.points[n][a]) + ", must be finite" +
                                    (single ? " in float32" : ""));
}

} // namespace

void WriteSurface(vtkPolyData* surface, const std::string& path,
  const std::function<void(const std::string&)>& inspect)
{
  const TriangleMesh mesh = MakeTriangleMesh(surface);
  const std::filesystem::path file = std::filesystem::u8path(path);
  const std::string ending = LowerExtension(file);
  const auto write = ending == ".stl"   ? WriteStl
                     : ending == ".ply" ? WritePly
                     : ending == ".obj" ? WriteObj
                                        : nullptr;
  if (!write)
    ThrowFileError(
      file, "surfaces are written as .stl, .ply or .obj; give the name one of these endings");
  CheckMesh(surface, mesh, ending == ".stl");
  AtomicFile output(file);
  PieceWriter pieces(output);
  write(mesh, surface->GetPoints()->GetDataType() != VTK_DOUBLE, pieces);
  pieces.Flush();
  if (inspect)
    inspect(output.TemporaryName().string());
  output.Commit();
}

} // namespace hasp
