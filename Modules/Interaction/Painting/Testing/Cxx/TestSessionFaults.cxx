// What goes wrong behind a session's back leaves it in order.
#include "BrokenJaw.h"
#include "Segmenter.h"

#include "Grid/Testing/CountNew.h"

#include <functional>
#include <string>
#include <thread>

namespace
{

using namespace hasp;
using namespace hasp::testing;

TEST(SessionFaults, LabelsThatSomebodyElseWroteAreShownAnew)
{
  JawScene truth, scene;
  for (JawScene* each : { &truth, &scene })
  {
    each->Enable();
    each->Drag(2, -14.0, -8.0);
    each->session->Finish();
  }
  truth.Drag(3, 6.0, 12.0);
  truth.session->Finish();
  scene.Labels()->Fill(7);
  scene.Drag(3, 6.0, 12.0);
  const Count changes(scene.session, vtkHaspSegmentationSession::LabelsChangedEvent);
  EXPECT_NE(ErrorsOf(scene.session, [&] { EXPECT_TRUE(scene.session->Finish()); }).find("anew"),
    std::string::npos);
  EXPECT_EQ(changes.times, 1);
  EXPECT_EQ(scene.session->GetNumberOfDrags(), 2);
  EXPECT_EQ(scene.Hash(), truth.Hash());
  scene.session->Undo();
  EXPECT_EQ(ErrorsOf(scene.session, [&] { scene.session->Finish(); }), "");
  truth.session->Undo();
  truth.session->Finish();
  EXPECT_EQ(scene.Hash(), truth.Hash());
}

/// What is said of work that may take memory so many times, and no more.
std::string Refused(JawScene& scene, std::size_t left, const std::function<void()>& ask)
{
  return ErrorsOf(scene.session,
    [&]
    {
      {
        const hasp::test::NewRefused refused(left);
        ask();
        while (scene.session->IsWorking())
          std::this_thread::yield();
      }
      scene.session->Finish();
    });
}

/// Does it with less memory than it takes, and more from time to time, until that is enough.
void WithMoreAndMoreMemory(JawScene& scene, const std::function<void()>& ask, int dragsIfNot,
  const std::function<void()>& after)
{
  int failed = 0;
  for (std::size_t left = 0;; left = 2 * left + 1, ++failed)
  {
    ASSERT_LT(left, 100'000U);
    if (Refused(scene, left, ask).empty())
      break;
    EXPECT_EQ(scene.session->GetNumberOfDrags(), dragsIfNot) << left;
    after();
    if (::testing::Test::HasFailure())
      FAIL() << left;
  }
  EXPECT_GT(failed, 3);
}

/// Once there is memory again the labels are those of before, whatever is owed.
void ExpectAsBefore(JawScene& scene, std::uint64_t hash)
{
  scene.Drag(4, 14.0, 20.0);
  EXPECT_EQ(ErrorsOf(scene.session, [&] { scene.session->Finish(); }), "");
  scene.session->Undo();
  scene.session->Finish();
  EXPECT_EQ(scene.Hash(), hash);
}

TEST(SessionFaults, AFirstDragWithoutMemoryLeavesNothing)
{
  JawScene scene;
  scene.Enable();
  const std::uint64_t none = scene.Hash();
  const auto first = [&] { scene.Drag(2, -14.0, -8.0); };
  WithMoreAndMoreMemory(scene, first, 0, [&] { ExpectAsBefore(scene, none); });
  EXPECT_GT(scene.Voxels()[2], 1000);
}

TEST(SessionFaults, ADragMoreWithoutMemoryLeavesAllAsItWas)
{
  JawScene scene;
  scene.Enable();
  scene.Drag(2, -14.0, -8.0);
  scene.session->Finish();
  const std::uint64_t one = scene.Hash();
  const auto second = [&] { scene.Drag(3, 6.0, 12.0); };
  WithMoreAndMoreMemory(scene, second, 1, [&] { ExpectAsBefore(scene, one); });
  EXPECT_GT(scene.Voxels()[3], 1000);
}

TEST(SessionFaults, WhatCannotBeTakenBackIsTakenBackLater)
{
  JawScene scene;
  scene.Enable();
  scene.Drag(2, -14.0, -8.0);
  scene.session->Finish();
  const auto second = [&]
  {
    scene.Drag(3, 6.0, 12.0);
    scene.session->Finish();
  };
  second();
  const auto undo = [&] { scene.session->Undo(); };
  EXPECT_NE(Refused(scene, 0, undo).find("its labels stay"), std::string::npos);
  EXPECT_GT(scene.Voxels()[3], 1000);
  scene.session->Settle();
  const auto made = SegmentScan(scene.scan, scene.session->GetRecipe()); // which has it, too
  EXPECT_EQ(scene.Hash(), HashLabels(std::get<GridView<const Label>>(ViewImage(made.labels))));
  second();
  EXPECT_EQ(scene.session->GetNumberOfDrags(), 2);
  scene.session->Undo();
  scene.session->Finish();
  EXPECT_EQ(scene.Voxels()[3], 0);
  second();
  WithMoreAndMoreMemory(scene, undo, 1, second);
  EXPECT_EQ(scene.Voxels()[3], 0);
}

} // namespace
