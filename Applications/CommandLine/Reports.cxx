#include "ReportRegistry.h"

#if HASP_WITH_CELLS
#include "ReportCells.h"
#include "ReportIsosurface.h"
#include "ReportLight.h"
#include "ReportRaycaching.h"
#include "ReportStability.h"
#endif
#include "ReportDistance.h"
#if HASP_WITH_GUIDE_REPORT
#include "ReportGuides.h"
#endif
#include "ReportHaptics.h"
#include "ReportImport.h"
#include "ReportPlanner.h"
#include "ReportReduction.h"
#include "ReportSegmentation.h"
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
      { "cells", "bytes, extraction, edits, frames and rays of clustered cells, against a mesh",
        ReportCells },
      { "raycaching", "frames, holes and errors of the ray cache, against direct ray casts",
        ReportRaycaching },
      { "light",
        "global light of bone and parts: furnaces, closed forms, error against time of kept light "
        "and of paths, rays against triangles",
        ReportLight },
      { "stability",
        "what is predicted of extreme volumes, rays, eyes and haptic loops, against what comes",
        ReportStability },
#endif
      { "distance",
        "error against time of distance transforms and contours that keep edges, against ITK's, "
        "OpenVDB's and VTK's",
        ReportDistance },
#if HASP_WITH_GUIDE_REPORT
      { "guides",
        "are random parts sound, do they fit, does their certificate find what is wrong, and what "
        "a "
        "guide costs, against Booleans of meshes",
        ReportGuides },
#endif
      { "haptics",
        "contact points, levels and Snap-to-fit in a tick, and what they are off by, "
        "against plain code",
        ReportHaptics },
      { "segmentation",
        "how far fragments agree with the truth after few strokes, error against time, and what "
        "one more stroke costs, against a watershed, thresholds and a direct solver",
        ReportSegmentation },
#if HASP_WITH_REDUCTION
      { "reduction",
        "where fragments end that are put together by their broken faces, from how far off, and "
        "whether stated intervals hold, against contact alone and closest points",
        ReportReduction },
#endif
      { "planner",
        "the window: first picture, pictures after a new isovalue against a mesh made anew, a drag "
        "with contact, rest, memory",
        ReportPlanner },
      { "import", "where samples lie and how long reading takes, against other readers",
        ReportImport },
      { "stereo", "where points lie in both eyes, against VTK's own stereo", ReportStereo },
  };
  return entries;
}

} // namespace hasp
