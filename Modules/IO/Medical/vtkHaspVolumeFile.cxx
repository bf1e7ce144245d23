#include "vtkHaspVolumeFile.h"
#include "Cells/CellFile.h"
#include "Volumes/VolumeFormat.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspVolumeHash.h"
#include "vtkHaspVolumeView.h"

#include "Grid/GreyLevels.h"
#include "Grid/ParallelFor.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace hasp
{
namespace
{

void CheckSettings(const VolumeReadSettings& s)
{
  if (s.series < 0)
    throw std::invalid_argument("series is " + std::to_string(s.series) + ", must be >= 0");
  if (s.layer < 0)
    throw std::invalid_argument("layer is " + std::to_string(s.layer) + ", must be >= 0");
  for (const double seconds : { s.decoderSilenceSeconds, s.decoderTotalSeconds })
    if (!(seconds > 0.0 && seconds <= 1e6))
      throw std::invalid_argument(
        "decoder time limit is " + Text(seconds) + " s, must be in (0, 1000000]");
}

bool IsOneDicomFile(const std::filesystem::path& file)
{
  char start[132] = {};
  std::ifstream stream(file, std::ios::binary);
  stream.read(start, sizeof(start));
  return stream.gcount() == sizeof(start) && std::string(start + 128, 4) == "DICM";
}

/// What one slice holds. Slots of their own, so that the result does not depend on threads.
struct SliceRange
{
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();
  std::size_t notFinite = 0, firstNotFinite = 0;
};

template <typename T>
std::vector<SliceRange> RangesOf(const GridView<const T>& grid)
{
  const glm::ivec3& dims = grid.geometry.dims;
  std::vector<SliceRange> ranges(dims.z);
  const std::size_t inSlice = std::size_t(dims.x) * dims.y;
  ParallelFor(0, dims.z, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        SliceRange& range = ranges[k];
        const T* slice = grid.data + k * inSlice;
        for (std::size_t n = 0; n < inSlice; ++n)
        {
          if constexpr (std::is_same_v<T, float>)
            if (!std::isfinite(slice[n]))
            {
              if (range.notFinite++ == 0)
                range.firstNotFinite = n;
              continue;
            }
          range.minimum = std::min(range.minimum, double(slice[n]));
          range.maximum = std::max(range.maximum, double(slice[n]));
        }
      }
    });
  return ranges;
}

void CompletePassport(
  const std::filesystem::path& file, const AnyGridView& grid, Passport& passport)
{
  const auto ranges = std::visit([](const auto& view) { return RangesOf(view); }, grid);
  const int rowLength = GeometryOf(grid).dims.x;
  std::size_t notFinite = 0;
  std::string first;
  passport.minimum = std::numeric_limits<double>::infinity();
  passport.maximum = -passport.minimum;
  for (std::size_t k = 0; k < ranges.size(); ++k)
  {
    const SliceRange& range = ranges[k];
    if (range.notFinite > 0 && notFinite == 0)
      first = std::to_string(range.firstNotFinite % rowLength) + ", " +
              std::to_string(range.firstNotFinite / rowLength) + ", " + std::to_string(k);
    notFinite += range.notFinite;
    passport.minimum = std::min(passport.minimum, range.minimum);
    passport.maximum = std::max(passport.maximum, range.maximum);
  }
  if (notFinite > 0)
    ThrowFileError(file, "holds " + std::to_string(notFinite) +
                           " samples that are NaN or infinite, the first at index (" + first +
                           "); replace them by numbers before opening it");
}

/// Headers of cone beam scanners say what CT's say, so the samples may deny it.
void AskSamplesForHounsfield(const AnyGridView& grid, Passport& passport)
{
  if (!passport.hounsfield)
    return;
  const GreyLevels levels = FindGreyLevels(grid);
  passport.airLevel = levels.air;
  passport.softTissueLevel = levels.softTissue;
  if (!levels.DeniesHounsfield())
    return;
  passport.hounsfield = false;
  const bool air = levels.airIsElsewhere;
  passport.warnings.push_back(
    "The file says HU, its samples do not: " + std::string(air ? "air" : "soft tissue") +
    " lies at about " + Text(std::round(air ? *levels.air : *levels.softTissue)) +
    (air ? ", not at -1000" : ", not at 40") +
    ", as in cone beam CT. Thresholds in HU do not apply.");
}

