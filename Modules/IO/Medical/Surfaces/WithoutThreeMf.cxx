#include "Files/FileError.h"
#include "Surfaces/SurfaceFormat.h"
#include "Surfaces/SurfaceOutput.h"

#include <stdexcept>

// This build was made without lib3mf: the error says what to do.
namespace hasp
{

LoadedSurface ReadThreeMf(
  const std::filesystem::path& file, const SurfaceReadSettings&, const ProgressFunction&)
{
  ThrowFileError(file, "this build of Hasp was made without 3MF; configure it with "
                       "HASP_ENABLE_LIB3MF=ON (Debian: lib3mf-dev)");
}

std::vector<char> EncodeThreeMf(const std::vector<NamedMesh>&, const PartLabel&)
{
  throw std::runtime_error("this build of Hasp was made without 3MF; configure it with "
                           "HASP_ENABLE_LIB3MF=ON (Debian: lib3mf-dev), or write .stl");
}

} // namespace hasp
