#pragma once
#include "Planning/SegmentationRecipe.h"
#include "Tools/PropCover.h"
#include "Tools/VtkFaults.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <QObject>
#include <QTimer>

#include <vector>

class vtkActor;
class vtkHaspClusteredCellMapper;
class vtkHaspSegmentationSession;
class vtkHaspStrokeActor;
class vtkImageData;

namespace hasp
{

struct Planner;

/// How the bone that is shown is shared out among the plan's strokes: what a
/// vtkHaspSegmentationSession makes of them on a WORKER of its own, on the bone and as strokes.
/// Follows the plan, so that undo and redo show: strokes that the plan has no more are taken back,
/// new ones are added, and a scan, a threshold or another way to split begins anew. Steps behind
/// the split (filled cavities, closed gaps) show when fragments are made of it.
///
/// While it is shown and there are strokes, or fragments in the way, the bone is this one's and
/// that of the scene is not seen. Threads: RENDER. Cost: nothing until Show; then
/// vtkHaspSegmentationSession's and a second set of active cells, until Release.
class PaintPreview : public QObject
{
  Q_OBJECT
public:
  explicit PaintPreview(Planner& planner, QObject* parent = nullptr);
  ~PaintPreview() override;

  void Show();
  void Hide();    ///< what has been worked out is kept
  void Release(); ///< and is no more

  /// The pieces of a drag that is under way; none: there is no such drag.
  void SetDrag(const std::vector<BrushStroke>& pieces);

  bool IsWorking() const;
  double Share() const; ///< of what is worked out now, [0, 1]
  /// The labels on the scan's grid, unsigned short; nullptr: there are none.
  vtkImageData* Labels() const;
  int Strokes() const; ///< that are shared out, or will be
  /// Waits until all strokes are shared out: for tests, and before a picture.
  void Finish();

Q_SIGNALS:
  void WorkChanged(); ///< IsWorking, Share
  void LabelsChanged();

private:
  struct Way ///< to split a scan; others begin anew
  {
    vtkSmartPointer<vtkImageData> scan;
    double lowest = 0.0, highest = 0.0, beta = 0.0, crack = 0.0, norm = 0.0;
    bool operator==(const Way&) const = default;
  };
  void Follow();
  void FollowStrokes(const std::vector<BrushStroke>& strokes);
  void ColourLabels(const std::vector<LabelName>& names);
  void Cover();
  void ShowStrokes();
  void Poll();
  void Tell(bool changed);

  Planner& Of;
  VtkFaults Faults;
  vtkSmartPointer<vtkHaspSegmentationSession> Session; ///< null: nothing is made
  vtkSmartPointer<vtkHaspClusteredCellMapper> Mapper;
  vtkSmartPointer<vtkActor> Bone;
  vtkSmartPointer<vtkHaspStrokeActor> Balls;
  std::vector<BrushStroke> Drag; ///< under way
  Way Now;
  vtkSmartPointer<vtkImageData> LabelMap; ///< of the session's image, shared
  QTimer Polling;
  PropCover Covered;
  bool Shown = false;
};

} // namespace hasp
