#include "Steps/GuidePanel.h"

#include "Steps/GuideBox.h"

#include <QVBoxLayout>

namespace hasp
{

GuidePanel::GuidePanel(Planner& planner, QWidget* parent)
  : StepPanel(planner, parent),
    Guides(new GuideBox(planner))
{
  auto* column = new QVBoxLayout(this);
  column->addWidget(this->Guides);
  column->addStretch(1);
}

GuidePanel::~GuidePanel()
{
  this->Of.tools.Take(nullptr); // while all that follows it is there
}

QString GuidePanel::StillNeeds() const
{
  return this->Of.plan.Now().volumes.empty() ? tr("Import a scan first.") : QString();
}

void GuidePanel::Leave()
{
  this->Of.tools.Take(nullptr);
}

} // namespace hasp
