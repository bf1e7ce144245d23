#pragma once
#include "Surfaces/SurfaceBuilder.h"

class vtkPolyData;

/// One reader and one writer per format; LoadSurface and WriteSurface pick. Internal to IOMedical.
namespace hasp
{

class AtomicFile;

LoadedSurface ReadStl(const std::filesystem::path& file, const SurfaceReadSettings& settings,
  const ProgressFunction& progress);
LoadedSurface ReadPly(const std::filesystem::path& file, const SurfaceReadSettings& settings,
  const ProgressFunction& progress);
LoadedSurface ReadObj(const std::filesystem::path& file, const SurfaceReadSettings& settings,
  const ProgressFunction& progress);
LoadedSurface ReadThreeMf(const std::filesystem::path& file, const SurfaceReadSettings& settings,
  const ProgressFunction& progress);
LoadedSurface ReadVtp(const std::filesystem::path& file, const SurfaceReadSettings& settings,
  const ProgressFunction& progress);

} // namespace hasp
