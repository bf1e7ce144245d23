#pragma once
#include "Grid/GridView.h"
#include "Grid/Progress.h"

#include <optional>

namespace hasp
{

/// What CorrectConeBeam is told. Nothing of the scanner: all else is estimated from the image.
struct ConeBeamSettings
{
  double fieldMm = 60.0;    ///< shading is smooth over this length, [10, 500]
  double contrastMm = 0.0;  ///< contrast is normalised over this length, 0: not at all, [5, 100]
  double insideAbove = 0.0; ///< the patient is grey value > this, [-1e6, 1e6]
};

/// What it found, for reports. Grey values.
struct ConeBeamFindings
{
  std::optional<double> air; ///< its level; none: shading was taken to be added, not multiplied
  double softTissue = 0.0;   ///< its level after correction, which is its mean before it
  double lowest = 1.0;       ///< least of the shading found in soft tissue: gain, relative to its
                             ///< mean; without air the grey values that were added there
  double highest = 1.0;      ///< largest of it
  double boneContrast = 0.0; ///< bone's mean excess over soft tissue; 0 if contrastMm is 0 or
                             ///< nothing stands out
};

/// Takes back what varies slowly in a cone-beam image: cupping and other shading, and then, where
/// it is asked for, contrast of bone that is not the same everywhere.
///
/// grid       grey values in any unit; they need not be HU and do not become HU
/// corrected  of the same size, not the same memory. Samples of the patient (> insideAbove) are
///            corrected, not rounded; all others are copied, NaN and infinity among them.
///
/// Shading: grey - air = gain(x) * (HU + 1000) * constant is what beam hardening and scatter do to
/// a reconstruction. `air` is the level of the plateau of samples <= insideAbove (a plateau of one
/// single value at the very bottom is padding, where there is another). The gain is the smooth
/// field that soft tissue, the strongest level of the patient, is found to follow: in blocks of
/// fieldMm / 6 a histogram each, the mean of what lies near the field (Tukey's biweight, narrowed
/// step by step to the noise), and a thin plate through these means, so that wavelengths of
/// fieldMm are halved and linear shading is kept to the patient's edge. Bone, metal and air lie
/// outside the biweight and do not pull; where there is no soft tissue the plate bridges. Where
/// less than 1 sample in 1,000 is <= insideAbove there is no level of air: the field is then
/// subtracted. Gain is limited to [0.5, 2]; soft tissue keeps its mean level.
///
/// Contrast: K(x), the mean excess over soft tissue of what exceeds it by more than K(x) / 2, over
/// a Gaussian window of standard deviation contrastMm / 2, becomes the same everywhere. Excess is
/// scaled by at most 2 or 1/2; where no bone is near, and below soft tissue, nothing changes.
/// Limit: that also lifts thin bone and lowers enamel; it is for segmentation, not for measuring.
///
/// Throws std::invalid_argument if a number is out of its range, sizes differ, or no sample is >
/// insideAbove; Cancelled if progress says so (`corrected` is then undefined). A patient of one
/// single value is left as it is. Any thread; all are used, the same bytes with any number.
/// O(voxels); at most 20 MB besides `corrected`.
ConeBeamFindings CorrectConeBeam(const AnyGridView& grid, const ConeBeamSettings& settings,
  GridView<float> corrected, const ProgressFunction& progress = {});

} // namespace hasp
