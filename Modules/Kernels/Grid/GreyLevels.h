#pragma once
#include "Grid/GridView.h"

#include <optional>

namespace hasp
{

/// Where air and soft tissue lie on the scale of a head scan, and whether that speaks against its
/// values being HU (air -1000, water 0, soft tissue about 40).
///
/// Cone beam scanners write the same headers as CT, so the samples are asked. They can only deny:
/// a volume without air or soft tissue, as of a cropped scan or a plaster cast, denies nothing.
struct GreyLevels
{
  std::optional<double> air;        ///< level of the plateau that is air; none was found
  std::optional<double> softTissue; ///< level of the strongest plateau above air
  bool airIsElsewhere = false;      ///< air is not within 100 of -1000
  bool softIsElsewhere = false;     ///< air is there, and soft tissue is not within 200 of 0

  bool DeniesHounsfield() const { return this->airIsElsewhere || this->softIsElsewhere; }
};

/// Levels by two histograms with bins of 10: of all samples, and of the frame of each slice (a
/// twenty-fifth of its width and height), which is around the patient.
///
/// Air is where HU have it, if 2 % of all samples are in [-1100, -900]. Else it is the plateau of
/// the frame: within 50 of it lie 30 % of the frame, and 1 % of all samples at most are more than
/// 150 below. A plateau of one value below -1100 is padding and is left out. Between -150 and 150
/// the plateau could be tissue of a cropped scan: it is air only if a tenth of what is brighter
/// makes a plateau 400 or more above it, and a hundredth is brighter yet, as bone is.
/// Soft tissue denies HU only in [-700, -200) and (200, 500], with a fifth of all that is no air.
///
/// Samples finite. Any thread; all threads are used, the same levels with any number. O(samples).
GreyLevels FindGreyLevels(const AnyGridView& grid);

} // namespace hasp
