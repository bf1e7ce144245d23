#include "Planning/SegmentationRecipe.h"

#include "Planning/ValueChecks.h"

#include <set>

namespace hasp
{

namespace
{
constexpr double LargestGrey = 1e6;

struct CheckStep
{
  const std::string& subject;
  const ValueChecks check{ this->subject };

  void Label(const char* key, std::uint16_t label) const
  {
    this->check.Closed(key, label, 1, 65535);
  }

  void operator()(const GaussianStep& step) const
  {
    this->check.AboveUpTo("sigmaMm", step.sigmaMm, 0.0, 10.0);
  }
  void operator()(const MedianStep& step) const
  {
    this->check.AboveUpTo("radiusMm", step.radiusMm, 0.0, 10.0);
  }
  void operator()(const EdgePreservingStep& step) const
  {
    this->check.AboveUpTo("edge", step.edge, 0.0, LargestGrey);
    this->check.Closed("iterations", step.iterations, 1, 100);
  }
  void operator()(const ConeBeamStep& step) const
  {
    this->check.Closed("fieldMm", step.fieldMm, 10.0, 500.0);
    if (step.contrastMm != 0.0 && !(step.contrastMm >= 5.0 && step.contrastMm <= 100.0))
      this->check.Refuse("contrastMm", step.contrastMm, "0, or in [5, 100]");
    this->check.Closed("insideAbove", step.insideAbove, -LargestGrey, LargestGrey);
  }
  void operator()(const ThresholdStep& step) const
  {
    this->check.Closed("lowest", step.lowest, -LargestGrey, LargestGrey);
    this->check.Closed("highest", step.highest, step.lowest, LargestGrey);
    this->check.Closed("smoothMm", step.smoothMm, 0.0, 10.0);
  }
  void operator()(const SplitStep& step) const
  {
    this->Label("label", step.label);
    this->check.Closed("beta", step.beta, 0.0, 1e12);
    this->check.Closed("crack", step.crack, 0.0, 1.0);
    this->check.Closed("norm", step.norm, 1.0, 2.0);
    this->check.Closed(
      "the number of strokes", double(step.strokes.size()), 0.0, double(MostStrokes));
    for (std::size_t n = 0; n < step.strokes.size(); ++n)
      ValidateBrushStroke(step.strokes[n], this->subject + "." + ListKey("strokes", n));
  }
  void operator()(const PaintStep& step) const
  {
    ValidateBrushStroke(step.stroke, this->subject + ".stroke", 0);
  }
  void operator()(const MergeStep& step) const
  {
    this->Label("from", step.from);
    if (step.into == step.from)
      this->check.Refuse("into", step.into, "another label than from");
  }
  void operator()(const ComponentsStep& step) const
  {
    this->Label("label", step.label);
    this->check.Closed("leastMm3", step.leastMm3, 0.0, 1e9);
  }
  void operator()(const FillStep& step) const { this->Label("label", step.label); }
  void operator()(const MorphologyStep& step) const
  {
    this->Label("label", step.label);
    if (step.operation < Morphology::Dilate || step.operation > Morphology::Close)
      this->check.Refuse("operation", double(step.operation), "one of the four that there are");
    this->check.AboveUpTo("radiusMm", step.radiusMm, 0.0, 50.0);
  }
};

struct CalledStep
{
  static std::string Of(const char* what, std::uint16_t label)
  {
    return what + (" label " + std::to_string(label));
  }

  std::string operator()(const GaussianStep&) const { return "Gaussian filter"; }
  std::string operator()(const MedianStep&) const { return "Median filter"; }
  std::string operator()(const EdgePreservingStep&) const { return "Edge-preserving filter"; }
  std::string operator()(const ConeBeamStep&) const { return "Cone-beam correction"; }
  std::string operator()(const ThresholdStep&) const { return "Threshold"; }
  std::string operator()(const SplitStep& step) const { return Of("Split", step.label); }
  std::string operator()(const PaintStep& step) const
  {
    return step.stroke.label == 0 ? "Erase" : Of("Paint", step.stroke.label);
  }
  std::string operator()(const MergeStep& step) const
  {
    return step.into == 0 ? Of("Remove", step.from)
                          : Of("Merge", step.from) + " into " + std::to_string(step.into);
  }
  std::string operator()(const ComponentsStep& step) const
  {
    return Of(step.keepLargestAlone ? "Keep the largest piece of" : "Pieces of", step.label);
  }
  std::string operator()(const FillStep& step) const { return Of("Fill cavities of", step.label); }
  std::string operator()(const MorphologyStep& step) const
  {
    switch (step.operation)
    {
      case Morphology::Dilate:
        return Of("Dilate", step.label);
      case Morphology::Erode:
        return Of("Erode", step.label);
      case Morphology::Open:
        return Of("Open", step.label);
      case Morphology::Close:
        break;
    }
    return Of("Close", step.label);
  }
};

struct ChangesSamples
{
  bool operator()(const GaussianStep&) const { return true; }
  bool operator()(const MedianStep&) const { return true; }
  bool operator()(const EdgePreservingStep&) const { return true; }
  bool operator()(const ConeBeamStep&) const { return true; }
  template <typename Other>
  bool operator()(const Other&) const
  {
    return false;
  }
};
} // namespace

bool IsImageFilter(const SegmentationStep& step)
{
  return std::visit(ChangesSamples{}, step);
}

std::string StepLabel(const SegmentationStep& step)
{
  return std::visit(CalledStep{}, step);
}

void ValidateBrushStroke(
  const BrushStroke& stroke, const std::string& subject, std::uint16_t leastLabel)
{
  const ValueChecks check(subject);
  check.Closed("label", stroke.label, leastLabel, 65535);
  check.AboveUpTo("radiusMm", stroke.radiusMm, 0.0, 50.0);
  check.Closed("the number of points", double(stroke.points.size()), 1.0, double(MostStrokePoints));
  check.Points("points", stroke.points);
}

void ValidateSegmentationStep(const SegmentationStep& step, const std::string& subject)
{
  std::visit(CheckStep{ subject }, step);
}

void ValidateLabelNames(
  const std::vector<LabelName>& names, const std::string& subject, const char* list)
{
  const ValueChecks check(subject);
  std::set<std::uint16_t> named;
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    check.Closed(ListKey(list, n, "label"), names[n].label, 1, 65535);
    if (!named.insert(names[n].label).second)
      check.Refuse(ListKey(list, n, "label"), names[n].label, "named once");
    check.Text(ListKey(list, n, "name"), names[n].name);
  }
}

void ValidateSegmentationRecipe(const SegmentationRecipe& recipe)
{
  const std::string subject = "segmentation recipe";
  const ValueChecks check(subject);
  check.Closed(
    "the number of steps", double(recipe.steps.size()), 0.0, double(MostSegmentationSteps));
  for (std::size_t n = 0; n < recipe.steps.size(); ++n)
  {
    ValidateSegmentationStep(recipe.steps[n], subject + ": " + ListKey("steps", n));
    if (n > 0 && IsImageFilter(recipe.steps[n]) && !IsImageFilter(recipe.steps[n - 1]))
      check.Refuse(ListKey("steps", n), "is a filter, which must stand before all other steps");
  }
  ValidateLabelNames(recipe.names, subject);
}

} // namespace hasp
