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

using Encode = std::function<void(const PartLabel& label, PieceWriter& into)>;

/// Writes, has the file inspected, writes it once more if it does not hold, and puts it in place.
void WriteLabelled(const std::filesystem::path& file, std::string_view ending,
  const PartLabel& label, const Encode& encode, const InspectPart& inspect)
{
  const auto fill = [&](AtomicFile& output, const PartLabel& said)
  {
    PieceWriter pieces(output);
    encode(said, pieces);
    pieces.Flush();
  };
  AtomicFile output(file, ending);
  fill(output, label);
  if (!inspect || inspect(output.TemporaryName().string()) == PartVerdict::Holds)
    return output.Commit();
  PartLabel red = label;
  red.doesNotHold = true;
  AtomicFile marked(file, ending);
  fill(marked, red);
  marked.Commit();
}

/// What all writers refuse of a surface.
TriangleMesh CheckedMesh(vtkPolyData* surface, bool single)
{
  TriangleMesh mesh = MakeTriangleMesh(surface);
  CheckMesh(surface, mesh, single);
  return mesh;
}

} // namespace

void WriteSurface(
  vtkPolyData* surface, const std::string& path, const PartLabel& label, const InspectPart& inspect)
{
  const std::filesystem::path file = std::filesystem::u8path(path);
  const std::string ending = LowerExtension(file);
  if (ending == ".3mf")
    return WriteSurfaces({ { label.name, surface } }, path, label, inspect);
  const auto write = ending == ".stl"   ? WriteStl
                     : ending == ".ply" ? WritePly
                     : ending == ".obj" ? WriteObj
                                        : nullptr;
  if (!write)
    ThrowFileError(
      file, "surfaces are written as .stl, .ply, .obj or .3mf; give the name one of these endings");
  ValidatePartLabel(label);
  const TriangleMesh mesh = CheckedMesh(surface, ending == ".stl");
  const bool narrow = surface->GetPoints()->GetDataType() != VTK_DOUBLE;
  WriteLabelled(
    file, ending, label,
    [&](const PartLabel& said, PieceWriter& into) { write(mesh, narrow, said, into); }, inspect);
}

void WriteSurfaces(const std::vector<NamedSurface>& surfaces, const std::string& path,
  const PartLabel& label, const InspectPart& inspect)
{
  const std::filesystem::path file = std::filesystem::u8path(path);
  if (LowerExtension(file) != ".3mf")
    ThrowFileError(file, "several surfaces are written as .3mf; give the name that ending");
  if (surfaces.empty())
    throw std::invalid_argument("there are no surfaces, and nothing to write");
  ValidatePartLabel(label);
  std::vector<NamedMesh> meshes;
  for (const NamedSurface& surface : surfaces)
  {
    ValidatePartLabel({ .name = surface.name, .hash = {} });
    meshes.push_back({ surface.name, CheckedMesh(surface.surface, true) });
  }
  WriteLabelled(
    file, ".3mf", label,
    [&](const PartLabel& said, PieceWriter& into)
    {
      const std::vector<char> bytes = EncodeThreeMf(meshes, said);
      into.Add(bytes.data(), bytes.size());
    },
    inspect);
}

} // namespace hasp
