#include "Steps/ObjectChooser.h"

#include "Model/ObjectNames.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>

#include <algorithm>
#include <utility>

namespace hasp
{

namespace
{
constexpr int ButtonMargins = 20; // pixels, both
}

QString CalledWithName(const Plan& plan, PlanId object)
{
  std::string text = CalledObject(plan, object);
  ForEachPlanObject(plan,
    [&](const auto& each)
    {
      if (each.id == object && ObjectNames::IsGiven(each))
        text += ": " + each.name;
    });
  return QString::fromStdString(text);
}

ObjectChooser::ObjectChooser(
  Planner& planner, const QString& prefix, const QString& fresh, List list, QWidget* parent)
  : QWidget(parent),
    Of(planner),
    Objects(std::move(list)),
    Box(new QComboBox),
    Gone(new QPushButton(tr("&Remove")))
{
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  this->Box->setObjectName(prefix + ".choose");
  this->Box->setAccessibleName(tr("Which one"));
  this->Box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  row->addWidget(this->Box, 1);
  auto* add = new QPushButton(fresh);
  add->setObjectName(prefix + ".new");
  row->addWidget(add);
  this->Gone->setObjectName(prefix + ".remove");
  row->addWidget(this->Gone);
  for (QPushButton* button : { add, this->Gone }) // names need the room
    button->setMaximumWidth(
      button->fontMetrics().horizontalAdvance(button->text()) + ButtonMargins);
  connect(add, &QPushButton::clicked, this, &ObjectChooser::NewAsked);
  connect(this->Gone, &QPushButton::clicked, this, &ObjectChooser::Remove);
  connect(this->Box, qOverload<int>(&QComboBox::activated), this,
    [this](int item) { this->Choose(this->Box->itemData(item).toUInt()); });
  connect(&planner.plan, &PlanSession::Changed, this, &ObjectChooser::Follow);
  connect(&planner.scene, &PlanScene::SelectedChanged, this,
    [this](PlanId object)
    {
      const std::vector<PlanId> all = this->Objects(this->Of.plan.Now());
      if (std::find(all.begin(), all.end(), object) != all.end())
        this->Choose(object);
    });
  this->Follow();
}

void ObjectChooser::Choose(PlanId object)
{
  const bool other = object != this->Now;
  this->Now = object;
  this->Follow();
  if (!other)
    return;
  if (object != 0)
    this->Of.scene.Select(object);
  Q_EMIT this->ChosenChanged(this->Now);
}

void ObjectChooser::Follow()
{
  const Plan& plan = this->Of.plan.Now();
  this->Box->clear();
  this->Box->addItem(tr("none"), 0U);
  const PlanId before = std::exchange(this->Now, 0);
  for (const PlanId id : this->Objects(plan))
  {
    this->Box->addItem(CalledWithName(plan, id), id);
    if (id == before)
      this->Now = id;
  }
  this->Box->setCurrentIndex(this->Box->findData(this->Now));
  this->Gone->setEnabled(this->Now != 0);
  if (before != 0 && this->Now == 0)
    Q_EMIT this->ChosenChanged(0);
}

void ObjectChooser::Remove()
{
  if (this->Now != 0)
    this->Of.plan.Do(RemoveObject{ this->Now });
}

} // namespace hasp
