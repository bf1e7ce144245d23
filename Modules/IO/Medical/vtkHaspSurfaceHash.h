#ifndef vtkHaspSurfaceHash_h
#define vtkHaspSurfaceHash_h

#include "Grid/TriangleMesh.h"      // for TriangleMesh
#include "vtkHaspIOMedicalModule.h" // for export macro

#include <string> // for hashes

/// Whether two files hold the same surface, whatever their formats. Any thread.
namespace hasp
{

/// SHA-256 as 64 hexadecimal digits of a mesh's triangles; empty in a build without OpenSSL.
///
/// Equal for one surface stored as STL, PLY, OBJ, 3MF or VTP: corners count as float32, -0 as 0, in
/// whatever order triangles, points and the corners of a triangle are, and whether points are
/// shared. Different where a corner is another float32 at all, a triangle is wound the other way
/// round, or stands there twice. Limit: .3mf rounds coordinates, and may have another hash than the
/// file that it was made from.
/// Throws std::invalid_argument if a triangle names a point that is not there, or a point is not
/// finite in float32. O(triangles log triangles), 36 bytes each.
VTKHASPIOMEDICAL_EXPORT std::string SurfaceHash(const TriangleMesh& mesh);

} // namespace hasp

#endif
