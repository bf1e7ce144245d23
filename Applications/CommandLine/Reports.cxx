#include "ReportRegistry.h"

#include "ReportStereo.h"

namespace hasp
{

const std::vector<ReportEntry>& ReportRegistry()
{
  static const std::vector<ReportEntry> entries{
    { "stereo", "where points lie in both eyes, against VTK's own stereo", ReportStereo },
  };
  return entries;
}

} // namespace hasp
