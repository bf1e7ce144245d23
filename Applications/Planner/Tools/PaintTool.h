#pragma once
#include "Tools/PaintPreview.h"
#include "Tools/Tool.h"

#include "vtkCallbackCommand.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <vector>

class vtkHaspSeedPainter;
class vtkImageSlice;

namespace hasp
{

class FrameView;
struct Planner;

/// Paints on bone, in the 3D view and in the slices, which fragment it is of. Each drag is one step
/// of the plan: strokes of the split of its painted segmentation (StrokeEdits.h), which the first
/// drag makes; with the eraser the strokes that it went over are gone. The bone is then shared out
/// among all strokes (PaintPreview). Shift and the wheel, + and -, change the brush.
///
/// Threads: RENDER. Cost: as PaintPreview; painters while it is in hand.
class PaintTool : public Tool
{
  Q_OBJECT
public:
  explicit PaintTool(Planner& planner, QObject* parent = nullptr);
  ~PaintTool() override;

  void Begin() override;
  void End() override; ///< the labels are not shown any more, but kept until Preview().Release()
  QString Hint() const override;

  ///@{
  void SetLabel(int label); ///< [1, 65535]
  int Label() const { return this->Now; }
  void SetEraser(bool erases);
  bool IsEraser() const { return this->Erases; }
  void SetRadius(double mm); ///< [0.1, 50]
  double Radius() const { return this->RadiusMm; }
  ///@}
  /// What labels are called and how they are drawn: goes into the segmentation that a first drag
  /// makes.
  void SetNames(const std::vector<LabelName>& names);

  /// A ball of the brush at a place of the world: what a drag does, for who has no pointer. False:
  /// no scan is shown, or the plan has refused it.
  bool PaintAt(const glm::dvec3& place);

  PaintPreview& Preview() { return this->Shown; }

Q_SIGNALS:
  void RadiusChanged(double mm); ///< also by the wheel

private:
  struct Canvas
  {
    FrameView* view;
    vtkImageSlice* slice; ///< nullptr: surfaces
    vtkSmartPointer<vtkHaspSeedPainter> painter;
  };
  void SetUp(vtkHaspSeedPainter& painter) const;
  void Heard(vtkHaspSeedPainter& painter, unsigned long event);
  bool Take(const std::vector<BrushStroke>& pieces);
  void LookBeforePress();

  Planner& Of;
  VtkFaults Faults;
  PaintPreview Shown;
  vtkNew<vtkCallbackCommand> Command, BeforePress;
  std::vector<Canvas> Canvases; ///< while it is in hand
  std::vector<LabelName> Names;
  int Now = 2;
  bool Erases = false;
  double RadiusMm = 2.0;
};

} // namespace hasp
