#include "vtkHaspSurfaceFile.h"
#include "Files/FileError.h"
#include "Surfaces/SurfaceFormat.h"
#include "vtkHaspCellFile.h"

#include "vtkPolyData.h"

#include <stdexcept>

namespace hasp
{
namespace
{

using Reader = LoadedSurface (*)(
  const std::filesystem::path&, const SurfaceReadSettings&, const ProgressFunction&);

Reader ReaderOf(const std::filesystem::path& file)
{
  const std::string ending = LowerExtension(file);
  return ending == ".stl"   ? ReadStl
         : ending == ".ply" ? ReadPly
         : ending == ".obj" ? ReadObj
         : ending == ".3mf" ? ReadThreeMf
         : ending == ".vtp" ? ReadVtp
                            : nullptr;
}

void CheckSettings(const SurfaceReadSettings& settings)
{
  for (const double seconds : { settings.decoderSilenceSeconds, settings.decoderTotalSeconds })
    if (!(seconds > 0.0 && seconds <= 1e6))
      throw std::invalid_argument(
        "decoder time limit is " + Text(seconds) + " s, must be in (0, 1000000]");
}

} // namespace

bool IsSurfaceName(const std::string& path)
{
  return ReaderOf(std::filesystem::u8path(path)) != nullptr;
}

LoadedSurface LoadSurface(
  const std::string& path, const SurfaceReadSettings& settings, const ProgressFunction& progress)
{
  CheckSettings(settings);
  if (path.empty())
    throw std::invalid_argument("no file is named");
  const std::filesystem::path file = std::filesystem::u8path(path);
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    ThrowFileError(file, "there is no such file");
  if (!std::filesystem::is_regular_file(status))
    ThrowFileError(
      file, "is no file; surfaces are read from .stl, .ply, .obj, .3mf and .vtp files");
  RefuseCells(path, "triangles");
  const Reader reader = ReaderOf(file);
  if (!reader)
    ThrowFileError(file, "is of no kind that is read: .stl, .ply, .obj, .3mf or .vtp");
  LoadedSurface loaded = reader(file, settings, progress);
  ReportProgress(progress, 1.0);
  return loaded;
}

} // namespace hasp
