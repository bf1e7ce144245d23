#pragma once
#include "Steps/StepPanel.h"

namespace hasp
{

class GuideBox;

/// Cutting guides. Widgets: GuideBox's.
class GuidePanel : public StepPanel
{
  Q_OBJECT
public:
  explicit GuidePanel(Planner& planner, QWidget* parent = nullptr);

  ~GuidePanel() override;

  QString Title() const override { return tr("Guide"); }
  QString StillNeeds() const override;
  void Leave() override;

private:
  GuideBox* Guides;
};

} // namespace hasp
