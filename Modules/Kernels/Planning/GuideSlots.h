#pragma once
#include "Planning/GuideRecipe.h"
#include "Planning/Osteotomy.h"

namespace hasp
{

/// The slot that leads a planned blade through a guide that lifts off along `withdrawal` (unit):
/// its plane is the blade's exactly, its kerf the blade's. In the saw plane a slot lies as SawAxes
/// says; it is as long as the blade is across the withdrawal direction and ends where the blade
/// ends below, so that all of the blade comes in: of a blade whose `along` is upright on the
/// withdrawal direction lengthMm is widthMm, of one that is turned in its plane a little more, 500
/// at most.
///
/// Its point is the blade's middle, which a guide's builder puts on the bone (MovedSlot), and its
/// box as high as GuideSlot's default. Pure. Throws std::invalid_argument as ValidateOsteotomy
/// does, and if the blade's plane lies across the withdrawal direction (a cosine above 0.9 with its
/// normal), where no saw comes in. The message begins with `subject`.
GuideSlot SlotOfBlade(
  const Osteotomy& blade, const glm::dvec3& withdrawal, const std::string& subject = "guide slot");

/// The same slot with its point `upMm` higher in the saw plane, along SawAxes' third axis; below 0:
/// lower. Its lower end stays where it was (depthMm grows by upMm), but for a depthMm above 500,
/// which is cut to that. Its point must stay above that end: upMm > -depthMm, else
/// std::invalid_argument. Pure.
GuideSlot MovedSlot(const GuideSlot& slot, const glm::dvec3& withdrawal, double upMm);

} // namespace hasp
