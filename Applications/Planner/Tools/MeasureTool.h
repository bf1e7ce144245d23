#pragma once
#include "Planning/Plan.h"
#include "Tools/Tool.h"
#include "Tools/ToolMarks.h"
#include "Tools/Touch.h"
#include "Tools/ViewMouse.h"

#include <memory>
#include <vector>

namespace hasp
{

struct Planner;

/// Distances and angles by touching: two clicks, or three with the angle at the second. The last
/// one makes the measure: one step of the plan, whose points go where their fragments go. Then the
/// next one begins. Insert takes the crosshair's place, Delete the last place back.
///
/// Threads: RENDER. Cost while it is in hand: marks over the views, and a pick for each click.
class MeasureTool : public Tool
{
  Q_OBJECT
public:
  explicit MeasureTool(Planner& planner, QObject* parent = nullptr);
  ~MeasureTool() override;

  /// Takes it in hand, for a measure of this kind.
  void Start(MeasureKind kind);
  MeasureKind Kind() const { return this->Now; }

  void Begin() override;
  void End() override; ///< a measure that is not finished is forgotten
  QString Hint() const override;

  bool TouchCrosshair(); ///< false: no scan is shown
  const std::vector<TouchedPlace>& Places() const { return this->All; }

Q_SIGNALS:
  void Measured(hasp::PlanId measure);

private:
  bool Add(const std::optional<TouchedPlace>& place);
  void Finish();
  void Paint(QPainter& painter, const MarkedView& view) const;
  void Update();

  Planner& Of;
  MeasureKind Now = MeasureKind::Distance;
  std::vector<TouchedPlace> All;
  ViewMouse Mouse;
  std::unique_ptr<ToolMarks> Marks; ///< while it is in hand
};

} // namespace hasp
