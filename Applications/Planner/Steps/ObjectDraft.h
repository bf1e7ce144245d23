#pragma once
#include "Model/ObjectNames.h"
#include "Planning/PlanEdits.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"

#include <QString>

#include <stdexcept>
#include <utility>

namespace hasp
{

/// The object that a form shows: as the plan has it, or with what has been typed and is not in the
/// plan, because it is not finished or not legal. A new object is one without an id, until the plan
/// takes it; then it has a name, too. Threads: RENDER.
template <typename T>
class ObjectDraft
{
public:
  explicit ObjectDraft(Planner& planner) : Of(planner) {}

  bool IsShown() const { return this->Shows; } ///< there is one
  bool IsNew() const { return this->Shows && this->Object.id == 0; }
  PlanId Id() const { return this->Shows ? this->Object.id : 0; }
  T& Typed() { return this->Object; }
  const T& Typed() const { return this->Object; }

  void Begin(T fresh)
  {
    fresh.id = 0;
    this->Object = this->Base = std::move(fresh);
    this->Shows = true;
  }
  void Show(PlanId id)
  {
    const T* found = FindPlanObject<T>(this->Of.plan.Now(), id);
    this->Shows = found != nullptr;
    this->Object = this->Base = found ? *found : T{};
  }
  /// The plan is another. True: what is shown is another, too; what was typed and not taken is
  /// gone.
  bool Follow()
  {
    if (!this->Shows || this->Object.id == 0)
      return false;
    const T* found = FindPlanObject<T>(this->Of.plan.Now(), this->Object.id);
    if (found && *found == this->Base)
      return false;
    this->Show(this->Object.id);
    return true;
  }

  /// Why the plan would not take it as it is; empty: it would.
  QString Fault() const
  {
    try
    {
      Apply(this->Of.plan.Now(), this->EditOf(this->WithId(0)));
      return {};
    }
    catch (const std::invalid_argument& error)
    {
      return QString::fromStdString(error.what());
    }
  }
  /// One step of the plan, unless it is there as it is. False: refused. `before` come before it in
  /// the same step: new objects that it names.
  bool Put(const QString& label, std::vector<PlanEdit> before = {})
  {
    if (!this->Shows || (this->Object.id != 0 && this->Object == this->Base && before.empty()))
      return this->Shows;
    const T taken = this->WithId(before.size());
    before.push_back(this->EditOf(taken));
    // The plan says Changed from within: this is what is then known of it.
    const T object = std::exchange(this->Object, taken), base = std::exchange(this->Base, taken);
    if (this->Of.plan.Do(std::move(before), label))
      return true;
    this->Object = object;
    this->Base = base;
    return false;
  }

private:
  T WithId(std::size_t before) const
  {
    T object = this->Object;
    if (object.id == 0)
    {
      object.id = this->Of.plan.NewId() + PlanId(before);
      if (object.name.empty())
        object.name = ObjectNames::Of<T>(object.id);
    }
    return object;
  }
  PlanEdit EditOf(const T& object) const
  {
    return this->Object.id == 0 ? PlanEdit(AddObject<T>{ object })
                                : PlanEdit(ChangeObject<T>{ object });
  }

  Planner& Of;
  T Object{}, Base{}; ///< Base: as the plan has it
  bool Shows = false;
};

} // namespace hasp
