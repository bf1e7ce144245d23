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

[[noreturn]] void Refuse(
  const std::filesystem::path& folder, Passport& passport, FaultKind kind, const std::string& text)
{
  passport.faults.emplace_back(kind, text);
  throw ImportError(folder, std::move(passport));
}

/// Images by series. What is no image is counted; what is a damaged image is a fault, because a
/// slice would go missing with it.
Series Group(
  const std::filesystem::path& folder, std::vector<DicomSlice>& files, Passport& passport)
{
  Series series;
  const std::size_t count = files.size();
  ImportFault damaged;
  std::string first;
  std::vector<DicomSlice> headless;
  for (DicomSlice& slice : files)
  {
    if (Is(slice, SliceStatus::Damaged) || Is(slice, SliceStatus::CutOff))
    {
      if (damaged.files.empty())
        first = SliceName(slice);
      damaged.files.push_back(slice.number);
    }
    else if (Is(slice, SliceStatus::Undecodable) && slice.record.rows == 0)
      headless.push_back(std::move(slice)); // its header cannot be read either: it has no series
    else if (Is(slice, SliceStatus::NotDicom) || Is(slice, SliceStatus::NoImage))
      ++passport.filesSkipped;
    else
      series[slice.record.series].push_back(std::move(slice));
  }
  if (const std::size_t more = damaged.files.size(); more > 0)
  {
    damaged.text = first + (more > 1 ? " and " + std::to_string(more - 1) + " more are" : " is") +
                   " damaged or cut off; copy " + (more > 1 ? "them" : "it") +
                   " again, or out of the folder";
    passport.faults.push_back(damaged);
  }
  CheckEach(headless, passport.faults);
  passport.seriesFound = static_cast<int>(series.size());
  if (series.empty() && passport.faults.empty())
    Refuse(folder, passport, FaultKind::Damaged,
      count == 0 ? "it is empty"
                 : "none of its " + std::to_string(count) + " files is a DICOM image");
  if (series.empty())
    throw ImportError(folder, std::move(passport));
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

std::vector<DicomSlice> Choose(
  const std::filesystem::path& folder, Series series, int asked, Passport& passport)
{
  const int count = static_cast<int>(series.size());
  if (asked > count)
    Refuse(folder, passport, FaultKind::MixedSeries,
      "series " + std::to_string(asked) + " was asked for, the folder holds " +
        std::to_string(count) + " (" + ListOf(series) + ")");
  if (asked == 0 && count > 1)
    Refuse(folder, passport, FaultKind::MixedSeries,
      "the folder holds " + std::to_string(count) + " series (" + ListOf(series) +
        "); choose one by its number (--series, or SetSeries)");
  passport.seriesChosen = std::max(asked, 1);
  return std::move(std::next(series.begin(), passport.seriesChosen - 1)->second);
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

/// What the headers say of the picture, and what its user should know of it.
void Describe(const std::vector<DicomSlice>& slices, Passport& passport)
{
  const SliceRecord& first = slices.front().record;
  const auto all = [&](std::uint32_t flags)
  {
    return std::all_of(slices.begin(), slices.end(),
      [&](const DicomSlice& s) { return (s.record.flags & flags) == flags; });
  };
  const auto any = [&](std::uint32_t flag)
  {
    return std::any_of(slices.begin(), slices.end(),
      [&](const DicomSlice& s) { return (s.record.flags & flag) != 0; });
  };
  passport.modality = SafeText(first.modality);
  passport.hounsfield = passport.modality == "CT" && all(HasRescale | RescaleIsHU);
  passport.transferSyntax = SafeText(first.transferSyntax);
  if (first.flags & Packed)
    passport.compression = passport.transferSyntax;
  passport.sampleType = CertainlyInt16(slices) ? "int16" : "int16 or float32";
  passport.photometric = first.flags & Monochrome1   ? "MONOCHROME1"
                         : first.flags & Monochrome2 ? "MONOCHROME2"
                                                     : "";
  passport.burnedIn = any(SaysBurnedIn) ? "yes" : all(SaysNotBurnedIn) ? "no" : "";
  passport.lossy = any(Lossy);
  passport.patientPosition = SafeText(first.patientPosition);
  if (first.flags & HasThickness && std::isfinite(first.thickness))
    passport.thicknessMm = first.thickness;
  if (first.flags & HasKVP && std::isfinite(first.kvp))
    passport.kvp = first.kvp;
  if (first.flags & HasPadding)
    passport.paddingValue = first.slope * first.padding + first.intercept;
  if (first.flags & HasGantryTilt && std::isfinite(first.gantryTilt))
    passport.tiltTagDegrees = first.gantryTilt;
  if (passport.modality == "CT" && !passport.hounsfield)
    passport.warnings.push_back(
      "The CT series says no rescaling to HU: grey values are as stored, and "
      "thresholds in HU do not apply.");
  if (first.flags & Monochrome1)
    passport.warnings.push_back(
      "The series is MONOCHROME1, to be shown inverted; its values are kept.");
  if (passport.lossy)
    passport.warnings.push_back("The series was compressed with loss: its values are not exactly "
                                "those that were measured.");
  if (passport.burnedIn == "yes")
    passport.warnings.push_back("Text is burned into the pictures, as the series says. It may name "
                                "the patient: look at every slice before you hand anything on.");
  // CT and MR come from the scanner without text, and most of them do not say so. Others may have
  // been screens.
  else if (passport.burnedIn.empty() && passport.modality != "CT" && passport.modality != "MR")
    passport.warnings.push_back(
      "The series does not say whether text is burned into its pictures.");
  if (passport.filesSkipped > 0)
    passport.warnings.push_back(std::to_string(passport.filesSkipped) +
                                " files of the folder are no DICOM images and were skipped.");
}

/// Equal rescalings one after the other. After sorting.
std::vector<RescaleRun> RescaleRuns(const std::vector<DicomSlice>& slices)
{
  std::vector<RescaleRun> runs;
  for (int k = 0; k < static_cast<int>(slices.size()); ++k)
  {
    const SliceRecord& r = slices[k].record;
    if (runs.empty() || runs.back().slope != r.slope || runs.back().intercept != r.intercept)
      runs.push_back({ k + 1, k + 1, r.slope, r.intercept });
    runs.back().lastSlice = k + 1;
  }
  return runs;
}

/// The tag and the stack should agree, whatever sign the scanner's maker gives the tag.
void CompareTilts(Passport& passport)
{
  if (!passport.tiltTagDegrees || passport.tiltDegrees > 0.0)
    return;
  const double said = std::abs(*passport.tiltTagDegrees);
  if (said > 0.5 && passport.modality == "CT") // degrees; tags are rounded, and of planned values
    passport.warnings.push_back(
      "The series says the gantry was tilted by " + Text(said) +
      " degrees, its slices lie straight above each other. If it was not straightened by the "
      "scanner or an export, its shape is wrong.");
}

void CheckMemory(std::int64_t columns, std::int64_t rows, std::int64_t slices,
  const VolumeReadSettings& settings, Passport& passport)
{
  const std::string text = TooManySamples(columns, rows, slices, 2, settings.memoryLimitBytes);
  if (!text.empty())
    passport.faults.emplace_back(FaultKind::TooLarge, text);
}

/// If resampling mends all faults, they become a plan.
void PlanMending(DicomStack& stack, const VolumeReadSettings& settings)
{
  Passport& passport = stack.passport;
  if (!std::all_of(passport.faults.begin(), passport.faults.end(),
        [](const ImportFault& fault) { return fault.resamplable; }))
    return;
  ResamplePlan plan = PlanResampling(stack.layout);
  passport.faults.clear();
  passport.geometry = plan.geometry;
  passport.resampled = plan.record;
  // What is measured and what is made of it are there at once.
  const glm::ivec3 result = plan.geometry.dims;
  CheckMemory(result.x, result.y, result.z + std::int64_t(stack.slices.size()), settings, passport);
  stack.plan = std::move(plan);
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
  Passport& passport = stack.passport;
  passport.format = "DICOM";
  Series series = Group(folder, files, passport);
  stack.slices = Choose(folder, std::move(series), settings.series, passport);
  Describe(stack.slices, passport);
  CheckEach(stack.slices, passport.faults);
  CheckAlike(stack.slices, passport.faults);
  const bool placed = std::all_of(stack.slices.begin(), stack.slices.end(), HasGeometry);
  const bool turned = std::any_of(passport.faults.begin(), passport.faults.end(),
    [](const ImportFault& f)
    { return f.kind == FaultKind::MixedOrientations || f.kind == FaultKind::MixedFrames; });
  if (placed && !turned)
  {
    SortAndMeasure(stack);
    passport.rescale = RescaleRuns(stack.slices);
    CompareTilts(passport);
  }
  const SliceRecord& first = stack.slices.front().record;
  CheckMemory(first.columns, first.rows, std::int64_t(stack.slices.size()), settings, passport);
  if (settings.resample && !passport.faults.empty())
    PlanMending(stack, settings);
  if (!passport.faults.empty())
    throw ImportError(folder, std::move(passport));
  return stack;
}

} // namespace hasp
