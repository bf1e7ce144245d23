#include "Dicom/DecoderProcess.h"
#include "Dicom/DicomSeries.h"
#include "Volumes/VolumeFormat.h"

#include "Grid/ParallelFor.h"

#include "vtkImageData.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
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
    files.push_back({ at->path(), 0, at->file_size(unreadable), {} });
  }
  if (error)
    ThrowFileError(folder, "cannot be listed: " + error.message());
  std::sort(files.begin(), files.end(),
    [](const DicomSlice& a, const DicomSlice& b) { return a.file < b.file; });
  for (std::size_t n = 0; n < files.size(); ++n)
    files[n].number = static_cast<int>(n) + 1;
  return files;
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
  const SliceRecord& r = slice.record;
  if (decoded.rows != r.rows || decoded.columns != r.columns || decoded.isSigned != r.isSigned)
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

vtkSmartPointer<vtkImageData> Load(const std::filesystem::path& folder, const DicomStack& stack,
  const VolumeReadSettings& settings, const ProgressFunction& progress)
{
  auto image = NewImage(stack.passport.geometry, VTK_SHORT);
  auto* stored = static_cast<std::uint16_t*>(image->GetScalarPointer());
  DecoderProcess decoder(DecoderProcess::Mode::Decode, stack.slices, settings);
  std::uint16_t* into = stored;
  for (const DicomSlice& slice : stack.slices)
  {
    const SliceRecord record = decoder.NextRecord(progress);
    CheckDecoded(folder, slice, record);
    decoder.ReadPixels(record, into, progress);
    into += record.pixelBytes / sizeof(std::uint16_t);
  }
  decoder.Finish(progress);
  if (FitsInt16(stack, stored))
  {
    Rescale(stack, stored, reinterpret_cast<std::int16_t*>(stored)); // in place
    return image;
  }
  const glm::ivec3& d = stack.passport.geometry.dims;
  CheckSampleBytes(folder, d.x, d.y, d.z, sizeof(float), settings.memoryLimitBytes);
  auto exact = NewImage(stack.passport.geometry, VTK_FLOAT);
  Rescale(stack, stored, static_cast<float*>(exact->GetScalarPointer()));
  return exact;
}

} // namespace

OpenedVolume OpenDicomFolder(const std::filesystem::path& folder,
  const VolumeReadSettings& settings, const ProgressFunction& progress)
{
  std::vector<DicomSlice> files = ListFiles(folder);
  if (files.empty())
    ThrowFileError(folder, "the folder is empty");
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
  opened.load = [folder, stack, settings](const ProgressFunction& loading)
  { return Load(folder, stack, settings, loading); };
  return opened;
}

} // namespace hasp
