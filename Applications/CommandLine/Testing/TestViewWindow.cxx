#include "ViewDesk.h"

#include "vtkSliderRepresentation2D.h"
#include "vtkSliderWidget.h"

#include <unistd.h>

#include <filesystem>

namespace
{

using namespace hasp;
using hasp::testing::Desk;
using hasp::testing::Size;

/// A pixel is 1.1 mm wide there; a ball's edge may lie anywhere in the two of both sides.
constexpr double PixelMm = 1.2;

class ViewMapper : public ::testing::TestWithParam<std::string>
{
};

TEST_P(ViewMapper, ShowsTheIsosurfaceAndFollowsItsValue)
{
  Desk desk(GetParam());
  EXPECT_NEAR(desk.Radius(), 20.0, PixelMm);
  desk.Press("Next"); // 10% of 60 less
  EXPECT_DOUBLE_EQ(desk.view->IsoValue(), 74.0);
  EXPECT_NEAR(desk.Radius(), 26.0, PixelMm);
  const double* at = desk.renderer->GetActiveCamera()->GetPosition();
  const double far = std::sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
  const auto hit = desk.scene->Pick({ at[0], at[1], at[2] }, { 0, 0, 0 });
  ASSERT_TRUE(hit);
  for (int a = 0; a < 3; ++a) // samples 2 to 3 mm apart round off a ball of 26 mm by 0.1 mm
    EXPECT_NEAR((*hit)[a], at[a] * 26.0 / far, 0.15) << a;
  EXPECT_FALSE(desk.scene->Pick({ 90, 0, 0 }, { 90, 50, 0 }));
}

/// A ball of 20 mm in a volume of 64 x 64 x 96 mm, in cells of 2 x 2 x 3 mm half a radian askew.
TEST_P(ViewMapper, TheContentIsWhatIsShownNotTheVolume)
{
  Desk desk(GetParam());
  const auto content = desk.scene->Content();
  ASSERT_TRUE(content);
  if (GetParam() == "vtk" && !HASP_WITH_CELLS)
  {
    EXPECT_TRUE(content->ofVolume);
    EXPECT_GT(content->bounds[5], 45.0);
    return;
  }
  EXPECT_FALSE(content->ofVolume);
  const double cell = GetParam() == "mesh" ? 0.0 : 3.0; // mm, along an axis of the world
  for (int side = 0; side < 6; ++side)
  {
    const double reach = side % 2 ? content->bounds[side] : -content->bounds[side];
    EXPECT_GT(reach, 20.0 - 0.15) << side;
    EXPECT_LT(reach, 20.0 + cell + 0.15) << side;
  }
  desk.Press("Next"); // 26 mm
  EXPECT_NEAR(desk.scene->Content()->bounds[5], 26.0 + 0.5 * cell, 0.5 * cell + 0.15);
  desk.scene->SetIsoValue(1e4);
  EXPECT_FALSE(desk.scene->Content());
}
INSTANTIATE_TEST_SUITE_P(Each, ViewMapper, ::testing::ValuesIn(SurfaceMappers()));

TEST(ViewWindow, TheSurfaceFollowsTheSliderWhileItIsDragged)
{
  Desk desk;
  desk.Settle();
  const double before = desk.Radius();
  auto* slider = static_cast<vtkSliderRepresentation2D*>(desk.view->Slider()->GetRepresentation());
  int from[2], to[2];
  const auto at = [&](double share, int pixel[2])
  {
    pixel[0] = static_cast<int>(Size * (0.1 + 0.8 * share));
    pixel[1] = static_cast<int>(Size * 0.08);
  };
  at((80.0 - 40.0) / 60.0, from);
  at(0.5, to);
  desk.Mouse(from[0], from[1], vtkCommand::MouseMoveEvent);
  desk.Mouse(from[0], from[1], vtkCommand::LeftButtonPressEvent);
  desk.Mouse(to[0], to[1], vtkCommand::MouseMoveEvent);
  // Half of the range, within two pixels; the button is still down.
  EXPECT_NEAR(desk.view->IsoValue(), 70.0, 2.0 * 60.0 / (0.8 * Size));
  EXPECT_DOUBLE_EQ(desk.view->IsoValue(), slider->GetValue());
  EXPECT_NEAR(desk.Radius(), 100.0 - desk.view->IsoValue(), PixelMm);
  EXPECT_GT(desk.Radius(), before + 5.0);
  desk.Mouse(to[0], to[1], vtkCommand::LeftButtonReleaseEvent);
  EXPECT_NE(desk.view->Text().find("HU"), std::string::npos);
}

TEST(ViewWindow, NothingRunsWhenThePictureIsComplete)
{
  Desk desk;
  EXPECT_TRUE(desk.view->WaitsForTimer());
  EXPECT_GE(desk.Settle(), 3); // a picture is complete after four frames without a find
  EXPECT_FALSE(desk.view->WaitsForTimer());
  EXPECT_TRUE(desk.timers.empty());
  const int created = desk.created;
  int other = 12345;
  desk.interactor->InvokeEvent(vtkCommand::TimerEvent, &other);
  EXPECT_EQ(desk.created, created);
  desk.renderer->GetActiveCamera()->Azimuth(20);
  desk.window->Render();
  EXPECT_TRUE(desk.view->WaitsForTimer()); // what is seen from here is to be found
  desk.Settle();
  EXPECT_FALSE(desk.view->WaitsForTimer());
  int remembered = 0; // by VTK, of those that are over
  for (int id = 1; id <= 2 * desk.created; ++id)
    remembered += desk.interactor->GetVTKTimerId(id) != 0;
  EXPECT_LE(remembered, 1);
}

TEST(ViewWindow, WhatNeverRefinesHasNoTimer)
{
  Desk desk("mesh");
  desk.Press("Up");
  EXPECT_EQ(desk.created, 0);
}

TEST(ViewWindow, TheTimerDoesNotTurnTheCamera)
{
  Desk desk;
  desk.Mouse(100, 100, vtkCommand::LeftButtonPressEvent);
  desk.Mouse(120, 100, vtkCommand::MouseMoveEvent);
  const double turned = desk.renderer->GetActiveCamera()->GetPosition()[0];
  ASSERT_GT(std::abs(turned), 1.0);
  EXPECT_GT(desk.Settle(), 0); // the button is down, the mouse at rest
  EXPECT_DOUBLE_EQ(desk.renderer->GetActiveCamera()->GetPosition()[0], turned);
  desk.Mouse(120, 100, vtkCommand::LeftButtonReleaseEvent);
  desk.Press("r");
  EXPECT_NEAR(desk.renderer->GetActiveCamera()->GetPosition()[0], 0.0, 1e-9);
}

TEST(ViewWindow, KeysStepTheIsovalueWithinItsRange)
{
  Desk desk;
  desk.Press("Right");
  EXPECT_DOUBLE_EQ(desk.view->IsoValue(), 80.6);
  desk.Press("minus");
  EXPECT_DOUBLE_EQ(desk.view->IsoValue(), 80.0);
  for (int n = 0; n < 9; ++n)
    desk.Press("Next");
  EXPECT_DOUBLE_EQ(desk.view->IsoValue(), 40.0);
  auto* slider = static_cast<vtkSliderRepresentation2D*>(desk.view->Slider()->GetRepresentation());
  EXPECT_DOUBLE_EQ(slider->GetValue(), 40.0);
  desk.Press("w"); // VTK's own keys mean nothing here
  desk.Press("3");
  EXPECT_FALSE(desk.window->GetStereoRender());
}

TEST(ViewWindow, PSaysWhereTheSurfaceIs)
{
  Desk desk;
  desk.interactor->SetEventPosition(Size / 2, Size / 2);
  desk.Press("p");
  // The middle of the window is half a pixel beside that of the ball; front: -y.
  double x = 0, y = 0, z = 0;
  const std::string text = desk.view->Text();
  ASSERT_EQ(
    std::sscanf(text.substr(text.find("picked")).c_str(), "picked %lf, %lf, %lf mm", &x, &y, &z), 3)
    << text;
  EXPECT_NEAR(x, 0.0, PixelMm);
  EXPECT_NEAR(y, -20.0, 0.2);
  EXPECT_NEAR(z, 0.0, PixelMm);
  desk.interactor->SetEventPosition(2, Size - 2);
  desk.Press("p");
  EXPECT_NE(desk.view->Text().find("no surface there"), std::string::npos);
}

/// Rays of ours, where they are built in, answer for VTK's mapper.
TEST(ViewWindow, PDoesNotSayThatThereIsNoSurfaceWhereNobodyCanBeAsked)
{
  Desk desk("vtk");
  desk.interactor->SetEventPosition(Size / 2, Size / 2);
  desk.Press("p");
  const std::string text = desk.view->Text(), said = HASP_WITH_CELLS ? "picked" : "--mapper mesh";
  EXPECT_NE(text.find(said), std::string::npos) << text;
  EXPECT_EQ(text.find("no surface there"), std::string::npos) << text;
}

TEST(ViewWindow, SSavesUnderAFreeName)
{
  const std::filesystem::path folder =
    std::filesystem::temp_directory_path() / ("hasp-view-" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder);
  Desk desk;
  desk.Press("s");
  desk.Press("s");
  EXPECT_GT(std::filesystem::file_size("hasp-view-1.png"), 1000U);
  EXPECT_GT(std::filesystem::file_size("hasp-view-2.png"), 1000U);
  EXPECT_NE(desk.view->Text().find("saved hasp-view-2.png"), std::string::npos);
  std::filesystem::current_path(before);
  std::filesystem::remove_all(folder);
}

TEST(ViewWindow, ClosingEndsTheLoopAndSaysWhatWasHeld)
{
  for (const std::string key : { "q", "Escape" })
  {
    Desk desk;
    desk.Settle();
    ASSERT_FALSE(desk.interactor->GetDone());
    desk.Press(key);
    EXPECT_TRUE(desk.interactor->GetDone()) << key;
    desk.Press("Right"); // an event that was on its way
    const ResourceList held = desk.view->Resources();
    EXPECT_TRUE(
      std::any_of(held.begin(), held.end(), [](const ResourceUse& use) { return use.bytes > 0; }));
  }
  Desk desk;
  desk.interactor->InvokeEvent(vtkCommand::ExitEvent); // the window's close button
  EXPECT_TRUE(desk.interactor->GetDone());
}

} // namespace
