#include "Planning/PlanHistory.h"
#include "RandomEdits.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{
using namespace hasp;

AddObject<PlanVolume> Volume(PlanId id)
{
  return { { id, "", std::string(64, 'a') } };
}

/// Steps of one to three edits; all plans on the way.
std::vector<Plan> Fill(PlanHistory& history, RandomEdits& random, int steps)
{
  std::vector<Plan> plans = { history.Current() };
  for (; steps > 0; --steps)
  {
    std::vector<PlanEdit> edits;
    Plan plan = history.Current();
    for (int n = 1 + random.Below(3); n > 0; --n)
    {
      edits.push_back(random.Next(plan, std::max(plan.nextId, history.NewId())));
      plan = Apply(std::move(plan), edits.back());
    }
    history.Do(edits);
    EXPECT_EQ(history.Current(), plan);
    plans.push_back(plan);
  }
  return plans;
}

TEST(PlanHistory, UndoToTheStartAndRedoPassTheSamePlans)
{
  RandomEdits random(1);
  PlanHistory history(random.MakePlan(10));
  const int steps = 3 * int(PlanHistory::Stride) + 5; // more than is kept between two plans
  const std::vector<Plan> plans = Fill(history, random, steps);
  const PlanHistory full = history;
  for (int n = steps; n > 0; --n)
  {
    ASSERT_EQ(history.Current(), plans[std::size_t(n)]) << n;
    ASSERT_EQ(history.ToUndo(), &history.Steps()[std::size_t(n) - 1]);
    history.Undo();
  }
  EXPECT_EQ(history.Current(), history.Start());
  EXPECT_EQ(history.ToUndo(), nullptr);
  history.Undo(); // nothing
  for (int n = 0; n < steps; ++n)
  {
    ASSERT_EQ(history.Current(), plans[std::size_t(n)]) << n;
    history.Redo();
  }
  EXPECT_EQ(history.ToRedo(), nullptr);
  history.Redo(); // nothing
  EXPECT_EQ(history, full);
}

TEST(PlanHistory, WhatWasUndoneIsForgottenByTheNextStep)
{
  RandomEdits random(2);
  PlanHistory history;
  Fill(history, random, 150);
  for (int n = 0; n < 100; ++n)
    history.Undo();
  const std::vector<Plan> plans = Fill(history, random, 90);
  EXPECT_EQ(history.Steps().size(), 140U);
  EXPECT_EQ(history.ToRedo(), nullptr);
  for (int n = 90; n > 0; --n)
    history.Undo();
  EXPECT_EQ(history.Current(), plans[0]);
  for (int n = 0; n < 90; ++n)
    history.Redo();
  EXPECT_EQ(history.Current(), plans[90]);
}

TEST(PlanHistory, AnIdThatWasUndoneIsNotUsedAgain)
{
  PlanHistory history;
  history.Do(Volume(history.NewId()));
  history.Do(Volume(history.NewId()));
  history.Undo();
  EXPECT_EQ(history.Current().nextId, 2U); // the plan is as it was
  EXPECT_EQ(history.NewId(), 3U);          // its history is not
  EXPECT_THROW(history.Do(Volume(2)), std::invalid_argument);
  EXPECT_NE(history.ToRedo(), nullptr); // what throws changes nothing
  history.Do(RenameObject{ 1, "x" });   // forgets the step that had 2
  EXPECT_EQ(history.NewId(), 3U);
  history.Do(Volume(history.NewId()));
  EXPECT_EQ(history.Current().volumes[1].id, 3U);
  history.Undo();
  EXPECT_EQ(history.NewId(), 4U);
  EXPECT_EQ(PlanHistory(history.Start(), history.Steps(), 2, 4), history);
}

TEST(PlanHistory, AStepIsDoneWholeOrNotAtAll)
{
  PlanHistory history;
  history.Do(Volume(1));
  const PlanHistory before = history;
  EXPECT_THROW(history.Do({ RenameObject{ 1, "x" }, RemoveObject{ 9 } }), std::invalid_argument);
  EXPECT_THROW(history.Do(std::vector<PlanEdit>{}), std::invalid_argument);
  EXPECT_THROW(history.Do({ RenameObject{ 1, "x" } }, "a\nb"), std::invalid_argument);
  EXPECT_EQ(history, before);
}

TEST(PlanHistory, StepsHaveLabels)
{
  PlanHistory history;
  history.Do({ Volume(1), Volume(2) }, "Open two scans");
  history.Do(RemoveObject{ 2 });
  EXPECT_EQ(history.ToUndo()->label, "Remove volume 2");
  history.Undo();
  EXPECT_EQ(history.ToUndo()->label, "Open two scans");
  EXPECT_EQ(history.ToRedo()->label, "Remove volume 2");
}

TEST(PlanHistory, ComesBackAsItWasSaved)
{
  RandomEdits random(3);
  PlanHistory history(random.MakePlan(5));
  Fill(history, random, 140);
  for (int undone : { 0, 1, 60 })
  {
    for (int n = 0; n < undone; ++n)
      history.Undo();
    EXPECT_EQ(
      PlanHistory(history.Start(), history.Steps(), history.Done(), history.NewId()), history);
  }
}

TEST(PlanHistory, WhatLeadsNowhereIsRefused)
{
  const std::vector<PlanStep> steps = { { "", { Volume(1) } }, { "", { RemoveObject{ 1 } } } };
  const auto refused = [&](std::vector<PlanStep> way, std::size_t done, PlanId nextId)
  { EXPECT_THROW(PlanHistory({}, std::move(way), done, nextId), std::invalid_argument); };
  EXPECT_NO_THROW(PlanHistory({}, steps, 1, 2));
  refused(steps, 3, 2);
  refused(steps, 1, 1);                  // id 1 was given
  refused({ steps[1], steps[0] }, 0, 2); // also what is undone must apply
  refused({ { "\n", {} } }, 0, 1);
  Plan spoilt;
  spoilt.nextId = 0;
  EXPECT_THROW(PlanHistory{ spoilt }, std::invalid_argument);
}

} // namespace
