#include "SegmentationTerms.h"

namespace hasp
{

std::vector<ReportTerm> SegmentationTerms()
{
  return {
    { "segmentation.dice",
      "Dice of the worst fragment, of few strokes that a simulated user draws from a coarse hint; "
      "then the case, the worst of all without it; cbct: of simulated cone-beam scans after "
      "correction, uncorrected: without" },
    { "segmentation.surface",
      "share of the worst fragment's surface, and of the truth's, that lies within one voxel (its "
      "largest spacing) of the other; the same cases" },
    { "segmentation.first",
      "from the mask to labels, the first time; walk: by norm 2, the random walk, else by norm 1" },
    { "segmentation.resolve",
      "labels after one more stroke; walk: by norm 2, which starts from what was solved" },
    { "segmentation.memory", "bytes for each voxel of bone" },
    { "segmentation.undo", "bytes that take the stroke back that changes most" },
    { "segmentation.warm",
      "cycles of one more stroke / of the same from nothing; coarse: / of the same from coarse "
      "graphs" },
    { "segmentation.direct", "what probabilities are off by from a sparse direct solver's" },
    { "segmentation.error_time",
      "1 - the worst fragment's Dice against time, by the same strokes; lower left is better" },
    { "segmentation.surface_time", "the same of surface Dice" },
  };
}

} // namespace hasp
