#pragma once
#include "Tools/AreaTool.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace hasp
{

/// The area of a guide that is painted on bone, besides its outline.
/// Widgets: guide.paint, guide.wipe (each takes the brush in hand), guide.brush (its radius, mm),
/// guide.paint.crosshair, guide.paint.clear, guide.paint.count. Threads: RENDER.
class PaintedArea : public QWidget
{
  Q_OBJECT
public:
  explicit PaintedArea(Planner& planner, QWidget* parent = nullptr);

  void SetStrokes(const std::vector<GuideStroke>& strokes, PlanId bone); ///< as the plan has them
  const std::vector<GuideStroke>& Strokes() const { return this->All; }

Q_SIGNALS:
  void Painted(const hasp::TouchedPlace& first); ///< one stroke more
  void Cleared();

protected:
  void hideEvent(QHideEvent* event) override; ///< puts it away: another page is turned to

private:
  void Take(bool wipe, bool on);

  Planner& Of;
  AreaTool Brush;
  std::vector<GuideStroke> All;
  QPushButton *Paint, *Wipe;
  QDoubleSpinBox* Radius;
  QLabel* Count;
};

} // namespace hasp
