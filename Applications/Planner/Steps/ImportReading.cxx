#include "Steps/ImportReading.h"

#include "Steps/LabelMaps.h"

#include "Grid/ProgressPart.h"
#include "vtkHaspLabelFile.h"
#include "vtkHaspSurfaceHash.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace hasp
{
namespace
{
constexpr std::size_t FewValues = 64; ///< a label map has fewer, a scan's grey values are more
constexpr char Segmentation[] = "NRRD segmentation";

/// Whole numbers from 0 on, and few different ones.
bool LooksLikeLabels(const AnyGridView& samples)
{
  return std::visit(
    []<typename T>(const GridView<const T>& view)
    {
      if constexpr (std::is_integral_v<T>)
      {
        std::vector<bool> seen(65536);
        std::size_t count = 0;
        for (std::size_t n = 0; n < view.geometry.Size(); ++n)
        {
          if (std::is_signed_v<T> && view.data[n] < 0)
            return false;
          const auto value = static_cast<std::uint16_t>(view.data[n]);
          count += !seen[value];
          seen[value] = true;
          if (count > FewValues)
            return false;
        }
        return true;
      }
      else
        return false;
    },
    samples);
}

Imported ReadSurfaceFile(const ImportRequest& request, const ProgressFunction& progress)
{
  LoadedSurface loaded = LoadSurface(request.path, {}, PartOf(progress, 0.0, 0.8));
  ImportedSurface surface;
  surface.mesh = std::make_shared<const TriangleMesh>(MakeTriangleMesh(loaded.surface));
  surface.hash = SurfaceHash(*surface.mesh);
  ReportProgress(progress, 0.9);
  surface.check = CheckMesh(WeldPoints(*surface.mesh));
  surface.passport = std::move(loaded.passport);
  SurfaceShelf::Keep(request.keepSurfacesIn, surface.hash, *surface.mesh);
  return surface;
}

Imported ReadLabelFile(
  const ImportRequest& request, const OpenedVolume& opened, const ProgressFunction& progress)
{
  if (!request.scan)
    throw std::runtime_error("it is a segmentation, and there is no scan that it could be of: "
                             "import its scan first");
  LoadedLabels loaded = LoadLabels(opened, request.scan, PartOf(progress, 0.5, 0.8));
  ImportedLabels labels;
  labels.volume = request.volume;
  const std::vector<std::uint16_t> present =
    LabelsOf(std::get<GridView<const std::uint16_t>>(ViewImage(loaded.image)));
  if (present.empty())
    throw std::runtime_error("the label map is empty: no voxel of the scan has a label");
  for (const LabelEntry& entry : WithUnnamedLabels(loaded.table, present))
    if (std::binary_search(present.begin(), present.end(), entry.value))
      labels.present.push_back(entry);
  labels.blob = StoreLabelMap(request.blobs, loaded.image);
  labels.passport = std::move(loaded.passport);
  return labels;
}

Imported ReadVolumeFile(const ImportRequest& request, const ProgressFunction& progress)
{
  VolumeReadSettings settings = request.settings;
  settings.hash = true;
  const OpenedVolume opened = OpenVolume(request.path, settings, PartOf(progress, 0.0, 0.3));
  if (opened.passport.format == Segmentation)
    return ReadLabelFile(request, opened, progress);
  LoadedVolume loaded = LoadVolume(opened, PartOf(progress, 0.3, 0.9));
  const bool isLabels = LooksLikeLabels(ViewImage(loaded.image));
  if (isLabels && request.scan)
    return ReadLabelFile(request, opened, progress);
  if (isLabels)
    loaded.passport.warnings.emplace_back(
      "It has at most 64 different values, whole numbers from 0 on, as a label map has: if it is "
      "one, import its scan first, and then this file.");
  ImportedScan scan{ { loaded.image, std::move(loaded.passport) } };
  ScanShelf::Keep(request.keepIn, scan.scan);
  return scan;
}

} // namespace

Imported ReadImport(const ImportRequest& request, const ProgressFunction& progress)
{
  try
  {
    return IsSurfaceName(request.path) ? ReadSurfaceFile(request, progress)
                                       : ReadVolumeFile(request, progress);
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const ImportError& error)
  {
    return RefusedScan{ *error.passport };
  }
  catch (const std::runtime_error& error)
  {
    return RefusedFile{ error.what() };
  }
}

} // namespace hasp
