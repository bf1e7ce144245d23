#ifndef SessionInternals_h
#define SessionInternals_h

#include "CellLabels.h"
#include "SplitWork.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspSeedPainter.h"
#include "vtkHaspSegmentationSession.h"
#include "vtkHaspStrokeActor.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkUnsignedShortArray.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <list>
#include <memory>
#include <vector>

/// What vtkHaspSegmentationSession.cxx (what is said) and SessionEvents.cxx (what painter,
/// interactor and work tell) share. Threads: RENDER.
struct vtkHaspSegmentationSession::Internals
{
  struct Drag
  {
    std::uint64_t number = 0;
    std::vector<hasp::BrushStroke> pieces;
    bool shown = false; ///< its labels are in the image
  };

  explicit Internals(vtkHaspSegmentationSession* of);
  ~Internals();

  void Begin(vtkImageData* scan); ///< throws std::invalid_argument, and nothing changes
  bool Take(std::list<hasp::SplitOutcome> outcomes);
  /// Makes their changes; the box that changes. Where one does not fit the labels, because somebody
  /// else wrote into them, all are shown anew: then it waits for the work.
  hasp::VoxelBox Change(std::list<hasp::SplitOutcome>& outcomes);
  void Note(hasp::SplitOutcome& outcome); ///< what has become of its drag
  void SetUpMapper();
  void ColourLabels(const std::vector<hasp::BrushStroke>& strokes);
  void ShowStrokes();

  void Listen(vtkHaspSeedPainter* whose);
  void Heard(unsigned long event); ///< the painter's
  void Follow(vtkRenderWindowInteractor* whose);
  bool Handle(unsigned long event, void* data); ///< the interactor's; true: nobody else's
  void Working();                               ///< there is work, or was a moment ago
  void Rested();                                ///< there is none
  void BeginTimer();
  void EndTimer();

  vtkHaspSegmentationSession* const session;
  vtkSmartPointer<vtkImageData> image;
  vtkSmartPointer<vtkUnsignedShortArray> labels; ///< of it
  std::unique_ptr<hasp::SplitWork> work;         ///< null without a scan
  std::vector<Drag> drags;
  std::uint64_t last = 0; ///< number of a drag
  hasp::SegmentationFinding finding;
  std::size_t undoBytes = 0;

  vtkWeakPointer<vtkHaspSeedPainter> painter;
  vtkWeakPointer<vtkHaspClusteredCellMapper> mapper;
  vtkWeakPointer<vtkHaspStrokeActor> actor;
  vtkWeakPointer<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkCallbackCommand> strokes; ///< follows the painter
  vtkNew<vtkCallbackCommand> command; ///< follows the interactor
  int timerId = 0;
  bool working = false;       ///< as was said last
  std::uint64_t requests = 0; ///< so many in all
};

#endif
