#include "Window/StartHint.h"

#include "Tools/Planner.h"

#include <QVBoxLayout>

namespace hasp
{

StartHint::StartHint(Planner& planner) : Of(planner)
{
  this->setObjectName("start.hint");
  this->setText(
    tr("Open a scan in the step Import, or drop a file or a folder here; without a scan "
       "of your own: File, Try it on a sample."));
  this->setWordWrap(true);
  this->setAlignment(Qt::AlignCenter);
  this->setStyleSheet("color: white; background: transparent; font-size: 13pt;");
  this->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored); // no view is larger for it
  auto* over = new QVBoxLayout(&planner.views.Scene());
  over->addWidget(this);
  connect(&planner.plan, &PlanSession::Changed, this, &StartHint::Follow);
  this->Follow();
}

void StartHint::Follow()
{
  const Plan& plan = this->Of.plan.Now();
  this->setVisible(plan.volumes.empty() && plan.surfaces.empty());
}

} // namespace hasp
