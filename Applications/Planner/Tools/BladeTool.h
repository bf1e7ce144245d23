#pragma once
#include "Planning/BladeHandles.h"
#include "Planning/Plan.h"
#include "Tools/Tool.h"
#include "Tools/ToolMarks.h"
#include "Tools/ViewMouse.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <optional>

class vtkMatrix4x4;
class vtkProp3D;

namespace hasp
{

struct Planner;

/// A cut's blade by its handles: the middle shifts it in its plane, the arrow along its normal,
/// corners turn it about its middle. The blade goes with the pointer; the plan has it when the drag
/// is over: one step. Any other drag is the view's.
///
/// Threads: RENDER. Cost while it is in hand: marks over the views, and frames while it is dragged.
class BladeTool : public Tool
{
  Q_OBJECT
public:
  explicit BladeTool(Planner& planner, QObject* parent = nullptr);
  ~BladeTool() override;

  void Begin() override;
  void End() override; ///< what is being dragged goes back
  QString Hint() const override;

  void SetCut(PlanId cut); ///< 0: none
  PlanId Cut() const { return this->Chosen; }

  /// A step of the plan: the blade of the cut as it is to be. False: refused, and why has been
  /// said.
  bool Put(const Osteotomy& blade);
  /// Where a handle is seen in a view: for tests and marks.
  std::optional<QPointF> PixelOf(FrameView& view, BladeHandle handle) const;

Q_SIGNALS:
  void Dragged(const hasp::Osteotomy& blade); ///< while it is

private:
  const PlanCut* Found() const;
  std::optional<Osteotomy> Shown() const; ///< as it is dragged, or as the plan has it
  std::optional<BladeHandle> At(FrameView& view, const QPointF& pixel) const;
  bool Press(FrameView& view, const QPointF& pixel);
  void Drag(FrameView& view, const QPointF& pixel);
  void Release();
  void MoveProp();
  void PutBack();
  void Paint(QPainter& painter, const MarkedView& view) const;
  void Follow();

  struct Held
  {
    BladeHandle handle;
    Osteotomy start, now;
    PointerRay from;
    vtkSmartPointer<vtkProp3D> prop;      ///< none: it is not shown
    vtkSmartPointer<vtkMatrix4x4> matrix; ///< its own
  };
  Planner& Of;
  PlanId Chosen = 0;
  std::optional<Held> Holds;
  ViewMouse Mouse;
  std::unique_ptr<ToolMarks> Marks; ///< while it is in hand
};

} // namespace hasp
