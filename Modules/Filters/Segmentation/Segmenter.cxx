#include "Segmenter.h"

#include "ImageSteps.h"
#include "LabelImage.h"
#include "Segmentation/Components.h"
#include "Segmentation/LabelEdits.h"
#include "Segmentation/LabelMorphology.h"
#include "Segmentation/LabelSplit.h"
#include "Segmentation/PackedDelta.h"
#include "SplitFinding.h"
#include "vtkHaspVolumeView.h"

#include "Grid/ProgressPart.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace hasp
{
namespace
{

/// What the work returns; what it throws begins with `name`.
template <typename Work>
auto Named(const std::string& name, const Work& work)
{
  try
  {
    return work();
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(name + ": " + error.what());
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(name + ": " + error.what());
  }
}

template <typename Step>
constexpr bool IsFilter =
  std::is_same_v<Step, GaussianStep> || std::is_same_v<Step, MedianStep> ||
  std::is_same_v<Step, EdgePreservingStep> || std::is_same_v<Step, ConeBeamStep>;

} // namespace

struct Segmenter::Internals
{
  /// What can be taken back: a step, or a stroke that was added to the last one.
  struct Entry
  {
    bool isStroke = false;
    bool isSettled = true;
    vtkSmartPointer<vtkImageData> imageBefore; ///< of filters
    PackedDelta change;
  };

  Internals(vtkImageData* scan, vtkImageData* given)
    : image(scan),
      labels(MakeLabelImage(scan, given))
  {
    ViewImage(scan); // what kernels cannot read is refused before anything is done
  }

  GridView<Label> Map() const
  {
    auto* values = static_cast<vtkUnsignedShortArray*>(this->labels->GetPointData()->GetScalars());
    return { values->GetPointer(0), ImageGeometry(this->labels) };
  }
  GridView<const Label> ReadOnlyMap() const
  {
    const GridView<Label> map = this->Map();
    return { map.data, map.geometry };
  }
  void Changed() { this->labels->GetPointData()->GetScalars()->Modified(); }

  // Each returns what it changed of the labels, and leaves all as it was if it throws.

  template <typename Step>
  LabelDelta Do(const Step& step, const ProgressFunction& progress) requires IsFilter<Step>
  {
    const vtkSmartPointer<vtkImageData> before = this->image;
    this->image = ApplyStep(before, step, progress);
    this->sameImage = HaveSameSamples(before, this->image);
    return { this->Map().geometry.dims, {} };
  }

  LabelDelta Do(const ThresholdStep& step, const ProgressFunction& progress)
  {
    const GridView<Label> map = this->Map();
    vtkSmartPointer<vtkImageData> values = this->image;
    if (step.smoothMm > 0.0)
      values = ApplyStep(values, GaussianStep{ step.smoothMm }, PartOf(progress, 0.0, 0.6));
    std::vector<Label> bone(map.geometry.Size());
    ThresholdLabels(ViewImage(values), step.lowest, step.highest, { bone.data(), map.geometry },
      PartOf(progress, step.smoothMm > 0.0 ? 0.6 : 0.0, 0.8));
    LabelDelta delta = DifferenceOf(this->ReadOnlyMap(), { bone.data(), map.geometry },
      VoxelBox{ glm::ivec3(0), map.geometry.dims });
    ReportProgress(progress, 1.0);
    std::copy(bone.begin(), bone.end(), map.data);
    return delta;
  }

  LabelDelta Do(const SplitStep& step, const ProgressFunction& progress)
  {
    this->Open(step, this->ReadOnlyMap(), PartOf(progress, 0.0, 0.3));
    return this->Share(PartOf(progress, 0.3, 1.0));
  }

  LabelDelta Do(const PaintStep& step, const ProgressFunction& progress)
  {
    return PaintVoxels(this->Map(), this->Voxels(step.stroke, PartOf(progress, 0.0, 0.5)),
      step.stroke.label, step.only, PartOf(progress, 0.5, 1.0));
  }

  LabelDelta Do(const MergeStep& step, const ProgressFunction& progress)
  {
    return MergeLabels(this->Map(), step.from, step.into, progress);
  }

  LabelDelta Do(const ComponentsStep& step, const ProgressFunction& progress)
  {
    return SeparateComponents(
      this->Map(), step.label, { step.leastMm3, step.keepLargestAlone }, progress);
  }

  LabelDelta Do(const FillStep& step, const ProgressFunction& progress)
  {
    return FillCavities(this->Map(), step.label, progress);
  }

  LabelDelta Do(const MorphologyStep& step, const ProgressFunction& progress)
  {
    switch (step.operation)
    {
      case Morphology::Dilate:
        return DilateLabel(this->Map(), step.label, step.radiusMm, progress);
      case Morphology::Erode:
        return ErodeLabel(this->Map(), step.label, step.radiusMm, progress);
      case Morphology::Open:
        return OpenLabel(this->Map(), step.label, step.radiusMm, progress);
      case Morphology::Close:
        return CloseLabel(this->Map(), step.label, step.radiusMm, progress);
    }
    throw std::invalid_argument("operation is none of dilate, erode, open, close");
  }

  VoxelRuns Voxels(const BrushStroke& stroke, const ProgressFunction& progress) const
  {
    return RasterizeStroke(ImageGeometry(this->labels), stroke.points, stroke.radiusMm, progress);
  }

  /// The split of `step`, which begins with `bone`, and all its strokes; nothing is solved yet.
  void Open(const SplitStep& step, GridView<const Label> bone, const ProgressFunction& progress)
  {
    this->Close();
    std::vector<SeedVoxels> voxels;
    for (const BrushStroke& stroke : step.strokes)
      voxels.push_back({ stroke.label, this->Voxels(stroke, {}) });
    this->split = std::make_unique<LabelSplit>(ViewImage(this->image), bone, step.label,
      SplitSettings{ { .beta = step.beta, .crack = step.crack }, step.norm }, progress);
    this->strokes = std::move(voxels);
  }

  void Close()
  {
    this->split.reset();
    this->strokes.clear();
  }

  LabelDelta Share(const ProgressFunction& progress)
  {
    return this->split->Share(this->strokes, this->Map(), this->settings, progress);
  }

  /// Before a stroke is added, where others came between: the split of the last step again.
  void Reopen(const ProgressFunction& progress)
  {
    if (this->split)
      return;
    if (this->done.empty())
      throw std::logic_error("what the split began with was forgotten");
    const GridView<const Label> now = this->ReadOnlyMap();
    std::vector<Label> before(now.data, now.data + now.geometry.Size());
    for (auto entry = this->done.rbegin();; ++entry)
    {
      const GridView<Label> view{ before.data(), now.geometry };
      RevertDelta(UnpackDelta(entry->change, { view.data, view.geometry }), view);
      if (!entry->isStroke)
        break;
    }
    this->Open(
      std::get<SplitStep>(this->recipe.steps.back()), { before.data(), now.geometry }, progress);
  }

  /// Runs what keeps a change that was made; takes the change back if there is no memory for it.
  template <typename Keeping>
  void Keep(const LabelDelta& delta, const Keeping& keeping)
  {
    try
    {
      SegmentationFinding found;
      found.changed = delta.Voxels();
      found.changedNothing = found.changed == 0 && this->sameImage;
      if (this->split)
        FindSplit(*this->split, this->strokes, found);
      keeping();
      this->finding = std::move(found);
      this->Changed();
    }
    catch (...)
    {
      Label* const map = this->Map().data;
      for (const LabelRun& run : delta.runs) // not RevertDelta: it takes memory itself
        std::fill_n(map + run.first, run.length, run.before);
      throw;
    }
  }
  void KeepEntry(Entry entry, const LabelDelta& delta)
  {
    this->Keep(delta,
      [&]
      {
        entry.change = PackDelta(delta, this->ReadOnlyMap());
        this->done.push_back(std::move(entry));
      });
  }

  bool IsSettled() const { return this->done.empty() || this->done.back().isSettled; }

  vtkSmartPointer<vtkImageData> image, labels;
  bool sameImage = true; ///< whether the last step left the samples as they were
  SegmentationRecipe recipe;
  std::vector<Entry> done;
  SegmentationFinding finding;
  RandomWalkerSettings settings;
  std::unique_ptr<LabelSplit> split; ///< of the last step, where it is one and somebody asked
  std::vector<SeedVoxels> strokes;   ///< of it
};

Segmenter::Segmenter(vtkImageData* scan, vtkImageData* labels)
  : Inside(std::make_unique<Internals>(scan, labels))
{
}
Segmenter::~Segmenter() = default;

void Segmenter::SetWalkerSettings(const RandomWalkerSettings& settings)
{
  this->Inside->settings = settings;
}

LabelDelta Segmenter::Apply(const SegmentationStep& step, const ProgressFunction& progress)
{
  Internals& in = *this->Inside;
  std::vector<SegmentationStep>& steps = in.recipe.steps;
  const std::string name = "steps[" + std::to_string(steps.size()) + "]";
  ValidateSegmentationStep(step, name);
  if (IsImageFilter(step) && !steps.empty() && !IsImageFilter(steps.back()))
    throw std::invalid_argument(
      name + ": a filter must stand before all steps that make or change labels");
  if (steps.size() >= MostSegmentationSteps)
    throw std::invalid_argument(
      name + ": a recipe has at most " + std::to_string(MostSegmentationSteps) + " steps");
  const bool wasSettled = in.IsSettled();
  const LabelDelta settled = this->Settle(PartOf(progress, 0.0, wasSettled ? 0.0 : 0.5));

  // What takes memory comes before what is done, so that both are there or neither.
  SegmentationStep copy = step;
  steps.reserve(steps.size() + 1);
  Internals::Entry entry;
  const vtkSmartPointer<vtkImageData> image = in.image;
  if (IsImageFilter(step))
    entry.imageBefore = image;
  // A split's solver is the largest thing there is; its step is not the last one any more.
  in.Close();
  in.sameImage = true;
  const LabelDelta delta = Named(name,
    [&]
    {
      return std::visit([&](const auto& kind)
        { return in.Do(kind, PartOf(progress, wasSettled ? 0.0 : 0.5, 1.0)); },
        step);
    });
  try
  {
    in.KeepEntry(std::move(entry), delta);
  }
  catch (...)
  {
    in.image = image;
    throw;
  }
  steps.push_back(std::move(copy));
  return settled.Empty() ? delta : JoinDeltas(settled, delta);
}

LabelDelta Segmenter::AddStroke(const BrushStroke& stroke, const ProgressFunction& progress)
{
  Internals& in = *this->Inside;
  std::vector<SegmentationStep>& steps = in.recipe.steps;
  if (steps.empty() || !std::holds_alternative<SplitStep>(steps.back()))
    throw std::invalid_argument("a stroke is added to a split, and the last step is none");
  auto& strokes = std::get<SplitStep>(steps.back()).strokes;
  const std::string name = "steps[" + std::to_string(steps.size() - 1) + "]: strokes[" +
                           std::to_string(strokes.size()) + "]";
  ValidateBrushStroke(stroke, name);
  if (strokes.size() >= MostStrokes)
    throw std::invalid_argument(
      name + ": a split has at most " + std::to_string(MostStrokes) + " strokes");
  BrushStroke copy = stroke;
  strokes.reserve(strokes.size() + 1);
  LabelDelta delta;
  Named(name,
    [&]
    {
      SeedVoxels voxels{ stroke.label, in.Voxels(stroke, {}) };
      in.Reopen(PartOf(progress, 0.0, 0.3));
      in.strokes.push_back(std::move(voxels));
      try
      {
        delta = in.Share(PartOf(progress, 0.3, 1.0));
        Internals::Entry entry;
        entry.isStroke = true;
        entry.isSettled = !in.split->Remembers();
        in.KeepEntry(std::move(entry), delta);
      }
      catch (...)
      {
        in.strokes.pop_back();
        throw;
      }
    });
  strokes.push_back(std::move(copy));
  return delta;
}

LabelDelta Segmenter::Settle(const ProgressFunction& progress)
{
  Internals& in = *this->Inside;
  if (in.IsSettled())
    return { in.Map().geometry.dims, {} };
  in.Reopen(PartOf(progress, 0.0, 0.3));
  in.split->Forget(); // so that the way here leaves no trace
  const LabelDelta delta = in.Share(PartOf(progress, 0.3, 1.0));
  Internals::Entry& last = in.done.back();
  in.Keep(delta,
    [&]
    {
      // Label 0 is in the same places before and after: a split moves no border of bone.
      last.change =
        PackDelta(JoinDeltas(UnpackDelta(last.change, in.ReadOnlyMap()), delta), in.ReadOnlyMap());
      last.isSettled = true;
    });
  return delta;
}

bool Segmenter::IsSettled() const
{
  return this->Inside->IsSettled();
}

LabelDelta Segmenter::Undo()
{
  Internals& in = *this->Inside;
  if (in.done.empty())
    throw std::logic_error("nothing is done that could be taken back");
  Internals::Entry& last = in.done.back();
  LabelDelta delta = UnpackDelta(last.change, in.ReadOnlyMap());
  RevertDelta(delta, in.Map());
  if (last.isStroke)
  {
    std::get<SplitStep>(in.recipe.steps.back()).strokes.pop_back();
    if (in.split)
      in.strokes.pop_back();
  }
  else
  {
    if (last.imageBefore)
      in.image = last.imageBefore;
    in.recipe.steps.pop_back();
    in.Close();
  }
  in.done.pop_back();
  in.Changed();
  for (LabelRun& run : delta.runs)
    std::swap(run.before, run.after);
  return delta;
}

void Segmenter::ForgetUndo()
{
  std::vector<Internals::Entry>& done = this->Inside->done;
  const auto step = std::find_if(
    done.rbegin(), done.rend(), [](const Internals::Entry& entry) { return !entry.isStroke; });
  if (step != done.rend())
    done.erase(done.begin(), std::prev(step.base()));
}

bool Segmenter::CanUndo() const
{
  return !this->Inside->done.empty();
}

std::size_t Segmenter::UndoBytes() const
{
  std::size_t bytes = 0;
  for (const Internals::Entry& entry : this->Inside->done)
    bytes += sizeof(entry) - sizeof(entry.change) + entry.change.Bytes();
  return bytes;
}

const SegmentationRecipe& Segmenter::Recipe() const
{
  return this->Inside->recipe;
}

const SegmentationFinding& Segmenter::Finding() const
{
  return this->Inside->finding;
}

vtkImageData* Segmenter::Image() const
{
  return this->Inside->image;
}

vtkImageData* Segmenter::Labels() const
{
  return this->Inside->labels;
}

} // namespace hasp
