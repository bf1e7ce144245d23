#include "Steps/PlatePanel.h"

#include "Planning/PlanLists.h"
#include "Steps/ImplantBox.h"
#include "Steps/MitreBox.h"
#include "Steps/PlateBox.h"
#include "Steps/TransplantBox.h"

#include <QTabWidget>

namespace hasp
{

PlatePanel::PlatePanel(Planner& planner, QWidget* parent)
  : StepPanel(planner, parent),
    Pages(new QTabWidget)
{
  auto* column = new QVBoxLayout(this);
  this->Pages->setObjectName("plate.kind");
  this->Pages->addTab(new PlateBox(planner), tr("Plates"));
  this->Pages->addTab(new ImplantBox(planner), tr("Implants"));
  this->Pages->addTab(new TransplantBox(planner), tr("Transplants"));
  this->Pages->addTab(new MitreBox(planner), tr("Saw guides"));
  this->Pages->setUsesScrollButtons(true);
  column->addWidget(this->Pages);
  column->addStretch(1);
  // What is chosen in the scene is shown.
  connect(&planner.scene, &PlanScene::SelectedChanged, this,
    [this](PlanId object)
    {
      const Plan& plan = this->Of.plan.Now();
      if (FindPlanObject<PlanPlate>(plan, object))
        this->Pages->setCurrentIndex(0);
      else if (FindPlanObject<PlanImplant>(plan, object))
        this->Pages->setCurrentIndex(1);
      else if (FindPlanObject<PlanTransplant>(plan, object))
        this->Pages->setCurrentIndex(2);
      else if (FindPlanObject<PlanMitreGuide>(plan, object))
        this->Pages->setCurrentIndex(3);
    });
}

PlatePanel::~PlatePanel()
{
  this->Of.tools.Take(nullptr); // while all that follows it is there
}

QString PlatePanel::StillNeeds() const
{
  return this->Of.plan.Now().volumes.empty() ? tr("Import a scan first.") : QString();
}

void PlatePanel::Leave()
{
  this->Of.tools.Take(nullptr);
}

} // namespace hasp
