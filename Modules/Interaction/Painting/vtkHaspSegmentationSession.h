#ifndef vtkHaspSegmentationSession_h
#define vtkHaspSegmentationSession_h

#include "Grid/ResourceUse.h"                 // for ListResources
#include "vtkCommand.h"                       // for the events
#include "vtkHaspInteractionPaintingModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for Internals
#include <vector> // for strokes

class vtkHaspClusteredCellMapper;
class vtkHaspSeedPainter;
class vtkHaspStrokeActor;
class vtkImageData;

namespace hasp
{
struct BrushStroke;
struct SegmentationFinding;
struct SegmentationRecipe;
}

/**
 * @class   vtkHaspSegmentationSession
 * @brief   Splits bone while it is painted on: strokes of a painter become labels of a scan.
 *
 * Give it a scan, the painter whose strokes count, and the mapper that shows the bone. Each stroke
 * that ends goes into a split of the bone (hasp::Segmenter: what is within the threshold is shared
 * out among the labels of all strokes by a random walker). That is worked out on a WORKER while the
 * picture goes on turning and the next strokes are painted; when it is there the labels are written
 * into GetImage, and the mapper gets those of the cells in the box that has changed. Without
 * strokes nothing is worked out, and when the last one is taken back no voxel has a label.
 *
 *   2 to 9     which label is painted next
 *   Ctrl + Z   takes the last drag back, all its pieces, worked out or not; or cancels the one that
 *              is painted
 *   Escape     gives up all that is not shown yet
 *
 * These while the painter is enabled. Labels come with a timer of its interactor, which is there
 * while there is work; who has none (no display, a loop of one's own) calls Update once a frame, or
 * Finish.
 *
 * Events, on this: LabelsChangedEvent (call data: int[6], the box of point indices that holds all
 * that has changed), WorkStartedEvent and WorkEndedEvent. Within the first, image and mapper are
 * already as they will be drawn.
 *
 * The labels are those that GetRecipe makes of the scan, to the last bit; with norm 2 after Settle
 * alone, and before, the walker's tolerance decides a voxel in some thousands. Limits: each piece
 * of a drag is solved for by itself; while a session has a scan, its samples stay as they are.
 *
 * Threads: RENDER; the work runs on a WORKER of its own (hasp::EditThread). Painter, mapper and
 * strokes' actor are held weakly. Errors: vtkErrorMacro, and nothing changes: a scan that cannot be
 * read, a stroke of label 0 (an eraser's), and whatever a stroke or a setting is refused for, which
 * is known when it is worked out. Where there is no memory to take a drag back its labels stay
 * until the next drag or Undo. Labels that somebody else wrote into the image are gone with the
 * next change: then all are shown anew, and that is said. Memory: 2 bytes a sample shown; from the
 * first stroke on 2 more, the undo's, and the solver's (LabelSplit.h).
 */
class VTKHASPINTERACTIONPAINTING_EXPORT vtkHaspSegmentationSession : public vtkObject
{
public:
  static vtkHaspSegmentationSession* New();
  vtkTypeMacro(vtkHaspSegmentationSession, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Events
  {
    LabelsChangedEvent = vtkCommand::UserEvent + 7401,
    WorkStartedEvent,
    WorkEndedEvent
  };

  /** Forgets all strokes and begins anew, without labels. Null: no scan, strokes do nothing. False
   * after an error. */
  bool SetScan(vtkImageData* scan);
  /** The scan's samples, and its labels as they are shown: a point array "Labels", unsigned short,
   * in place of one that has that name. Null without a scan. */
  vtkImageData* GetImage() const;

  /** Whose drags are split from now on; null: nobody's. */
  void SetPainter(vtkHaspSeedPainter* painter);
  /** Draws GetImage with its labels; labels of strokes that it has no colour for get
   * hasp::PaletteColour's. Null: none. Its isovalue is its own. */
  void SetMapper(vtkHaspClusteredCellMapper* mapper);
  /** Shows the strokes that count, and the one that is painted. Null: none. */
  void SetStrokeActor(vtkHaspStrokeActor* actor);

  ///@{
  /** Bone is lowest <= value <= highest; of the first stroke's split, so it counts when that is
   * painted. Default 226 and 1e6, each within [-1e6, 1e6]. */
  vtkSetMacro(LowestBone, double);
  vtkGetMacro(LowestBone, double);
  vtkSetMacro(HighestBone, double);
  vtkGetMacro(HighestBone, double);
  ///@}
  ///@{
  /** How much an edge of the image parts fragments, [0, 1e12]; likewise. Default 90. */
  vtkSetMacro(Beta, double);
  vtkGetMacro(Beta, double);
  ///@}
  ///@{
  /** How deep a dark line parts them, of bone's grey, [0, 1], 0: none does; likewise. Default 0.1.
   */
  vtkSetMacro(Crack, double);
  vtkGetMacro(Crack, double);
  ///@}
  ///@{
  /** 1: borders keep to edges and cracks (least cut); 2: they go through the middle, too (random
   * walk); [1, 2]; likewise. Default 1. */
  vtkSetMacro(Norm, double);
  vtkGetMacro(Norm, double);
  ///@}

#ifndef __VTK_WRAP__
  /** A drag's pieces, as a painter's that ends. False after an error. */
  bool AddStrokes(const std::vector<hasp::BrushStroke>& pieces);
  /** That count, in order: worked out or not. */
  std::vector<hasp::BrushStroke> GetStrokes() const;
  /** What makes these labels of the scan. Waits for the work. */
  hasp::SegmentationRecipe GetRecipe();
  /** Of the last drag whose labels are shown. */
  const hasp::SegmentationFinding& GetFinding() const;
  void ListResources(hasp::ResourceList& resources) const;
#endif
  /** Drags that count, worked out or not. */
  int GetNumberOfDrags() const;

  /** Takes the last drag back. False: there is none. */
  bool Undo();
  /** Gives up every drag that is not shown yet. */
  void Cancel();
  /** Is anything worked out now, or waiting for it? */
  bool IsWorking() const;
  /** Of what is worked out now, [0, 1]. */
  double GetProgress() const;

  /** Shows what has been worked out since. True if labels have changed. Never waits, but where all
   * are shown anew. */
  bool Update();
  /** Waits until all is worked out, and shows it. True if labels have changed. */
  bool Finish();
  /** Finish, then solves as if all strokes had been there from the start. True if labels have
   * changed. For files; as long as the first stroke takes. */
  bool Settle();

protected:
  vtkHaspSegmentationSession();
  ~vtkHaspSegmentationSession() override;

private:
  vtkHaspSegmentationSession(const vtkHaspSegmentationSession&) = delete;
  void operator=(const vtkHaspSegmentationSession&) = delete;

  struct Internals;
  friend struct Internals;
  double LowestBone = 226.0;
  double HighestBone = 1e6;
  double Beta = 90.0, Crack = 0.1, Norm = 1.0;
  std::unique_ptr<Internals> Self;
};

#endif
