#include "Steps/PlatePanel.h"

#include "Planning/PlanLists.h"
#include "Steps/ImplantBox.h"
#include "Steps/MitreBox.h"
#include "Steps/PlateBox.h"
#include "Steps/TransplantBox.h"

#include <QComboBox>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace hasp
{

PlatePanel::PlatePanel(Planner& planner, QWidget* parent)
  : StepPanel(planner, parent),
    Kind(new QComboBox),
    Pages(new QStackedWidget)
{
  auto* column = new QVBoxLayout(this);
  this->Kind->setObjectName("plate.kind");
  this->Kind->setAccessibleName(tr("What is planned"));
  column->addWidget(this->Kind);
  column->addWidget(this->Pages);
  column->addStretch(1);
  const auto add = [this](QWidget* box, const QString& title)
  {
    this->Kind->addItem(title);
    this->Pages->addWidget(box);
  };
  add(new PlateBox(planner), tr("Plates"));
  add(new ImplantBox(planner), tr("Implants"));
  add(new TransplantBox(planner), tr("Transplants"));
  add(new MitreBox(planner), tr("Saw guides for transplants"));
  connect(this->Kind, qOverload<int>(&QComboBox::activated), this, &PlatePanel::Turn);
  // What is chosen in the scene is shown.
  connect(&planner.scene, &PlanScene::SelectedChanged, this,
    [this](PlanId object)
    {
      const Plan& plan = this->Of.plan.Now();
      if (FindPlanObject<PlanPlate>(plan, object))
        this->Turn(0);
      else if (FindPlanObject<PlanImplant>(plan, object))
        this->Turn(1);
      else if (FindPlanObject<PlanTransplant>(plan, object))
        this->Turn(2);
      else if (FindPlanObject<PlanMitreGuide>(plan, object))
        this->Turn(3);
    });
  this->Turn(0);
}

/// Only as high as the page that is shown.
void PlatePanel::Turn(int page)
{
  if (page != this->Pages->currentIndex() && this->isVisible())
    this->Of.tools.Take(nullptr); // of the page before
  for (int n = 0; n < this->Pages->count(); ++n)
    this->Pages->widget(n)->setSizePolicy(
      QSizePolicy::Preferred, n == page ? QSizePolicy::Preferred : QSizePolicy::Ignored);
  this->Kind->setCurrentIndex(page);
  this->Pages->setCurrentIndex(page);
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
