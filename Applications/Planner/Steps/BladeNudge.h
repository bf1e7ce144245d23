#pragma once
#include "Planning/Osteotomy.h"

#include <QWidget>

#include <functional>

class QDoubleSpinBox;
class QFormLayout;

namespace hasp
{

/// Shifts and turns a blade by numbers: what its handles do, for who has no pointer. A number that
/// is typed is done and is 0 again.
///
/// Widgets: cut.shift.along, cut.shift.across, cut.shift.normal (mm), cut.turn.along,
/// cut.turn.across, cut.turn.normal (degrees about that axis). Threads: RENDER.
class BladeNudge : public QWidget
{
  Q_OBJECT
public:
  explicit BladeNudge(QWidget* parent = nullptr);

  std::function<Osteotomy()> blade; ///< as it is

Q_SIGNALS:
  void Nudged(const hasp::Osteotomy& blade);

private:
  enum class Way
  {
    Shift,
    Turn
  };
  void Add(QFormLayout* form, const QString& name, const QString& label, Way way, int axis);
  void Nudge(QDoubleSpinBox* box, Way way, int axis);
};

} // namespace hasp
