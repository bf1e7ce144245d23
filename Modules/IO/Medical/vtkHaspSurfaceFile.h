#ifndef vtkHaspSurfaceFile_h
#define vtkHaspSurfaceFile_h

#include "Grid/Progress.h"          // for ProgressFunction
#include "vtkHaspIOMedicalModule.h" // for export macro
#include "vtkHaspPartLabel.h"       // for what the file says of the part
#include "vtkSmartPointer.h"        // for return values

#include <glm/vec3.hpp> // for bounds

#include <cstddef> // for size_t
#include <string>  // for texts
#include <vector>  // for warnings

class vtkPolyData;

/// Surface files without a pipeline: what vtkHaspSurfaceReader is a skin of.
/// Any thread; nothing is kept between calls.
namespace hasp
{

/// Triangles of a surface that the file keeps as an object of its own.
struct SurfacePiece
{
  std::string name; ///< one that IsPartName takes, else "object N", from 1
  std::size_t firstTriangle = 0, triangles = 0;
};

/// What is known of a surface. Holds no text of the file and no path, so it may be shown, logged
/// and sent. Whether the surface is closed is for hasp::CheckMesh (Evaluation/MeshCheck.h) to say.
struct SurfacePassport
{
  std::string format;         ///< "STL", "PLY", "OBJ", "VTP" or "3MF"
  std::string encoding;       ///< "text", "binary", "binary, big endian", "XML" or "zip"
  std::string space;          ///< "LPS" or "RAS" if the file says so; empty if it does not
  std::string coordinateType; ///< of the points handed on: "float32" or "float64"
  std::size_t points = 0;     ///< STL repeats each: there, those of one place count once
  std::size_t triangles = 0;
  std::size_t cutPolygons = 0; ///< faces of more than three corners, cut into triangles
  std::size_t degenerate = 0;  ///< triangles without an area: a point repeated, or in a line
  glm::dvec3 minimum{ 0.0 };   ///< of the triangles' corners, patient LPS, mm
  glm::dvec3 maximum{ 0.0 };
  std::vector<std::string> warnings; ///< full sentences, for the user
  PartLabel label;                   ///< what Hasp wrote of the part; empty without
  std::vector<SurfacePiece> pieces;  ///< objects of a .3mf, one after the other; else empty
};

struct SurfaceReadSettings
{
  std::size_t memoryLimitBytes = std::size_t(4)
                                 << 30; ///< of points and triangles; checked before it is taken
  std::size_t decoderMemoryBytes = std::size_t(2)
                                   << 30; ///< of the child process that reads .vtp and .3mf, in all
  double decoderSilenceSeconds = 2.0;     ///< that child is ended after so long without a sign of
                                          ///< life, in (0, 1e6]; a second more for 8 MiB of file
  double decoderTotalSeconds = 600.0;     ///< or after so long in all, in (0, 1e6]
};

struct LoadedSurface
{
  SurfacePassport passport;
  vtkSmartPointer<vtkPolyData> surface; ///< points and triangles alone, patient LPS, mm
};

/// Does the name end like a surface that LoadSurface reads: .stl, .ply, .obj, .3mf, .vtp?
VTKHASPIOMEDICAL_EXPORT bool IsSurfaceName(const std::string& path);

/// Reads STL (binary, text), PLY (text, binary of either byte order), OBJ, 3MF or VTP into
/// triangles. UTF-8 path.
///
/// "SPACE=RAS" in the header or a comment, as 3D Slicer writes it, turns the surface to LPS;
/// without a word on it LPS is taken, with a warning. Points are float32 where that loses nothing,
/// else float64. Points of an STL file are made one where their coordinates are equal. Polygons are
/// cut as fans from their first corner; those that are not flat and convex are counted in a
/// warning. Triangles without an area stay. Normals, colours, texture, names and field data do not
/// come over.
///
/// Refused, by line or byte: what ends early or holds more than it declares, counts that the file
/// is too short for or that pass the memory limit, points that are absent, not finite or more than
/// 1e6 mm away, lines above 1 MiB. VTP and 3MF are parsed by child processes (HASP_XML_DECODER and
/// HASP_3MF_DECODER override where they are) that may crash or hang without harm.
/// Of a 3MF file come what it builds, objects in the places where it puts them, each a piece, also
/// where it is built twice; in other units than mm it is scaled, with a warning. Without
/// HASP_ENABLE_LIB3MF it is refused.
/// Limit: OBJ declares no counts, so an OBJ file that was cut off at the end of a line is not
/// noticed, unless Hasp wrote it. A last line without an end is a warning.
///
/// Throws std::invalid_argument (settings), std::runtime_error (file: its label, what is wrong and
/// what to do; no text of the file), Cancelled. O(bytes), one core.
VTKHASPIOMEDICAL_EXPORT LoadedSurface LoadSurface(const std::string& path,
  const SurfaceReadSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp

#endif
