#pragma once
#include "Planning/GuideRecipe.h"
#include "Tools/Tool.h"
#include "Tools/ToolMarks.h"
#include "Tools/Touch.h"
#include "Tools/ViewMouse.h"

#include <memory>
#include <optional>
#include <vector>

namespace hasp
{

struct Planner;

/// Paints an area on bone: a drag that begins on bone, in 3D or in a slice, is a stroke of a round
/// brush, or wipes off; any other drag is the view's. Insert dabs at the crosshair. Nobody is told
/// of a stroke until it is over.
///
/// Threads: RENDER. Cost while it is in hand: marks over the views, and a pick for each step of a
/// stroke.
class AreaTool : public Tool
{
  Q_OBJECT
public:
  explicit AreaTool(Planner& planner, QObject* parent = nullptr);
  ~AreaTool() override;

  void Begin() override;
  void End() override; ///< a stroke that is not over is forgotten
  QString Hint() const override;

  void SetErases(bool erases); ///< strokes to come
  bool Erases() const { return this->Wipes; }
  double radiusMm = 5.0; ///< of strokes to come, (0, 100]

  /// That are marked, where their bone is seen (0: the scan itself); nobody is told.
  void SetStrokes(std::vector<GuideStroke> strokes, PlanId bone);
  bool DabCrosshair(); ///< false: no scan is shown

Q_SIGNALS:
  /// In the scan; `first`: where it began.
  void Painted(const hasp::GuideStroke& stroke, const hasp::TouchedPlace& first);

private:
  std::optional<TouchedPlace> BoneAt(FrameView& view, const QPointF& pixel) const;
  bool Press(FrameView& view, const QPointF& pixel);
  void Drag(FrameView& view, const QPointF& pixel);
  void Release();
  void Paint(QPainter& painter, const MarkedView& view) const;
  void Update();

  Planner& Of;
  bool Wipes = false;
  std::vector<GuideStroke> All;
  PlanId Bone = 0;                ///< theirs
  std::optional<GuideStroke> Now; ///< that is being painted
  TouchedPlace First;
  ViewMouse Mouse;
  std::unique_ptr<ToolMarks> Marks; ///< while it is in hand
};

} // namespace hasp
