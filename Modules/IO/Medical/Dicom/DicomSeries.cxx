#include "Dicom/DicomSeries.h"
#include "Dicom/DicomChecks.h"
#include "Volumes/VolumeFormat.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <stdexcept>

namespace hasp
{
namespace
{

using Series = std::map<std::string, std::vector<DicomSlice>>;

bool Is(const DicomSlice& slice, SliceStatus status)
{
  return slice.record.status == static_cast<std::uint32_t>(status);
}

/// Images by series. What is no image is counted; what is a damaged image is an error, because a
/// slice would go missing with it.
Series Group(const std::filesystem::path& folder, std::vector<DicomSlice>& files, int& skipped)
{
  Series series;
  for (DicomSlice& slice : files)
  {
    if (Is(slice, SliceStatus::Damaged) || Is(slice, SliceStatus::CutOff))
      ThrowFileError(folder,
        SliceName(slice) + " is damaged or cut off; copy it again, or take it out of the folder");
    if (Is(slice, SliceStatus::Undecodable) && slice.record.rows == 0)
      CheckSlice(folder, slice); // throws: not even its header can be read, so it has no series
    if (Is(slice, SliceStatus::NotDicom) || Is(slice, SliceStatus::NoImage))
      ++skipped;
    else
      series[slice.record.series].push_back(std::move(slice));
  }
  if (series.empty())
    ThrowFileError(folder,
      files.empty() ? "the folder is empty"
                    : "none of its " + std::to_string(files.size()) + " files is a DICOM image");
  return series;
}

std::string ListOf(const Series& series)
{
  std::string list;
  int number = 0;
  for (const auto& [uid, slices] : series)
  {
    const SliceRecord& r = slices.front().record;
    const std::string modality = SafeText(r.modality);
    ++number;
    list += (number > 1 ? "; " : "") + std::to_string(number) + ": " +
            (modality.empty() ? "unknown modality" : modality) + ", " +
            std::to_string(slices.size()) + " images of " + std::to_string(r.columns) + " x " +
            std::to_string(r.rows);
  }
  return list;
}

std::vector<DicomSlice> Choose(const std::filesystem::path& folder, Series series, int asked)
{
  const int count = static_cast<int>(series.size());
  if (asked > count)
    ThrowFileError(folder, "series " + std::to_string(asked) + " was asked for, the folder holds " +
                             std::to_string(count) + " (" + ListOf(series) + ")");
  if (asked == 0 && count > 1)
    ThrowFileError(folder, "the folder holds " + std::to_string(count) + " series (" +
                             ListOf(series) +
                             "); choose one by its number (--series, or SetSeries)");
  return std::move(std::next(series.begin(), std::max(asked, 1) - 1)->second);
}

/// int16 for certain if every stored value there can be rescales to a whole number in its range.
bool CertainlyInt16(const std::vector<DicomSlice>& slices)
{
  return std::all_of(slices.begin(), slices.end(),
    [](const DicomSlice& slice)
    {
      const SliceRecord& r = slice.record;
      const double span = std::ldexp(1.0, int(r.bitsStored));
      const double low = r.isSigned ? -span / 2 : 0.0, high = low + span - 1;
      const auto [a, b] =
        std::minmax({ r.slope * low + r.intercept, r.slope * high + r.intercept });
      return r.slope == std::round(r.slope) && r.intercept == std::round(r.intercept) &&
             a >= -32768.0 && b <= 32767.0;
    });
}

void Describe(const std::vector<DicomSlice>& slices, Passport& passport)
{
  const SliceRecord& first = slices.front().record;
  const auto all = [&](std::uint32_t flags)
  {
    return std::all_of(slices.begin(), slices.end(),
      [&](const DicomSlice& s) { return (s.record.flags & flags) == flags; });
  };
  passport.format = "DICOM";
  passport.modality = SafeText(first.modality);
  passport.hounsfield = passport.modality == "CT" && all(HasRescale | RescaleIsHU);
  if (first.flags & Packed)
    passport.compression = SafeText(first.transferSyntax);
  passport.sampleType = CertainlyInt16(slices) ? "int16" : "int16 or float32";
  if (passport.modality == "CT" && !passport.hounsfield)
    passport.warnings.push_back(
      "The CT series says no rescaling to HU: grey values are as stored, and "
      "thresholds in HU do not apply.");
  if (first.flags & Monochrome1)
    passport.warnings.push_back(
      "The series is MONOCHROME1, to be shown inverted; its values are kept.");
  if (std::any_of(slices.begin(), slices.end(),
        [](const DicomSlice& s) { return (s.record.flags & Lossy) != 0; }))
    passport.warnings.push_back("The series was compressed with loss: its values are not exactly "
                                "those that were measured.");
  if (passport.filesSkipped > 0)
    passport.warnings.push_back(std::to_string(passport.filesSkipped) +
                                " files of the folder are no DICOM images and were skipped.");
}

} // namespace

std::string SliceName(const DicomSlice& slice)
{
  std::string name =
    FileNamesShown() ? FileLabel(slice.file) : "file " + std::to_string(slice.number);
  if (slice.record.frameNumber > 0 || slice.record.moreFrames > 0)
    name += " (frame " + std::to_string(slice.record.frameNumber + 1) + ")";
  else if (slice.record.flags & HasInstance)
    name += " (instance " + std::to_string(slice.record.instance) + ")";
  return name;
}

DicomStack StackSeries(const std::filesystem::path& folder, std::vector<DicomSlice> files,
  const VolumeReadSettings& settings)
{
  DicomStack stack;
  Series series = Group(folder, files, stack.passport.filesSkipped);
  stack.passport.seriesFound = static_cast<int>(series.size());
  stack.passport.seriesChosen = std::max(settings.series, 1);
  stack.slices = Choose(folder, std::move(series), settings.series);
  for (const DicomSlice& slice : stack.slices)
    CheckSlice(folder, slice);
  CheckAlike(folder, stack.slices);
  const SliceRecord& first = stack.slices.front().record;
  CheckSampleBytes(folder, first.columns, first.rows,
    static_cast<std::int64_t>(stack.slices.size()), 2, settings.memoryLimitBytes);
  stack.passport.geometry = SortAndMeasure(folder, stack.slices, stack.passport.gapDeviationMm);
  Describe(stack.slices, stack.passport);
  return stack;
}

} // namespace hasp
