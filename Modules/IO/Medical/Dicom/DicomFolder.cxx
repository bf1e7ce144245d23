#include "Dicom/DecoderProcess.h"
#include "Dicom/DicomSeries.h"
#include "Volumes/VolumeFormat.h"
#include "vtkHaspVolumeView.h"

#include "Grid/ParallelFor.h"

#include "vtkImageData.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr std::size_t FileLimit = 100000;

/// All files below the folder, in the order of their paths. Links to folders are not followed.
std::vector<DicomSlice> ListFiles(const std::filesystem::path& folder)
{
  std::vector<DicomSlice> files;
  std::error_code error;
  std::filesystem::recursive_directory_iterator at(folder, error), end;
  for (; !error && at != end; at.increment(error))
  {
    std::error_code unreadable;
    if (!at->is_regular_file(unreadable))
      continue;
    if (files.size() == FileLimit)
      ThrowFileError(folder,
        "holds more than " + std::to_string(FileLimit) + " files; open the folder of one series");
    const auto bytes = at->file_size(unreadable); // gone meanwhile: its child will say so
    files.push_back({ at->path(), 0, unreadable ? 0 : bytes, {} });
  }
  if (error)
    ThrowFileError(folder, "cannot be listed: " + error.message());
  std::sort(files.begin(), files.end(),
    [](const DicomSlice& a, const DicomSlice& b) { return a.file < b.file; });
  for (std::size_t n = 0; n < files.size(); ++n)
    files[n].number = static_cast<int>(n) + 1;
  return files;
}

/// The part [from, to] of a longer work's progress.
ProgressFunction Part(const ProgressFunction& progress, double from, double to)
{
  if (!progress)
    return {};
  return [=](double share) { return progress(from + share * (to - from)); };
}

/// Whether two headers lead to the same samples at the same places. Their numbers are finite.
bool MeanTheSame(const SliceRecord& a, const SliceRecord& b)
{
  return a.rows == b.rows && a.columns == b.columns && a.isSigned == b.isSigned &&
         a.bitsStored == b.bitsStored && a.highBit == b.highBit && a.slope == b.slope &&
         a.intercept == b.intercept && std::ranges::equal(a.spacing, b.spacing) &&
         std::ranges::equal(a.position, b.position) &&
         std::ranges::equal(a.orientation, b.orientation) && std::strcmp(a.series, b.series) == 0;
}

/// A decoded slice must be what its header promised when the volume was laid out.
void CheckDecoded(
  const std::filesystem::path& folder, const DicomSlice& slice, const SliceRecord& decoded)
{
  const auto fail = [&](const std::string& what)
  { ThrowFileError(folder, SliceName(slice) + " " + what); };
  if (decoded.status == static_cast<std::uint32_t>(SliceStatus::Undecodable))
    fail("cannot be decompressed; convert the series first, say with gdcmconv --raw");
  if (decoded.status != static_cast<std::uint32_t>(SliceStatus::Image))
    fail("is damaged or cut off: it holds fewer pixels than it declares. Copy it again");
  if (!MeanTheSame(slice.record, decoded))
    fail("changed while it was read; open the folder again");
}

/// Stored 16-bit values of slice k become slope * value + intercept.
template <typename Use>
void ForEachRescaled(
  const DicomStack& stack, const std::uint16_t* stored, std::size_t k, const Use& use)
{
  const SliceRecord& r = stack.slices[k].record;
  const std::size_t inSlice = std::size_t(r.rows) * r.columns, first = k * inSlice;
  for (std::size_t n = first; n < first + inSlice; ++n)
  {
    const double value = r.isSigned ? double(static_cast<std::int16_t>(stored[n])) : stored[n];
    use(n, r.slope * value + r.intercept);
  }
}

