#include "vtkHaspLabelFile.h"
#include "Volumes/SampleFile.h"
#include "Volumes/VolumeFormat.h"
#include "vtkHaspVolumeView.h"

#include "Grid/LabelGrid.h"
#include "Grid/ParallelFor.h"
#include "Grid/ProgressPart.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace hasp
{
namespace
{

constexpr double LoadingShare = 0.8; ///< of the work

/// What the header alone tells.
void RefuseScans(const std::filesystem::path& file, const OpenedVolume& opened)
{
  const std::string& format = opened.passport.format;
  if (format == "DICOM" || format == "InVesalius")
    ThrowFileError(file, "is a scan, and labels are read here: .seg.nrrd, .nrrd, .mha, .nii, "
                         ".nii.gz or .vti");
  const SampleFile* samples = opened.samples.get();
  const bool floating =
    samples && (samples->type == StoredType::Float32 || samples->type == StoredType::Float64);
  if (floating || opened.passport.sampleType == "float32")
    ThrowFileError(file, "holds samples in floating point, labels must be whole numbers in [0, "
                         "65535]; save it as a label map");
  if (samples && (samples->slope != 1.0 || samples->intercept != 0.0))
    ThrowFileError(file, "rescales its samples, and labels must be stored as they are; save it as "
                         "a label map");
}

void CheckRange(const std::filesystem::path& file, const Passport& passport)
{
  // Whole numbers beyond 16 bits were loaded as float32.
  if (passport.minimum < 0.0 || passport.maximum > 65535.0)
    ThrowFileError(file, "holds samples from " + Text(passport.minimum) + " to " +
                           Text(passport.maximum) +
                           ", labels must be whole numbers in [0, 65535]: is it a scan?");
}

vtkSmartPointer<vtkImageData> AsLabels(vtkImageData* image)
{
  const AnyGridView grid = ViewImage(image);
  if (std::holds_alternative<GridView<const std::uint16_t>>(grid))
    return image;
  auto labels = NewImage(GeometryOf(grid), VTK_UNSIGNED_SHORT);
  auto* into = static_cast<std::uint16_t*>(labels->GetScalarPointer());
  std::visit(
    [&](const auto& view)
    {
      ParallelFor(0, static_cast<std::int64_t>(view.geometry.Size()), 1 << 20,
        [&](std::int64_t first, std::int64_t last)
        {
          std::transform(view.data + first, view.data + last, into + first,
            [](auto sample) { return static_cast<std::uint16_t>(sample); });
        });
    },
    grid);
  return labels;
}

vtkSmartPointer<vtkImageData> PutOnto(const std::filesystem::path& file, vtkImageData* image,
  const GridGeometry& scan, const ProgressFunction& progress)
{
  const auto* first = static_cast<const std::uint16_t*>(image->GetScalarPointer());
  const GridView<const std::uint16_t> labels{ first, ImageGeometry(image) };
  auto placed = NewImage(scan, VTK_UNSIGNED_SHORT);
  try
  {
    PlaceLabels(FileLabel(file).c_str(), labels,
      { static_cast<std::uint16_t*>(placed->GetScalarPointer()), scan }, progress);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error(error.what()); // the file's fault, as all that is found in it
  }
  return placed;
}

LabelTable TableOf(const std::vector<Segment>& segments)
{
  LabelTable table;
  for (const Segment& segment : segments)
  {
    LabelEntry entry{ static_cast<std::uint16_t>(segment.labelValue), segment.name };
    for (int c = 0; c < 3; ++c)
      entry.colour[c] = static_cast<std::uint8_t>(std::lround(255.0 * segment.color[c]));
    entry.bone = segment.bone;
    table.push_back(entry);
  }
  return table;
}

std::vector<Segment> SegmentsOf(const LabelTable& table)
{
  std::vector<Segment> segments;
  for (const LabelEntry& entry : table)
  {
    Segment segment{ entry.value, entry.name };
    for (int c = 0; c < 3; ++c)
      segment.color[c] = entry.colour[c] / 255.0;
    segment.bone = entry.bone;
    segments.push_back(segment);
  }
  return segments;
}

} // namespace

LoadedLabels LoadLabels(const OpenedVolume& opened, const std::optional<GridGeometry>& onto,
  const ProgressFunction& progress)
{
  const std::filesystem::path file = std::filesystem::u8path(opened.file);
  RefuseScans(file, opened);
  for (const GridGeometry& grid :
    { opened.passport.geometry, onto.value_or(opened.passport.geometry) })
    CheckSampleBytes(
      file, grid.dims.x, grid.dims.y, grid.dims.z, sizeof(std::uint16_t), opened.memoryLimitBytes);
  const LoadedVolume volume = LoadVolume(opened, PartOf(progress, 0.0, LoadingShare));
  CheckRange(file, volume.passport);
  LoadedLabels labels{ volume.passport, AsLabels(volume.image), TableOf(volume.segments) };
  if (onto)
    labels.image = PutOnto(file, labels.image, *onto, PartOf(progress, LoadingShare, 1.0));
  ReportProgress(progress, 1.0);
  return labels;
}

void WriteLabels(vtkImageData* labels, const LabelTable& table, const std::string& path,
  const SegmentationWriteSettings& settings, const ProgressFunction& progress)
{
  const AnyGridView grid = ViewImage(labels);
  const std::string ending = LowerExtension(std::filesystem::u8path(path));
  const auto write = [&](const auto& view)
  {
    if (ending == ".seg.nrrd")
      WriteSegmentation(
        labels, SegmentsOf(WithUnnamedLabels(table, LabelsOf(view))), path, settings, progress);
    else // compression is a choice in .nrrd alone
      WriteVolume(labels, path, { settings.compress && ending == ".nrrd" });
  };
  if (const auto* wide = std::get_if<GridView<const std::uint16_t>>(&grid))
    write(*wide);
  else if (const auto* narrow = std::get_if<GridView<const std::uint8_t>>(&grid))
    write(*narrow);
  else
    throw std::invalid_argument("labels are " + SampleTypeName(labels->GetScalarType()) +
                                ", must be uint8 or uint16; cast them");
}

} // namespace hasp
