#include "SplitRival.h"

namespace hasp
{

std::vector<SplitRival> WatershedRivals()
{
  SplitRival rival;
  rival.name = "ITK MorphologicalWatershedFromMarkersImageFilter";
  rival.absent = "this build has no ITK (HASP_ENABLE_ITK; Utilities/Scripts/setup --develop)";
  return { rival };
}

} // namespace hasp
