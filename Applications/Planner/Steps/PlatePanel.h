#pragma once
#include "Steps/StepPanel.h"

class QComboBox;
class QStackedWidget;

namespace hasp
{

/// What is put in: plates, implants, transplants and the guides for their donors. Widgets:
/// plate.kind (pages), PlateBox's, ImplantBox's, TransplantBox's, MitreBox's.
class PlatePanel : public StepPanel
{
  Q_OBJECT
public:
  explicit PlatePanel(Planner& planner, QWidget* parent = nullptr);

  ~PlatePanel() override;

  QString Title() const override { return tr("Plate"); }
  QString StillNeeds() const override;
  void Leave() override;

private:
  void Turn(int page);

  QComboBox* Kind;
  QStackedWidget* Pages;
};

} // namespace hasp