bool FitsInt16(const DicomStack& stack, const std::uint16_t* stored)
{
  std::vector<char> fits(stack.slices.size(), 1); // a slot per slice, as threads must not share
  ParallelFor(0, static_cast<std::int64_t>(fits.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
        ForEachRescaled(stack, stored, k,
          [&](std::size_t, double v)
          {
            if (!(v >= -32768.0 && v <= 32767.0 && v == std::nearbyint(v)))
              fits[k] = 0;
          });
    });
  return std::find(fits.begin(), fits.end(), 0) == fits.end();
}

template <typename T>
void Rescale(const DicomStack& stack, const std::uint16_t* stored, T* into)
{
  ParallelFor(0, static_cast<std::int64_t>(stack.slices.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
        ForEachRescaled(
          stack, stored, k, [&](std::size_t n, double v) { into[n] = static_cast<T>(v); });
    });
}

/// A slice at the place of another is left out if it is the same picture; which of two pictures is
/// the right one, nobody can say here.
void CheckDoubles(const std::filesystem::path& folder, const DicomStack& stack,
  const std::uint16_t* stored, DecoderProcess& decoder, const ProgressFunction& progress)
{
  std::vector<std::uint16_t> copy;
  for (const DoubledSlice& doubled : stack.doubles)
  {
    const SliceRecord record = decoder.NextRecord(progress);
    CheckDecoded(folder, doubled.slice, record);
    copy.resize(record.pixelBytes / sizeof(std::uint16_t));
    decoder.ReadPixels(record, copy.data(), progress);
    if (std::equal(copy.begin(), copy.end(), stored + doubled.of * copy.size()))
      continue;
    Passport known = stack.passport;
    known.resampled.reset();
    known.faults.emplace_back(FaultKind::DoubledSlices,
      SliceName(stack.slices[doubled.of]) + " and " + SliceName(doubled.slice) +
        " lie at the same place and are different pictures; take one of them out of the folder");
    known.faults.back().files = { doubled.slice.number };
    throw ImportError(folder, std::move(known));
  }
}

/// The series as it is stored: 16 bits a sample, to be rescaled.
vtkSmartPointer<vtkImageData> Decode(const std::filesystem::path& folder, const DicomStack& stack,
  const GridGeometry& geometry, const VolumeReadSettings& settings,
  const ProgressFunction& progress)
{
  auto image = NewImage(geometry, VTK_SHORT);
  auto* stored = static_cast<std::uint16_t*>(image->GetScalarPointer());
  std::vector<DicomSlice> files = stack.slices;
  for (const DoubledSlice& doubled : stack.doubles)
    files.push_back(doubled.slice);
  DecoderProcess decoder(DecoderProcess::Mode::Decode, files, settings);
  std::uint16_t* into = stored;
  for (const DicomSlice& slice : stack.slices)
  {
    const SliceRecord record = decoder.NextRecord(progress);
    CheckDecoded(folder, slice, record);
    decoder.ReadPixels(record, into, progress);
    into += record.pixelBytes / sizeof(std::uint16_t);
  }
  CheckDoubles(folder, stack, stored, decoder, progress);
  decoder.Finish(progress);
  return image;
}

/// int16 where that holds every value, else float.
vtkSmartPointer<vtkImageData> Rescaled(const std::filesystem::path& folder, const DicomStack& stack,
  vtkSmartPointer<vtkImageData> image, const VolumeReadSettings& settings)
{
  auto* stored = static_cast<std::uint16_t*>(image->GetScalarPointer());
  if (FitsInt16(stack, stored))
  {
    Rescale(stack, stored, reinterpret_cast<std::int16_t*>(stored)); // in place
    return image;
  }
  const GridGeometry g = ImageGeometry(image);
  const int slices = stack.plan ? g.dims.z + stack.plan->geometry.dims.z : g.dims.z;
  const glm::ivec3 most = stack.plan ? stack.plan->geometry.dims : g.dims;
  CheckSampleBytes(folder, most.x, most.y, slices, sizeof(float), settings.memoryLimitBytes);
  auto exact = NewImage(g, VTK_FLOAT);
  Rescale(stack, stored, static_cast<float*>(exact->GetScalarPointer()));
  return exact;
}

