#ifndef vtkHaspImportFault_h
#define vtkHaspImportFault_h

#include "vtkHaspIOMedicalModule.h" // for export macro

#include <string>  // for texts
#include <utility> // for move
#include <vector>  // for numbers

/// What is wrong with a volume, as data: for programs that show faults their own way. Any thread.
namespace hasp
{

enum class FaultKind
{
  MissingSlices,     ///< gaps that are whole multiples of the usual one
  DoubledSlices,     ///< several slices at one place
  UnevenSpacing,     ///< gaps that are no multiple
  GantryTilt,        ///< slices on a line that is not their normal
  ShiftedSlices,     ///< slices beside each other that no tilt explains
  SingleSlice,       ///< no volume
  MixedSizes,        ///< slices of several numbers of pixels or pixel spacings
  MixedOrientations, ///< slices that are turned against each other
  MixedFrames,       ///< slices of several frames of reference
  MixedSeries,       ///< several series and no choice, or a choice that is not there
  NoGeometry,        ///< spacing, position or orientation that is absent or no use
  BadRescale,        ///< slope or intercept that is 0 or no number
  Unsupported,       ///< colour, several frames, bits or a compression that is not read
  TooLarge,          ///< more samples than the memory limit
  Damaged,           ///< cut off, bit rot, or no such file: its text says
};

/// "missing_slices", "gantry_tilt": for JSON.
VTKHASPIOMEDICAL_EXPORT const char* FaultName(FaultKind kind);

struct ImportFault
{
  ImportFault() = default;
  ImportFault(FaultKind faultKind, std::string sentence)
    : kind(faultKind),
      text(std::move(sentence))
  {
  }

  FaultKind kind = FaultKind::Damaged;
  std::string text; ///< a whole sentence or more: what is wrong, where, and what to do. No text of
                    ///< the file and, unless ShowFileNames(true), no name
  std::vector<int> slices; ///< their numbers from 1 along row x column, missing ones counted, too:
                           ///< those missing, doubled, after an uneven gap, or farthest aside;
                           ///< empty where the stack is not known
  std::vector<int> files;  ///< numbers from 1 in the order of the paths: of faulty files, or of the
                           ///< slices before and after a gap
  double millimetres = 0.0; ///< widest gap, or farthest aside; 0: does not apply
  double degrees = 0.0;     ///< tilt, in (0, 90); 0: does not apply
  bool resamplable = false; ///< VolumeReadSettings::resample mends it. Doubled slices: if their
                            ///< pixels are the same, which shows when they are decoded
};

/// Slices from `firstSlice` to `lastSlice` with one rescaling: value = slope * stored + intercept.
struct RescaleRun
{
  int firstSlice = 1; ///< from 1 along the stack, as it was measured
  int lastSlice = 1;
  double slope = 1.0;
  double intercept = 0.0;
};

} // namespace hasp

#endif
