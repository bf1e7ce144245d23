#include "Steps/ObjectChecks.h"

#include "Steps/ObjectChooser.h"
#include "Steps/PanelWidgets.h"

#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace hasp
{

ObjectChecks::ObjectChecks(const QString& prefix, const QString& none, QWidget* parent)
  : QWidget(parent),
    Prefix(prefix),
    Column(new QVBoxLayout(this)),
    None(new QLabel(none))
{
  this->Column->setContentsMargins(0, 0, 0, 0);
  this->None->setWordWrap(true);
  this->Column->addWidget(this->None);
}

void ObjectChecks::Show(
  const Plan& plan, const std::vector<PlanId>& all, const std::vector<PlanId>& ticked)
{
  // Boxes of objects that stay, stay: one of them may have the keyboard.
  std::erase_if(this->Boxes,
    [&](const auto& box)
    {
      const bool gone = std::find(all.begin(), all.end(), box.first) == all.end();
      if (gone)
        box.second->deleteLater();
      return gone;
    });
  for (const PlanId id : all)
  {
    auto found = std::find_if(
      this->Boxes.begin(), this->Boxes.end(), [&](const auto& box) { return box.first == id; });
    if (found == this->Boxes.end())
    {
      auto* box = new QCheckBox;
      box->setObjectName(this->Prefix + '.' + QString::number(id));
      connect(box, &QCheckBox::clicked, this, &ObjectChecks::Edited);
      this->Column->addWidget(box);
      PutInTabOrder(this, box);
      found = this->Boxes.insert(this->Boxes.end(), { id, box });
    }
    found->second->setText(CalledWithName(plan, id));
    found->second->setChecked(std::find(ticked.begin(), ticked.end(), id) != ticked.end());
  }
  std::sort(this->Boxes.begin(), this->Boxes.end());
  this->None->setVisible(this->Boxes.empty());
}

std::vector<PlanId> ObjectChecks::Ticked() const
{
  std::vector<PlanId> ids;
  for (const auto& [id, box] : this->Boxes)
    if (box->isChecked())
      ids.push_back(id);
  return ids;
}

} // namespace hasp