std::string SayResampled(const ResampleRecord& r, int doubles)
{
  std::string did;
  const auto add = [&](const std::string& what) { did += (did.empty() ? "" : ", ") + what; };
  if (r.tiltDegrees > 0.0)
    add("a tilt of " + Text(std::round(10.0 * r.tiltDegrees) / 10.0) + " degrees was rectified");
  if (r.slicesMade > 0)
    add(std::to_string(r.slicesMade) + " of " + std::to_string(r.slicesMade + r.slicesCopied) +
        " slices were made, up to " + Millimetres(r.farthestMm) + " from a measured one");
  if (doubles > 0)
    add(std::to_string(doubles) + (doubles == 1 ? " copy of a slice was" : " copies were") +
        " left out");
  const auto mm = [](double error) { return Text(std::round(100.0 * error) / 100.0) + " mm"; };
  if (!r.errorKnown)
    return "Resampled: " + did + ". By how much surfaces are off could not be measured.";
  if (r.edgesJudged == 0)
    return "Resampled: " + did + ". No sample is other than measured.";
  return "Resampled: " + did + ". Surfaces are off by " + mm(r.error50) + " (half of them) to " +
         mm(r.error95) + " (95 %), measured on the series itself.";
}

vtkSmartPointer<vtkImageData> Mended(const ResamplePlan& plan, vtkImageData* measured,
  Passport& passport, const ProgressFunction& progress)
{
  auto image = NewImage(plan.geometry, measured->GetScalarType());
  const auto resample = [&](auto* samples)
  {
    return Resample(
      plan, samples, static_cast<decltype(samples)>(image->GetScalarPointer()), progress);
  };
  passport.resampled = measured->GetScalarType() == VTK_SHORT
                         ? resample(static_cast<std::int16_t*>(measured->GetScalarPointer()))
                         : resample(static_cast<float*>(measured->GetScalarPointer()));
  passport.warnings.push_back(SayResampled(*passport.resampled, passport.doubledSlices));
  return image;
}

vtkSmartPointer<vtkImageData> Load(const std::filesystem::path& folder, const DicomStack& stack,
  const VolumeReadSettings& settings, const ProgressFunction& progress, Passport& passport)
{
  if (!stack.plan)
    return Rescaled(
      folder, stack, Decode(folder, stack, stack.passport.geometry, settings, progress), settings);
  GridGeometry measured = stack.passport.geometry; // a place for the slices, not where they lie
  measured.dims = { stack.layout.dims, int(stack.slices.size()) };
  const auto slices = Rescaled(
    folder, stack, Decode(folder, stack, measured, settings, Part(progress, 0.0, 0.6)), settings);
  return Mended(*stack.plan, slices, passport, Part(progress, 0.6, 1.0));
}

} // namespace

OpenedVolume OpenDicomFolder(const std::filesystem::path& folder,
  const VolumeReadSettings& settings, const ProgressFunction& progress)
{
  std::vector<DicomSlice> files = ListFiles(folder);
  if (files.empty())
    ThrowFileError(folder, "it is empty; give the folder that holds the slices");
  {
    DecoderProcess decoder(DecoderProcess::Mode::Scan, files, settings);
    std::vector<DicomSlice> slices;
    for (const DicomSlice& file : files)
      do
      {
        if (slices.size() == FileLimit)
          ThrowFileError(folder, "holds more than " + std::to_string(FileLimit) + " slices");
        slices.push_back(file);
        slices.back().record = decoder.NextRecord(progress);
      } while (slices.back().record.moreFrames > 0);
    decoder.Finish(progress);
    files = std::move(slices);
  }
  OpenedVolume opened;
  const DicomStack stack = StackSeries(folder, std::move(files), settings);
  opened.passport = stack.passport;
  opened.load = [folder, stack, settings](const ProgressFunction& loading, Passport& passport)
  { return Load(folder, stack, settings, loading, passport); };
  return opened;
}

} // namespace hasp
