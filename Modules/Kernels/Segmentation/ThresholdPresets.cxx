#include "Segmentation/ThresholdPresets.h"

namespace hasp
{

std::span<const ThresholdPreset> ThresholdPresets()
{
  static constexpr ThresholdPreset presets[] = {
    { "bone", 226, 3071 },
    { "adult compact bone", 662, 1988 },
    { "adult spongial bone", 148, 661 },
    { "adult enamel", 1553, 2850 },
    { "child compact bone", 586, 2198 },
    { "child spongial bone", 156, 585 },
    { "child enamel", 2042, 3071 },
    { "soft tissue", -700, 225 },
  };
  return presets;
}

} // namespace hasp
