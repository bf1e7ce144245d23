#ifndef Segmenter_h
#define Segmenter_h

#include "Grid/LabelTable.h"                  // for LabelTable
#include "Grid/Progress.h"                    // for ProgressFunction
#include "Planning/SegmentationRecipe.h"      // for the steps
#include "Segmentation/LabelDelta.h"          // for what a step changes
#include "Segmentation/RandomWalker.h"        // for its settings
#include "vtkHaspFiltersSegmentationModule.h" // for export macro
#include "vtkSmartPointer.h"                  // for images

#include <memory>   // for internals
#include <optional> // for what only splits have
#include <vector>   // for findings

class vtkImageData;

namespace hasp
{

/// What a step came to.
struct SegmentationFinding
{
  std::uint64_t changed = 0;   ///< voxels that have another label than before
  bool changedNothing = false; ///< no label, and of a filter no sample
  /// Of a SplitStep.
  std::optional<RandomWalkerRun> walk;
  std::vector<std::size_t> besideBone; ///< strokes that touch no voxel of the step's label
  /// Labels of strokes that get no voxel: those lie beside it, or later ones paint over them.
  std::vector<std::uint16_t> withoutSeeds;
  std::uint64_t unreached = 0; ///< voxels that no stroke is connected to: they keep the label
};

/// A scan while a user makes labels of it: step by step, each of which can be taken back, and
/// stroke by stroke. At any time the labels are those that the recipe makes of the scan, to the
/// last bit and with any number of threads; but while strokes are added to a split of norm 2 they
/// are so within the solver's tolerance, until Settle.
///
/// Memory: two bytes a sample for labels; for each filter step the image before it; for each other
/// step or stroke its PackedDelta; while a split is under way the solver's (RandomWalker.h).
/// WORKER threads: one caller at a time, and nobody else changes the images.
class VTKHASPFILTERSSEGMENTATION_EXPORT Segmenter
{
public:
  /// Of a scan as hasp::ViewImage reads it, which is kept by reference and stays as it is.
  /// `labels`: what the steps begin with, unsigned char or unsigned short on the scan's grid,
  /// copied; nullptr: label 0 everywhere. Throws std::invalid_argument.
  explicit Segmenter(vtkImageData* scan, vtkImageData* labels = nullptr);
  ~Segmenter();

  /// Of splits from now on. The tolerance decides a voxel in some thousands (RandomWalker.h).
  void SetWalkerSettings(const RandomWalkerSettings& settings);

  /// Does a step behind those that are done, and settles the split before it. Returns the change of
  /// the labels, the settling's with it; none of a filter. Throws std::invalid_argument
  /// ("steps[3]: …": the step, or a filter behind a step that is none), std::runtime_error (a
  /// filter of VTK's failed), std::bad_alloc, Cancelled; image, labels and recipe are then as they
  /// were, but that the split before may be settled.
  LabelDelta Apply(const SegmentationStep& step, const ProgressFunction& progress = {});

  /// One more stroke of the last step, which must be a SplitStep. With norm 2 it begins where the
  /// strokes before it ended: a few cycles of the solver. Errors as Apply's.
  LabelDelta AddStroke(const BrushStroke& stroke, const ProgressFunction& progress = {});

  /// Solves the split that strokes were added to as if all had been there from the start. Nothing
  /// is changed, and it costs nothing, where none was. Throws Cancelled: nothing is settled then.
  LabelDelta Settle(const ProgressFunction& progress = {});
  bool IsSettled() const;

  /// Takes back the last step, or the last stroke that AddStroke added. Throws std::logic_error if
  /// nothing is done. O(voxels that change), and of a split's stroke one pass over the labels.
  LabelDelta Undo();
  bool CanUndo() const;
  /// Frees what would take back the steps before the last one: they stay done. Undo then ends
  /// there, and a stroke cannot be added to a split whose step is the last one again by Undo:
  /// std::logic_error.
  void ForgetUndo();
  /// Of all that can be taken back, but for images.
  std::size_t UndoBytes() const;

  /// The steps that are done; it has no names.
  const SegmentationRecipe& Recipe() const;
  /// Of the last Apply, AddStroke or Settle.
  const SegmentationFinding& Finding() const;
  /// As the filters left it: the scan itself where there are none.
  vtkImageData* Image() const;
  /// "Labels", unsigned short, on the scan's grid, extent and all. It is this one's own: copy it to
  /// keep what it is now.
  vtkImageData* Labels() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};

struct SegmentedScan
{
  vtkSmartPointer<vtkImageData> labels;      ///< with the LabelTable of all that occur, as named
  std::vector<SegmentationFinding> findings; ///< one a step
};

/// Gives labels (unsigned short) a LabelTable: these names; of other labels that occur the entry in
/// `given`, what those that the steps began with were called, or else UnnamedLabel.
VTKHASPFILTERSSEGMENTATION_EXPORT void NameLabels(
  vtkImageData* labels, const std::vector<LabelName>& names, const LabelTable& given = {});

/// All of a recipe at once; the same labels to the last bit as those of a Segmenter that is
/// settled. What a LabelTable of `labels` calls them stays, but where the recipe names them. Throws
/// as ValidateSegmentationRecipe, Segmenter and GetLabelTable do.
VTKHASPFILTERSSEGMENTATION_EXPORT SegmentedScan SegmentScan(vtkImageData* scan,
  const SegmentationRecipe& recipe, vtkImageData* labels = nullptr,
  const RandomWalkerSettings& settings = {}, const ProgressFunction& progress = {});

} // namespace hasp

#endif
