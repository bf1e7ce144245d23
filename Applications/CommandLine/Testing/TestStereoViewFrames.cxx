// When `hasp view` draws for eyes before a screen, and when it leaves the machine alone.
#include "StereoDesk.h"

#include "vtkPropCollection.h"
#include "vtkTextActor.h"

namespace
{

using namespace hasp;
using hasp::testing::HandHeld;
using hasp::testing::StereoDesk;

TEST(StereoViewFrames, WhenNothingRefinesAnyMoreTheTextSaysSo)
{
  StereoDesk desk(
    "anaglyph", nullptr, [](StereoChoices&) {}, "raycaching");
  /// As the last frame has drawn it.
  const auto refines = [&]
  {
    std::string text;
    vtkCollectionSimpleIterator at;
    desk.renderer->GetViewProps()->InitTraversal(at);
    while (vtkProp* prop = desk.renderer->GetViewProps()->GetNextProp(at))
      if (auto* line = vtkTextActor::SafeDownCast(prop))
        text += line->GetInput();
    EXPECT_NE(text.find("isovalue"), std::string::npos) << text;
    return text.find("refining") != std::string::npos;
  };
  int refining = refines(), fired = 0;
  for (; fired < 2000 && desk.Fire(); ++fired)
    refining += refines();
  EXPECT_GT(refining, 0) << "or this shows nothing";
  EXPECT_LT(fired, 2000);
  EXPECT_FALSE(refines());
}

TEST(StereoViewFrames, WithoutATrackerNothingRunsWhenThePictureIsComplete)
{
  StereoDesk desk("anaglyph");
  int fired = 0;
  while (fired < 100 && desk.Fire())
    ++fired;
  EXPECT_LT(fired, 100);
  const int frames = desk.frames;
  EXPECT_EQ(frames % 2, 0) << "two eyes each";
  desk.interactor->Render(); // what a widget, a key or an exposed window asks for
  EXPECT_EQ(desk.frames, frames + 2);
  EXPECT_EQ(desk.view->Text().find("head"), std::string::npos);
}

TEST(StereoViewFrames, WithATrackerItIsAskedAndOnlyAHeadThatMovedIsDrawn)
{
  StereoDesk desk("anaglyph", std::make_unique<HandHeld>());
  desk.hand->warnings = { "the tracker lost its light" };
  for (int n = 0; n < 30; ++n)
    ASSERT_TRUE(desk.Fire());
  EXPECT_EQ(desk.said, std::vector<std::string>{ "the tracker lost its light" });
  EXPECT_NE(desk.view->Text().find("head: tracking by a hand"), std::string::npos)
    << desk.view->Text();
  const int frames = desk.frames;
  for (int n = 0; n < 30; ++n)
    ASSERT_TRUE(desk.Fire());
  EXPECT_EQ(desk.frames, frames) << "nobody moved";
  desk.hand->pose.position.x = 20.0;
  for (int n = 0; n < 5; ++n)
    ASSERT_TRUE(desk.Fire());
  EXPECT_GT(desk.frames, frames);
}

TEST(StereoViewFrames, ATrackerThatFallsSilentIsShownWithoutAMove)
{
  StereoDesk desk("left", std::make_unique<HandHeld>());
  double now = 1.0;
  for (; now < 3.0; now += 0.05)
    desk.eyes->Draw(now);
  EXPECT_FALSE(desk.eyes->HeadMoved(now));
  desk.hand->silent = true;
  EXPECT_TRUE(desk.eyes->HeadMoved(now + 0.6));
}

} // namespace
