// What the tours say. Only words: what is done is done by the user.
#include "Window/Tour.h"

#include <algorithm>
#include <set>

namespace hasp
{
namespace
{
TourStop Stop(const char* step, const char* widget, const char* text,
  std::function<bool(const Plan&)> isDone = {})
{
  return { step, widget, Tour::tr(text), std::move(isDone) };
}

template <typename T>
std::function<bool(const Plan&)> AtLeast(std::vector<T> Plan::*objects, std::size_t count)
{
  return [objects, count](const Plan& plan) { return (plan.*objects).size() >= count; };
}

/// Of two pieces: with strokes of one alone nothing falls apart.
bool HasStrokes(const Plan& plan)
{
  std::set<int> labels;
  for (const PlanSegmentation& one : plan.segmentations)
    for (const SegmentationStep& step : one.recipe.steps)
      if (const auto* split = std::get_if<SplitStep>(&step))
        for (const BrushStroke& stroke : split->strokes)
          labels.insert(stroke.label);
  return labels.size() >= 2;
}

/// Of the bone and three pieces.
bool HasResected(const Plan& plan)
{
  return plan.fragments.size() >= 4 &&
         std::any_of(plan.fragments.begin(), plan.fragments.end(),
           [](const PlanFragment& one) { return one.state == FragmentState::Resected; });
}

TourStop Begin()
{
  return Stop("import", "view.scene",
    QT_TRANSLATE_NOOP("hasp::Tour",
      "This is the bone of the scan. Turn it with the left button, zoom "
      "with the wheel; a double click makes a view large. Ctrl+Z takes "
      "anything back. Press Next."));
}
TourStop Isovalue()
{
  return Stop("split", "split.isovalue",
    QT_TRANSLATE_NOOP("hasp::Tour",
      "Move the isovalue: what is at least so bright is bone. 226 HU is "
      "a usual choice. Press Next when the bone looks right."));
}
TourStop Check()
{
  return Stop("check", "check.makeall",
    QT_TRANSLATE_NOOP("hasp::Tour",
      "Make all parts. Each is written, read back and measured: green "
      "holds what the recipe promises. Press Next when it is green."));
}
TourStop Export()
{
  return Stop("export", "export.all",
    QT_TRANSLATE_NOOP("hasp::Tour", "Choose a folder and export. What is out of date cannot be "
                                    "exported. That is the whole way; Ctrl+S saves the plan."));
}

std::vector<TourStop> SkullTour()
{
  return { Begin(), Isovalue(),
    Stop("guide", "guide.new",
      QT_TRANSLATE_NOOP("hasp::Tour", "Press New, then touch bone along the rim of the defect: "
                                      "three clicks or more."),
      [](const Plan& plan)
      { return !plan.guides.empty() && plan.guides.back().recipe.landmarks.size() >= 3; }),
    Stop("guide", "guide.gap",
      QT_TRANSLATE_NOOP("hasp::Tour", "Sizes are at the left of their units; change what you like. "
                                      "Press Next.")),
    Check(), Export() };
}

std::vector<TourStop> MandibleTour()
{
  return { Begin(), Isovalue(),
    Stop("split", "split.paint",
      QT_TRANSLATE_NOOP("hasp::Tour", "Press Paint and draw a stroke on each piece, with another "
                                      "label for each; the bone falls apart while you paint."),
      HasStrokes),
    Stop("split", "split.make",
      QT_TRANSLATE_NOOP("hasp::Tour", "When each piece has its colour: Make fragments."),
      AtLeast(&Plan::fragments, 2)),
    Stop("reduce", "reduce.grab",
      QT_TRANSLATE_NOOP("hasp::Tour",
        "Lock the cranium in the list of objects, press Grab and drag "
        "a piece to where it belongs; with Snap-to-fit it is drawn to "
        "its place. Or let all be put together: Find how they fit.")),
    Stop("plate", "plate.new plate.kind",
      QT_TRANSLATE_NOOP("hasp::Tour",
        "Press New, then touch the bone along the plate's way over the fracture. "
        "Press Next when its line is right.")),
    Check(), Export() };
}

std::vector<TourStop> FibulaTour()
{
  return { Begin(),
    Stop("cut", "cut.place",
      QT_TRANSLATE_NOOP("hasp::Tour", "Touch the jaw in two places for a cut; press New, and do so "
                                      "for a second one. What is between them will be resected."),
      AtLeast(&Plan::cuts, 2)),
    Stop("cut", "cut.pieces",
      QT_TRANSLATE_NOOP("hasp::Tour", "Keep the pieces, and resect the one in the middle."),
      HasResected),
    Stop("plate", "transplant.new plate.kind",
      QT_TRANSLATE_NOOP("hasp::Tour",
        "Choose Transplants and press New; touch the places of the new jaw's line, and "
        "the two tips of the fibula."),
      AtLeast(&Plan::transplants, 1)),
    Stop("plate", "mitre.new plate.kind",
      QT_TRANSLATE_NOOP("hasp::Tour",
        "Choose Saw guides for transplants, and press New: the guide leads the saw on the fibula."),
      AtLeast(&Plan::mitreGuides, 1)),
    Check(), Export() };
}
} // namespace

std::vector<TourStop> TourOf(Sample sample)
{
  return sample == Sample::Skull      ? SkullTour()
         : sample == Sample::Mandible ? MandibleTour()
                                      : FibulaTour();
}

} // namespace hasp
