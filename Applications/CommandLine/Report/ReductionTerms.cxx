#include "ReductionTerms.h"

namespace hasp
{

std::vector<ReportTerm> ReductionTerms()
{
  return {
    { "reduction.tre",
      "how far a fragment's surface ends from where the bone was whole, rms over it, median of all "
      "fits; snap: the likeliest of several proposals (hasp reduce), single: one descent from the "
      "start, contact: a push without attraction, icp: iterative closest points, assembled: "
      "all pieces of a bone from coarse poses" },
    { "reduction.rotation", "the same of the angle between both poses" },
    { "reduction.coverage", "fits whose stated interval at 95 % holds the truth" },
    { "reduction.top3", "fits with the truth, within 1 mm, among the first three proposals" },
    { "reduction.capture", "the farthest starts up to which 95 % of fits end where they end from "
                           "the truth itself, ours / "
                           "ICP's; snap, single, icp: in mm" },
    { "reduction.precision",
      "Paper IV: how far trials of one case are from each other, mean distance between surfaces, "
      "by simulated operators with Snap-to-fit; intra: two trials of one operator, inter: of two "
      "operators; max: largest distance, rotation, translation, tre: mean way of places on the "
      "fragment; @case: the table's lines. As hasp evaluate FOLDER makes it" },
    { "reduction.accuracy", "the same table, trials against where the bone was whole" },
    { "reduction.colours",
      "distances of a surface of 200,000 places to a reference, as its pose changes: ms of CPU "
      "time "
      "(aim: 20), how far off, rms and max, and speed against VTK's, a place" },
    { "reduction.part", "how long the parts of this report took" },
    { "reduction.pot", "sherds of a broken pot that are placed within 0.5 mm" },
    { "reduction.fidelity",
      "simulated operators put fractured blocks in place through the haptic step, in virtual time: "
      "how far the surface ends from the truth, rms, all levels of points / 64 points of the same "
      "stiffness per area, median of pairs of one operator, start and noise (aim: 0.5); p: of "
      "Wilcoxon's signed ranks; time: the same ratio of how long it took; points256: / 256 points; "
      "soft: the step's default stiffness; snap: with Snap-to-fit in both, snap_worth: with it / "
      "without; error, seconds: by condition" },
    { "reduction.error_time",
      "median error against time of one fit, by the number of points; lower left is better" },
  };
}

} // namespace hasp
