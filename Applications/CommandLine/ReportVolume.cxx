#include "ReportVolume.h"

#include "Failure.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspVolumeFile.h"

#include "vtkImageData.h"

#include <filesystem>
#include <new>

namespace hasp
{
namespace
{

/// Of Cranium.inv3 in Debian's invesalius-examples: VolumeHash.
constexpr const char* CraniumHash =
  "e0acad16d649f7d560c29e1bba6a4c1401154b04779ce5c24f89ae189ce167ab";

/// What `read` gives, its exceptions as failures of the verb.
template <typename Read>
auto Reading(const Read& read)
{
  try
  {
    return read();
  }
  catch (const std::bad_alloc&)
  {
    throw; // no fault of the file; the caller says what to do
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::BadInput, SafeText(error));
  }
}

std::string Size(const GridGeometry& grid)
{
  const glm::ivec3& n = grid.dims;
  return std::to_string(n.x) + "x" + std::to_string(n.y) + "x" + std::to_string(n.z);
}

} // namespace

ReportVolume ReadReportVolume(const std::string& path)
{
  VolumeReadSettings settings;
  settings.hash = true;
  const LoadedVolume read = Reading([&] { return LoadVolume(OpenVolume(path, settings)); });
  const Passport& passport = read.passport;
  const bool cranium = passport.hash == CraniumHash;
  ReportVolume volume{ read.image, cranium ? "cranium" : "volume",
    (cranium ? "real CT, " : "given volume, ") + Size(passport.geometry) + ", 226" };
  if (!(volume.isovalue > passport.minimum && volume.isovalue <= passport.maximum))
    throw Failure(ExitCode::BadInput,
      FileLabel(path) + ": has no surface at 226, bone in HU, where reports measure; give another "
                        "--volume");
  return volume;
}

void RequireReportVolume(const std::string& path)
{
  if (std::filesystem::exists(path))
    Reading([&] { return OpenVolume(path); });
}

} // namespace hasp
