// VTK's mappers hold buffers of one window: what is seen in two of them by turns.
#include "ConeScene.h"
#include "ViewsDesk.h"

#include <gtest/gtest.h>

namespace
{

using namespace hasp;
using namespace hasp::testing;

TEST(QtRenderWindow, WhatIsInTwoWindowsIsSeenInBothByTurns)
{
  ViewsDesk one, two;
  const auto cone = AddCone(one.scene);
  LookFromTheFront(one.scene);
  two.scene.Renderer()->AddActor(cone);
  LookFromTheFront(two.scene);
  two.scene.ResetView();
  one.scene.ResetView();
  one.Settle();
  two.Settle();
  const QImage first = Drawn(one.scene), second = Drawn(two.scene);
  EXPECT_EQ(first, second);
  for (int turn = 0; turn < 3; ++turn)
    for (ViewsDesk* desk : { &one, &two })
    {
      desk->scene.Draw();
      desk->Settle();
      EXPECT_EQ(Drawn(desk->scene), first) << turn;
    }
  two.scene.Renderer()->RemoveActor(cone);
  two.scene.Draw();
  two.Settle();
  EXPECT_NE(Drawn(two.scene), first) << "else nothing was seen at all";
  one.scene.Draw();
  one.Settle();
  EXPECT_EQ(Drawn(one.scene), first);
}

} // namespace
