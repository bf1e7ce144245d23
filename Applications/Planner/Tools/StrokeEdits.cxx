#include "Tools/StrokeEdits.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace hasp
{
namespace
{

/// The last of its kind among the steps.
template <typename Step>
const Step* LastOf(const PlanSegmentation& segmentation)
{
  const std::vector<SegmentationStep>& steps = segmentation.recipe.steps;
  const auto found = std::find_if(steps.rbegin(), steps.rend(),
    [](const SegmentationStep& step) { return std::holds_alternative<Step>(step); });
  return found == steps.rend() ? nullptr : &std::get<Step>(*found);
}

double WayToLine(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to)
{
  const glm::dvec3 along = to - from;
  const double length2 = glm::dot(along, along);
  const double share = length2 > 0.0 ? glm::dot(point - from, along) / length2 : 0.0;
  return glm::length(point - from - glm::clamp(share, 0.0, 1.0) * along);
}

bool IsUnder(const glm::dvec3& point, const std::vector<BrushStroke>& eraser)
{
  return std::any_of(eraser.begin(), eraser.end(),
    [&](const BrushStroke& stroke)
    {
      for (std::size_t n = 0; n < stroke.points.size(); ++n)
        if (WayToLine(point, stroke.points[n == 0 ? 0 : n - 1], stroke.points[n]) <=
            stroke.radiusMm)
          return true;
      return false;
    });
}

} // namespace

const PlanSegmentation* PaintedIn(const Plan& plan, PlanId volume)
{
  const auto found = std::find_if(plan.segmentations.rbegin(), plan.segmentations.rend(),
    [&](const PlanSegmentation& one)
    {
      return one.volume == volume && one.labels.empty() && !one.recipe.steps.empty() &&
             std::holds_alternative<ThresholdStep>(one.recipe.steps.front());
    });
  return found == plan.segmentations.rend() ? nullptr : &*found;
}

const SplitStep* SplitOf(const PlanSegmentation& segmentation)
{
  return LastOf<SplitStep>(segmentation);
}

const ThresholdStep* ThresholdOf(const PlanSegmentation& segmentation)
{
  return LastOf<ThresholdStep>(segmentation);
}

std::vector<PlanEdit> PaintEdits(const Plan& plan, PlanId newId, const PaintedSegmentation& first,
  const std::vector<BrushStroke>& pieces)
{
  SplitStep split{ .label = 1, .strokes = pieces, .norm = 1.0 }; // as vtkHaspSegmentationSession
  const PlanSegmentation* painted = PaintedIn(plan, first.volume);
  if (!painted)
  {
    PlanSegmentation made;
    made.id = newId;
    made.name = first.name;
    made.volume = first.volume;
    made.recipe.steps = { ThresholdStep{ first.isovalue }, std::move(split) };
    made.recipe.names = first.names;
    return { AddObject<PlanSegmentation>{ std::move(made) } };
  }
  if (!SplitOf(*painted))
    return { AddSegmentationStep{ painted->id, std::move(split) } };
  std::vector<PlanEdit> edits;
  if (std::holds_alternative<SplitStep>(painted->recipe.steps.back()))
  {
    for (const BrushStroke& piece : pieces)
      edits.push_back(AddSegmentationStroke{ painted->id, piece });
    return edits;
  }
  PlanSegmentation changed = *painted; // a stroke is added to a last step alone
  const auto last = std::find_if(changed.recipe.steps.rbegin(), changed.recipe.steps.rend(),
    [](const SegmentationStep& step) { return std::holds_alternative<SplitStep>(step); });
  std::vector<BrushStroke>& strokes = std::get<SplitStep>(*last).strokes;
  strokes.insert(strokes.end(), pieces.begin(), pieces.end());
  return { ChangeObject<PlanSegmentation>{ std::move(changed) } };
}

std::vector<BrushStroke> ErasedStrokes(
  const std::vector<BrushStroke>& strokes, const std::vector<BrushStroke>& eraser)
{
  std::vector<BrushStroke> left;
  for (const BrushStroke& stroke : strokes)
  {
    BrushStroke piece = stroke;
    piece.points.clear();
    const auto end = [&]
    {
      if (!piece.points.empty())
        left.push_back(piece);
      piece.points.clear();
    };
    for (const glm::dvec3& point : stroke.points)
      if (IsUnder(point, eraser))
        end();
      else
        piece.points.push_back(point);
    end();
  }
  return left;
}

std::optional<PlanEdit> EraseEdit(
  const Plan& plan, PlanId volume, const std::vector<BrushStroke>& eraser)
{
  const PlanSegmentation* painted = PaintedIn(plan, volume);
  if (!painted || !SplitOf(*painted))
    return std::nullopt;
  PlanSegmentation changed = *painted;
  const auto last = std::find_if(changed.recipe.steps.rbegin(), changed.recipe.steps.rend(),
    [](const SegmentationStep& step) { return std::holds_alternative<SplitStep>(step); });
  std::vector<BrushStroke>& strokes = std::get<SplitStep>(*last).strokes;
  std::vector<BrushStroke> left = ErasedStrokes(strokes, eraser);
  if (left == strokes)
    return std::nullopt;
  strokes = std::move(left);
  return ChangeObject<PlanSegmentation>{ std::move(changed) };
}

} // namespace hasp
