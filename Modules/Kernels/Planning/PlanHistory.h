#pragma once
#include "Planning/PlanEdits.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace hasp
{

/// What is done and undone as one.
struct PlanStep
{
  std::string label; ///< for menus: "Undo LABEL"
  std::vector<PlanEdit> edits;

  bool operator==(const PlanStep&) const noexcept = default;
};

/// A plan and the way to it, with undo and redo. A value; saved with the plan (PlanFile.h).
///
/// Threads: one at a time. What throws leaves the history as it was. Do and Redo: a copy of the
/// plan. Undo: up to `Stride` steps are done again from a plan that is kept. Memory: a plan for
/// each Stride steps.
class PlanHistory
{
public:
  static constexpr std::size_t Stride = 16;

  PlanHistory() : PlanHistory(Plan{}) {}
  explicit PlanHistory(Plan start); ///< throws what ValidatePlan throws
  /// As it was saved. Throws std::invalid_argument unless the steps lead somewhere from `start`,
  /// done <= steps.size(), and nextId is above all ids.
  PlanHistory(Plan start, std::vector<PlanStep> steps, std::size_t done, PlanId nextId);

  const Plan& Current() const { return this->Now; }
  /// For the next object. Never one that any step has had, undone or forgotten ones included.
  PlanId NewId() const { return this->NextId; }

  /// One step. What had been undone is forgotten. Without a label: that of the first edit. Throws
  /// std::invalid_argument if an edit does not apply, adds an id below NewId(), or there is none.
  void Do(std::vector<PlanEdit> edits, std::string label = {});
  void Do(PlanEdit edit) { this->Do(std::vector<PlanEdit>{ std::move(edit) }); }

  /// The step that Undo would take back, that Redo would do; nullptr if none.
  const PlanStep* ToUndo() const;
  const PlanStep* ToRedo() const;
  void Undo(); ///< nothing if there is no step to undo
  void Redo();

  const Plan& Start() const { return this->Kept.front(); }
  const std::vector<PlanStep>& Steps() const { return this->AllSteps; }
  std::size_t Done() const { return this->DoneSteps; } ///< how many steps lead to Current()

  bool operator==(const PlanHistory&) const noexcept = default;

private:
  void Reach(Plan next); ///< by the step after DoneSteps
  Plan At(std::size_t done) const;

  std::vector<Plan> Kept; ///< after 0, Stride, 2 Stride, … steps
  std::vector<PlanStep> AllSteps;
  std::size_t DoneSteps = 0;
  PlanId NextId = 1;
  Plan Now;
};

} // namespace hasp
