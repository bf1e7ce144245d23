#include "Window/WorkflowBar.h"

#include "Steps/StepPanel.h"

#include <QActionGroup>
#include <QToolButton>

namespace hasp
{

WorkflowBar::WorkflowBar(const std::vector<StepPanel*>& panels, QWidget* parent)
  : QToolBar(tr("Workflow"), parent),
    Panels(panels)
{
  this->setObjectName("workflow");
  this->setMovable(false);
  auto* group = new QActionGroup(this);
  for (std::size_t n = 0; n < panels.size(); ++n)
  {
    QAction* action = this->addAction(panels[n]->Title());
    action->setCheckable(true);
    action->setShortcut(QKeySequence(QString("Ctrl+%1").arg(n + 1)));
    action->setActionGroup(group);
    this->widgetForAction(action)->setObjectName("step." + panels[n]->objectName());
    this->connect(action, &QAction::triggered, this, [this, n] { Q_EMIT this->Chosen(int(n)); });
    this->Actions.push_back(action);
  }
  this->Refresh();
}

void WorkflowBar::Choose(int step)
{
  this->Actions.at(std::size_t(step))->setChecked(true);
}

void WorkflowBar::Refresh()
{
  for (std::size_t n = 0; n < this->Panels.size(); ++n)
  {
    const QString needs = this->Panels[n]->StillNeeds();
    QAction* action = this->Actions[n];
    // Steps come in any order: what is missing is said, and nothing is shut.
    action->setText(
      needs.isEmpty() ? this->Panels[n]->Title() : tr("%1 …").arg(this->Panels[n]->Title()));
    action->setToolTip(tr("%1 (%2)").arg(
      needs.isEmpty() ? this->Panels[n]->Title() : needs, action->shortcut().toString()));
  }
}

} // namespace hasp
