#include "Steps/PartStatus.h"

#include "Output/PartMaking.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace hasp
{

PartStatus::PartStatus(Planner& planner, const QString& prefix, QWidget* parent)
  : QWidget(parent),
    Of(planner),
    Line(new QLabel),
    Make(new QPushButton(tr("Ma&ke")))
{
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  this->Line->setObjectName(prefix + ".status");
  this->Line->setWordWrap(true);
  row->addWidget(this->Line, 1);
  this->Make->setObjectName(prefix + ".make");
  this->Make->setToolTip(tr("Make the part, and measure whether it holds what is asked of it"));
  row->addWidget(this->Make);
  connect(this->Make, &QPushButton::clicked, this, [this] { MakePart(this->Of, this->Now); });
  connect(&planner.plan, &PlanSession::Changed, this, &PartStatus::Refresh);
  connect(&planner.plan, &PlanSession::PartsChanged, this, &PartStatus::Refresh);
  this->Refresh();
}

void PartStatus::Show(PlanId object)
{
  this->Now = object;
  this->Refresh();
}

void PartStatus::Refresh()
{
  const bool there = PlanNoun(this->Of.plan.Now(), this->Now) != nullptr;
  this->Make->setEnabled(there);
  if (!there)
    return this->Line->setText(tr("Not in the plan yet."));
  const QString why = this->Of.plan.WhyNot(this->Now);
  this->Line->setText(why.isEmpty() ? tr("In date.") : why + QStringLiteral("."));
}

} // namespace hasp
