#ifndef SplitWork_h
#define SplitWork_h

#include "Grid/Progress.h"
#include "Planning/SegmentationRecipe.h"
#include "Realtime/EditThread.h"
#include "Segmentation/LabelDelta.h"
#include "Segmenter.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace hasp
{

/// What has become of a drag, or of taking one back.
struct SplitOutcome
{
  std::uint64_t drag = 0;
  bool done = false;               ///< false: failed, given up or taken back
  std::vector<LabelDelta> changes; ///< to be made in this order
  SegmentationFinding finding;     ///< of what is done
  std::string error;               ///< why it failed; empty: it did not
  std::size_t undoBytes = 0;
};

/// A drag that is to be split, and what counts if it is the first one.
struct SplitDrag
{
  std::uint64_t number = 0; ///< ascending
  std::vector<BrushStroke> pieces;
  ThresholdStep bone;
  double beta = 90.0, crack = 0.1, norm = 1.0; ///< of a SplitStep
};

/// A Segmenter that splits a scan's bone drag by drag on a WORKER.
///
/// Threads: RENDER owns it. The Segmenter is the WORKER's, but after Wait RENDER's until the next
/// call. Outcomes are what comes back.
class SplitWork
{
public:
  /// Keeps the samples of `scan`, which stay as they are.
  explicit SplitWork(vtkImageData* scan);

  /// Throws std::system_error.
  void Add(SplitDrag drag);
  /// The last one that was added and not taken back; whatever has become of it.
  void TakeBack(std::uint64_t number);
  std::vector<SplitOutcome> TakeOutcomes();

  bool Idle() const { return this->Thread.Idle(); }
  double Share() const { return this->Thread.Share(); }
  void Wait() const { this->Thread.Wait(); }
  /// After Wait, and until the next Add or TakeBack. Null before the first drag.
  Segmenter* Made() { return this->Splitter.get(); }

private:
  bool Split(const SplitDrag& drag, const ProgressFunction& progress);
  void Undo(std::uint64_t number);
  void Publish(SplitOutcome outcome);

  // The WORKER's.
  vtkSmartPointer<vtkImageData> Scan;
  std::unique_ptr<Segmenter> Splitter;
  struct Done
  {
    std::uint64_t drag;
    int entries; ///< of the Segmenter's undo
  };
  std::vector<Done> Drags;

  std::mutex Guard;
  std::vector<SplitOutcome> Outcomes;
  EditThread Thread; ///< last: it ends before what it writes goes
};

} // namespace hasp

#endif
