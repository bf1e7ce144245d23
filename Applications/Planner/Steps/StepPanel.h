#pragma once
#include "Tools/Planner.h"

#include <QString>
#include <QWidget>

namespace hasp
{

/// What a surgeon does at one step of the workflow; at the window's right while the step is chosen.
/// Steps come in any order; each says what it still needs.
class StepPanel : public QWidget
{
  Q_OBJECT
public:
  StepPanel(Planner& planner, QWidget* parent) : QWidget(parent), Of(planner) {}
  virtual QString Title() const = 0; ///< "Cut"
  /// "Import a scan first." Empty: it can be worked on.
  virtual QString StillNeeds() const = 0;
  virtual void Enter() {} ///< it is shown from now on
  virtual void Leave() {} ///< not any more: its tool is put away

protected:
  Planner& Of;
};

} // namespace hasp
