#include "PlannerTerms.h"

namespace hasp
{

std::vector<ReportTerm> PlannerTerms()
{
  return {
    { "planner.first", "from the program's start to the sample's first complete picture" },
    { "planner.isovalue",
      "from a new isovalue to its picture / the same by a mesh made anew; ms: that time itself; @: "
      "samples a side" },
    { "planner.drag", "a fragment in hand, in contact, in a window of 1280x800: fps: frames a "
                      "second; full: with all "
                      "pixels; share: least pixels along an axis; touching: in contact; tick: of "
                      "the haptic thread" },
    { "planner.idle", "frames drawn while nothing happens" },
    { "planner.clicks",
      "presses of buttons of a whole case, from the sample to the exported parts" },
    { "planner.wait", "of that case: from inputs until all that came of them was done" },
    { "planner.reopened", "growth of memory over plans that are opened again and again" },
  };
}

} // namespace hasp
