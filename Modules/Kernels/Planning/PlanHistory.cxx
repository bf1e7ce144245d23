#include "Planning/PlanHistory.h"

#include "Planning/ValueChecks.h"

#include <algorithm>
#include <stdexcept>

namespace hasp
{

namespace
{
struct AddedId
{
  template <typename T>
  PlanId operator()(const AddObject<T>& edit) const
  {
    return edit.object.id;
  }
  template <typename Other>
  PlanId operator()(const Other&) const
  {
    return MaxPlanId;
  }
};

void CheckNew(const PlanStep& step, PlanId least)
{
  for (const PlanEdit& edit : step.edits)
    if (const PlanId id = std::visit(AddedId{}, edit); id < least)
      throw std::invalid_argument("history: id " + std::to_string(id) +
                                  " was given before; the next is " + std::to_string(least));
}

Plan After(Plan plan, const PlanStep& step)
{
  for (const PlanEdit& edit : step.edits)
    plan = Apply(std::move(plan), edit);
  return plan;
}
} // namespace

PlanHistory::PlanHistory(Plan start) : NextId(start.nextId), Now(std::move(start))
{
  ValidatePlan(this->Now);
  this->Kept.push_back(this->Now);
}

PlanHistory::PlanHistory(Plan start, std::vector<PlanStep> steps, std::size_t done, PlanId nextId)
  : PlanHistory(std::move(start))
{
  const ValueChecks check("history");
  check.Closed("done", double(done), 0, double(steps.size()));
  for (PlanStep& step : steps)
  {
    check.Text("a step's label", step.label);
    this->AllSteps.push_back(std::move(step));
    this->Redo();
    this->NextId = std::max(this->NextId, this->Now.nextId);
  }
  check.Closed("nextId", nextId, this->NextId, double(MaxPlanId) + 1);
  this->NextId = nextId;
  this->Now = this->At(done);
  this->DoneSteps = done;
}

void PlanHistory::Do(std::vector<PlanEdit> edits, std::string label)
{
  if (edits.empty())
    throw std::invalid_argument("history: a step without edits");
  PlanStep step{ label.empty() ? EditLabel(this->Now, edits[0]) : std::move(label),
    std::move(edits) };
  ValueChecks("history").Text("the label", step.label);
  CheckNew(step, this->NextId);
  Plan next = After(this->Now, step);

  this->AllSteps.reserve(this->DoneSteps + 1); // nothing below throws but for want of memory
  this->Kept.reserve(this->DoneSteps / Stride + 2);
  this->AllSteps.resize(this->DoneSteps);
  this->Kept.resize(this->DoneSteps / Stride + 1);
  this->AllSteps.push_back(std::move(step));
  this->NextId = std::max(this->NextId, next.nextId);
  this->Reach(std::move(next));
}

const PlanStep* PlanHistory::ToUndo() const
{
  return this->DoneSteps == 0 ? nullptr : &this->AllSteps[this->DoneSteps - 1];
}

const PlanStep* PlanHistory::ToRedo() const
{
  return this->DoneSteps == this->AllSteps.size() ? nullptr : &this->AllSteps[this->DoneSteps];
}

void PlanHistory::Undo()
{
  if (this->DoneSteps == 0)
    return;
  this->Now = this->At(this->DoneSteps - 1);
  --this->DoneSteps;
}

void PlanHistory::Redo()
{
  if (const PlanStep* step = this->ToRedo())
    this->Reach(After(this->Now, *step));
}

void PlanHistory::Reach(Plan next)
{
  if ((this->DoneSteps + 1) / Stride == this->Kept.size())
    this->Kept.push_back(next);
  this->Now = std::move(next);
  ++this->DoneSteps;
}

Plan PlanHistory::At(std::size_t done) const
{
  Plan plan = this->Kept[done / Stride];
  for (std::size_t n = done / Stride * Stride; n < done; ++n)
    plan = After(std::move(plan), this->AllSteps[n]);
  return plan;
}

} // namespace hasp
