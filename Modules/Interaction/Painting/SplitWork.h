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
#include <list>
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
  std::vector<LabelDelta> changes; ///< to be made in this order, whether or not it is done
  SegmentationFinding finding;     ///< of what is done
  std::string error;               ///< why it failed; empty: it did not
  bool owed = false; ///< memory ended while it was taken back: the next drag or undo does the rest
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

/// A Segmenter that splits a scan's bone drag by drag on a WORKER. The changes of all outcomes are
/// all that the Segmenter has done. What there is no memory to take back is taken back before the
/// next drag is split, or with the next one that is taken back: the outcome of that has the change.
///
/// Threads: RENDER owns it. The Segmenter is the WORKER's, but after Wait RENDER's until the next
/// call. Outcomes are what comes back.
class SplitWork
{
public:
  /// Keeps the samples of `scan`, which stay as they are.
  explicit SplitWork(vtkImageData* scan);

  /// Throws std::system_error, std::bad_alloc; nothing is added then.
  void Add(SplitDrag drag);
  /// The last one that was added and not taken back; whatever has become of it.
  void TakeBack(std::uint64_t number);
  std::list<SplitOutcome> TakeOutcomes();

  bool Idle() const { return this->Thread.Idle(); }
  double Share() const { return this->Thread.Share(); }
  void Wait() const { this->Thread.Wait(); }
  /// After Wait, and until the next Add or TakeBack. Null before the first drag.
  Segmenter* Made() { return this->Splitter.get(); }

private:
  bool Split(const SplitDrag& drag, const ProgressFunction& progress);
  void Make(const SplitDrag& drag, SplitOutcome& outcome, const ProgressFunction& progress);
  void GiveUp(SplitOutcome& outcome, std::size_t before);
  void Undo(std::uint64_t number);
  void TakeBackOwed(std::vector<LabelDelta>& changes);
  std::list<SplitOutcome> Reply(std::uint64_t number);
  void Publish(std::list<SplitOutcome>& reply);

  // The WORKER's.
  vtkSmartPointer<vtkImageData> Scan;
  std::unique_ptr<Segmenter> Splitter;
  struct Done
  {
    std::uint64_t drag;
    int entries = 0;   ///< of the Segmenter's undo
    bool owed = false; ///< is to be taken back
  };
  std::vector<Done> Drags;

  std::mutex Guard;
  std::list<SplitOutcome> Outcomes;
  std::list<SplitOutcome> Replies; ///< empty ones: two a drag, so that none wants memory later
  EditThread Thread;               ///< last: it ends before what it writes goes
};

} // namespace hasp

#endif