OpenedVolume OpenByKind(const std::filesystem::path& file, const VolumeReadSettings& settings,
  const ProgressFunction& progress)
{
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    ThrowFileError(file, "there is no such file or folder");
  if (std::filesystem::is_directory(status))
    return OpenDicomFolder(file, settings, progress);
  if (!std::filesystem::is_regular_file(status))
    ThrowFileError(file, "is neither a file nor a folder");
  const std::string extension = LowerExtension(file);
  if (extension == ".inv3")
    return OpenInvesalius(file, settings);
  if (extension == ".mha" || extension == ".mhd")
    return OpenMetaImage(file, settings);
  if (extension == ".nrrd" || extension == ".nhdr")
    return OpenNrrd(file, settings);
  if (extension == ".seg.nrrd")
    return OpenSegmentation(file, settings);
  if (extension == ".nii" || extension == ".nii.gz")
    return OpenNifti(file, settings);
  if (extension == ".hdr" || extension == ".img")
    ThrowFileError(file, "pairs of .hdr and .img are not read; save it as a single .nii file");
  if (extension == ".vti")
    return OpenXMLImage(file, settings);
  if (extension == ".hcells")
    ThrowIsNoCells(file);
  if (extension == ".stl" || extension == ".ply" || extension == ".obj" || extension == ".vtp")
    ThrowFileError(file, "is a surface, and a volume is read here; hasp info and hasp convert take "
                         "surfaces, and any viewer of such files draws them");
  if (IsOneDicomFile(file))
    ThrowFileError(file, "is a single DICOM file; open the folder that holds the whole series");
  ThrowFileError(file,
    "is of no kind that is read: volumes are folders of DICOM slices, .inv3, .mha, .mhd, .nrrd, "
    ".nhdr, .seg.nrrd, .nii, .nii.gz or .vti, active cells .hcells, surfaces .stl, .ply, .obj or "
    ".vtp");
}

} // namespace

OpenedVolume OpenVolume(
  const std::string& path, const VolumeReadSettings& settings, const ProgressFunction& progress)
{
  CheckSettings(settings);
  if (path.empty())
    throw std::invalid_argument("no file or folder is named");
  const std::filesystem::path file = std::filesystem::u8path(path);
  RefuseCells(path, "volume");
  OpenedVolume opened = OpenByKind(file, settings, progress);
  if (settings.series > opened.passport.seriesFound)
    ThrowFileError(file, "series " + std::to_string(settings.series) +
                           " was asked for, but only a folder of DICOM slices has several");
  if (settings.layer > 0 && opened.segments.empty())
    ThrowFileError(file, "layer " + std::to_string(settings.layer) +
                           " was asked for, but only a segmentation (.seg.nrrd) has layers with "
                           "segments");
  opened.file = path;
  opened.hash = settings.hash;
  opened.memoryLimitBytes = settings.memoryLimitBytes;
  return opened;
}

LoadedVolume LoadVolume(const OpenedVolume& opened, const ProgressFunction& progress)
{
  LoadedVolume volume{ opened.passport, {}, opened.segments };
  volume.image = opened.load(progress, volume.passport);
  const AnyGridView grid = ViewImage(volume.image);
  volume.passport.sampleType = SampleTypeName(volume.image->GetScalarType());
  CompletePassport(std::filesystem::u8path(opened.file), grid, volume.passport);
  AskSamplesForHounsfield(grid, volume.passport);
  if (opened.hash)
    volume.passport.hash = VolumeHash(grid);
  if (opened.hash && volume.passport.hash.empty())
    volume.passport.warnings.push_back(
      "There is no hash: this build of Hasp was made without OpenSSL (HASP_ENABLE_OPENSSL).");
  ReportProgress(progress, 1.0);
  return volume;
}

Passport InspectVolume(
  const std::string& path, const VolumeReadSettings& settings, const ProgressFunction& progress)
{
  CheckSettings(settings);
  if (path.empty())
    throw std::invalid_argument("no file or folder is named");
  Passport known;
  try
  {
    const OpenedVolume opened = OpenVolume(path, settings, progress);
    known = opened.passport;
    return LoadVolume(opened, progress).passport;
  }
  catch (const ImportError& error)
  {
    return *error.passport;
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception& error) // of a reader that knows one sentence only
  {
    std::string text = error.what();
    const std::string label = FileLabel(std::filesystem::u8path(path)) + ": ";
    if (text.rfind(label, 0) == 0)
      text.erase(0, label.size());
    known.faults.emplace_back(FaultKind::Damaged, text);
    return known;
  }
}

} // namespace hasp
