// The mouse in a window whose eyes lie apart or are turned over.
#include "Devices/MouseHeadPose.h"
#include "StereoDesk.h"

#include <array>
#include <cmath>

namespace
{

using namespace hasp;
using hasp::testing::StereoDesk;
using Pixel = std::array<int, 2>;

constexpr double Low = 0.1, Range = 0.8, Height = 0.08; // of the slider, in the view

struct Case
{
  std::string layout, resolution, mirror;
  Pixel low, size; ///< of the part of the window in which the second eye is seen
};

void PrintTo(const Case& one, std::ostream* os)
{
  *os << one.layout << " " << one.resolution << " " << one.mirror;
}

class ViewPointerIn : public ::testing::TestWithParam<Case>
{
protected:
  StereoDesk desk{ GetParam().layout, nullptr,
    [](StereoChoices& choices)
    {
      choices.resolution = GetParam().resolution;
      choices.mirror = GetParam().mirror;
    } };

  /// Where the user sees that share of the slider's range.
  static Pixel Shown(double share)
  {
    const Case& one = GetParam();
    double x = Low + Range * share, y = Height;
    if (one.mirror == "horizontal" || one.mirror == "both")
      x = 1.0 - x;
    if (one.mirror == "vertical" || one.mirror == "both")
      y = 1.0 - y;
    return { one.low[0] + static_cast<int>(x * one.size[0]),
      one.low[1] + static_cast<int>(y * one.size[1]) };
  }
  void Mouse(const Pixel& at, unsigned long event) { this->desk.Mouse(at[0], at[1], event); }
};

TEST_P(ViewPointerIn, TheSliderIsWhereItIsSeen)
{
  const Pixel from = Shown((80.0 - 40.0) / 60.0), to = Shown(0.5);
  const auto picture = desk.view->DrawComplete();
  const auto* handle =
    static_cast<const unsigned char*>(picture->GetScalarPointer(from[0], from[1], 0));
  for (int c = 0; c < 3; ++c) // white on a tube of half that
    ASSERT_GT(handle[c], 180) << from[0] << " " << from[1];
  Mouse(from, vtkCommand::MouseMoveEvent);
  Mouse(from, vtkCommand::LeftButtonPressEvent);
  Mouse(to, vtkCommand::MouseMoveEvent);
  // Half of the range, within two pixels.
  EXPECT_NEAR(desk.view->IsoValue(), 70.0, 2.0 * 60.0 / (Range * GetParam().size[0]));
  Mouse(to, vtkCommand::LeftButtonReleaseEvent);
  Mouse(from, vtkCommand::MouseMoveEvent);
  EXPECT_NEAR(desk.view->IsoValue(), 70.0, 2.0 * 60.0 / (Range * GetParam().size[0]));
}
INSTANTIATE_TEST_SUITE_P(Each, ViewPointerIn,
  ::testing::Values(Case{ "side-by-side", "full", "none", { 200, 0 }, { 200, 150 } },
    Case{ "side-by-side", "half", "horizontal", { 100, 0 }, { 100, 150 } },
    Case{ "top-bottom", "full", "none", { 0, 0 }, { 200, 150 } },
    Case{ "mono", "full", "vertical", { 0, 0 }, { 200, 150 } },
    Case{ "interlaced", "half", "both", { 0, 0 }, { 200, 150 } }));

TEST(ViewPointer, ADragStaysInItsEyeAndGoesOnBeyondIt)
{
  StereoDesk desk("side-by-side"); // 200 pixels each
  desk.Mouse(326, 12, vtkCommand::LeftButtonPressEvent);
  desk.Mouse(300, 12, vtkCommand::MouseMoveEvent);
  EXPECT_NEAR(desk.view->IsoValue(), 70.0, 1.0);
  desk.Mouse(190, 12, vtkCommand::MouseMoveEvent); // the right end, for the other eye
  EXPECT_DOUBLE_EQ(desk.view->IsoValue(), 40.0);
  desk.Mouse(500, 12, vtkCommand::MouseMoveEvent); // outside of the window
  EXPECT_DOUBLE_EQ(desk.view->IsoValue(), 100.0);
  desk.Mouse(300, 12, vtkCommand::MouseMoveEvent);
  EXPECT_NEAR(desk.view->IsoValue(), 70.0, 1.0);
  desk.Mouse(300, 12, vtkCommand::LeftButtonReleaseEvent);
}

TEST(ViewPointer, TheRightWindowsMouseDoesWhatTheMainOnesDoes)
{
  StereoDesk desk("dual-window");
  desk.eyes->PointIn(desk.right);
  desk.Mouse(126, 12, vtkCommand::LeftButtonPressEvent);
  desk.Mouse(100, 12, vtkCommand::MouseMoveEvent);
  desk.Mouse(100, 12, vtkCommand::LeftButtonReleaseEvent);
  EXPECT_NEAR(desk.view->IsoValue(), 70.0, 1.0);
  const auto right = desk.eyes->RayOf(100, 75);
  desk.eyes->PointIn(desk.window);
  const auto left = desk.eyes->RayOf(100, 75);
  ASSERT_TRUE(left && right);
  EXPECT_NEAR(desk.InRoom(left->first).x, -30.0, 1e-9);
  EXPECT_NEAR(desk.InRoom(right->first).x, 30.0, 1e-9);
}

TEST(ViewPointer, TheTrackballTurnsByWhatTheEyeSeesAndNotByAJump)
{
  const auto turned = [](const std::string& layout, int from, int to)
  {
    StereoDesk desk(layout);
    desk.Mouse(10, 75, vtkCommand::MouseMoveEvent);
    desk.Mouse(from, 75, vtkCommand::LeftButtonPressEvent);
    desk.Mouse(to, 75, vtkCommand::MouseMoveEvent);
    desk.Mouse(to, 75, vtkCommand::LeftButtonReleaseEvent);
    const double* at = desk.renderer->GetActiveCamera()->GetPosition();
    return std::atan2(at[0], -at[1]); // from the front: -y
  };
  const double mono = turned("mono", 100, 120);
  ASSERT_GT(std::abs(mono), 0.1);
  EXPECT_NEAR(turned("side-by-side", 300, 320), mono, 1e-9);
  EXPECT_NEAR(turned("side-by-side", 100, 120), mono, 1e-9);
  EXPECT_NEAR(turned("side-by-side", 390, 410), mono, 1e-9);  // out of the window
  EXPECT_NEAR(turned("side-by-side", 210, 190), -mono, 1e-9); // over the other eye's part
}

TEST(ViewPointer, KeysPickInTheWindowsPixel)
{
  for (const int x : { 50, 100, 300 }) // beside the ball; on it in each eye
  {
    StereoDesk desk("side-by-side");
    desk.Mouse(x, 75, vtkCommand::MouseMoveEvent);
    desk.interactor->SetKeySym("p"); // without a position, as some systems send keys
    desk.interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    const auto answer = [&] { return desk.view->Text().substr(desk.view->Text().find('\n')); };
    const std::string text = answer();
    EXPECT_EQ(text.find("picked") != text.npos, x != 50) << text;
    desk.interactor->SetEventPosition(x, 75); // as others do
    desk.interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    EXPECT_EQ(answer(), text);
  }
}

} // namespace
