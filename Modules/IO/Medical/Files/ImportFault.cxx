#include "Files/FileError.h"
#include "vtkHaspVolumeFile.h"

#include <algorithm>

namespace hasp
{
namespace
{

/// What the exception says: the first fault, how many more, and whether resampling helps.
std::string Refusal(const std::filesystem::path& file, const std::vector<ImportFault>& faults)
{
  std::string text = FileLabel(file) + ": " + faults.front().text;
  if (faults.size() > 1)
  {
    text += ". " + std::to_string(faults.size() - 1) +
            (faults.size() == 2 ? " more fault (" : " more faults (");
    for (std::size_t n = 1; n < faults.size(); ++n)
      text += (n > 1 ? ", " : "") + std::string(FaultName(faults[n].kind));
    text += "): see hasp info";
  }
  const bool doubled = std::any_of(faults.begin(), faults.end(),
    [](const ImportFault& fault) { return fault.kind == FaultKind::DoubledSlices; });
  if (std::all_of(
        faults.begin(), faults.end(), [](const ImportFault& fault) { return fault.resamplable; }))
    text += ". It can be read resampled (--resample, or SetResample)" +
            std::string(doubled ? " if the pictures at one place are the same" : "");
  return text;
}

} // namespace

const char* FaultName(FaultKind kind)
{
  switch (kind)
  {
    case FaultKind::MissingSlices:
      return "missing_slices";
    case FaultKind::DoubledSlices:
      return "doubled_slices";
    case FaultKind::UnevenSpacing:
      return "uneven_spacing";
    case FaultKind::GantryTilt:
      return "gantry_tilt";
    case FaultKind::ShiftedSlices:
      return "shifted_slices";
    case FaultKind::SingleSlice:
      return "single_slice";
    case FaultKind::MixedSizes:
      return "mixed_sizes";
    case FaultKind::MixedOrientations:
      return "mixed_orientations";
    case FaultKind::MixedFrames:
      return "mixed_frames";
    case FaultKind::MixedSeries:
      return "mixed_series";
    case FaultKind::NoGeometry:
      return "no_geometry";
    case FaultKind::BadRescale:
      return "bad_rescale";
    case FaultKind::Unsupported:
      return "unsupported";
    case FaultKind::TooLarge:
      return "too_large";
    case FaultKind::Damaged:
      return "damaged";
  }
  return "damaged";
}

ImportError::ImportError(const std::filesystem::path& file, Passport known)
  : std::runtime_error(Refusal(file, known.faults)),
    passport(std::make_shared<const Passport>(std::move(known)))
{
}

} // namespace hasp
