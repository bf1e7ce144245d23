#pragma once
#include "vtkHaspSurfaceFile.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

/// The formats that parts are written in: stl, 3mf, ply and obj.
namespace hasp
{

struct Session;

/// ".stl", …: what --output of a part may end in.
const std::vector<std::string>& PartEndings();
/// --format, of verbs that write a folder of parts.
void AddFormatOption(CLI::App& verb, std::string& format);

/// A surface as it was written into another file.
struct SurfaceCopy
{
  SurfacePassport written;
  std::size_t bytes = 0;
  double shiftMm = 0.0; ///< the farthest that a corner has moved
};

/// Writes a surface into a file of any format, by its ending, with what its own file says of the
/// part, and objects as objects where the format has them; reads it back, and keeps it only if each
/// triangle is where it was within 1e-4 mm. Throws Failure: FailedCheck, else WrongUse.
SurfaceCopy CopySurface(const LoadedSurface& surface, const std::string& to, Session& session);

/// The same of the bytes of a .stl file, as plans keep parts: as they are, or in another format.
void WriteStlAs(const std::string& stl, const std::string& to, Session& session);

/// The parts of a run below `folder`, .stl files that `run` names with their SHA-256, in another
/// format. Returns run.json for them. What was certified of the .stl holds of them: the triangles
/// are the same.
std::string RunInFormat(std::string run, const std::string& format,
  const std::filesystem::path& folder, Session& session);

} // namespace hasp
