#pragma once
#include "Planning/PlanEdits.h"

#include <optional>
#include <vector>

/// Strokes of a brush as edits of a plan's segmentation. Values; any thread.
namespace hasp
{

/// What a first stroke makes.
struct PaintedSegmentation
{
  PlanId volume = 0;
  std::string name;
  double isovalue = 226.0;      ///< bone is value >= this
  std::vector<LabelName> names; ///< of the labels that are offered
};

/// The newest segmentation of a volume that is made of the scan alone and begins with a threshold:
/// what is painted goes there. nullptr: none yet.
const PlanSegmentation* PaintedIn(const Plan& plan, PlanId volume);
/// The split that its strokes are of, and the threshold of its bone; nullptr: it has none.
const SplitStep* SplitOf(const PlanSegmentation& segmentation);
const ThresholdStep* ThresholdOf(const PlanSegmentation& segmentation);

/// One step of the plan: these pieces of a drag, as strokes of the split of PaintedIn; that is
/// made, with id `newId`, where there is none. A recipe that goes on behind its split keeps that.
std::vector<PlanEdit> PaintEdits(const Plan& plan, PlanId newId, const PaintedSegmentation& first,
  const std::vector<BrushStroke>& pieces);

/// Takes away what an eraser's drag went over: points of strokes that lie within the eraser's
/// radius of its line. A stroke that is cut becomes several, one that is all gone none. None: there
/// is nothing under it.
std::optional<PlanEdit> EraseEdit(
  const Plan& plan, PlanId volume, const std::vector<BrushStroke>& eraser);

/// The strokes that are left of these.
std::vector<BrushStroke> ErasedStrokes(
  const std::vector<BrushStroke>& strokes, const std::vector<BrushStroke>& eraser);

} // namespace hasp
