#include "Output/RedParts.h"

#include "Tools/Planner.h"

namespace hasp
{

RedParts& RedParts::Of(Planner& planner)
{
  RedParts* parts = planner.findChild<RedParts*>(QString(), Qt::FindDirectChildrenOnly);
  return parts ? *parts : *new RedParts(planner); // the planner deletes it
}

RedParts::RedParts(Planner& planner) : QObject(&planner), Owner(planner)
{
  connect(&planner.plan, &PlanSession::Replaced, this,
    [this]
    {
      ++this->Plans;
      this->Parts.clear();
      Q_EMIT this->Changed();
    });
}

const RedParts::Part* RedParts::Find(PlanId object) const
{
  const auto found = this->Parts.find(object);
  const Plan& plan = this->Owner.plan.Now();
  if (found == this->Parts.end() || !IsPartObject(plan, object) ||
      PartInputs(plan, object) != found->second.inputs)
    return nullptr;
  return &found->second;
}

void RedParts::Put(PlanId object, Part part)
{
  this->Parts.insert_or_assign(object, std::move(part));
  Q_EMIT this->Changed();
}

void RedParts::Drop(PlanId object)
{
  if (this->Parts.erase(object) > 0)
    Q_EMIT this->Changed();
}

} // namespace hasp
