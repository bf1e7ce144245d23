#include "ReportRegistry.h"

#if HASP_WITH_CELLS
#include "ReportIsosurface.h"
#endif
#include "ReportImport.h"
#include "ReportStereo.h"

namespace hasp
{

const std::vector<ReportEntry>& ReportRegistry()
{
  static const std::vector<ReportEntry> entries
  {
#if HASP_WITH_CELLS
    { "isosurface", "error against time of cells, mesh, GPU volume and direct rays",
      ReportIsosurface },
#endif
      { "import", "where samples lie and how long reading takes, against other readers",
        ReportImport },
      { "stereo", "where points lie in both eyes, against VTK's own stereo", ReportStereo },
  };
  return entries;
}

} // namespace hasp
