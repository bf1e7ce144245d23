// A grey volume in hand: points drawn where it touches, and its isovalue changed meanwhile.
#include "HapticRenderScene.h"

#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspPointShellMapper.h"

#include "vtkPropCollection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr double GroundRadius = 15.0;

/// The actor that draws discs; null: there is none.
vtkActor* ShellActor(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  for (int n = 0; n < props->GetNumberOfItems(); ++n)
    if (auto* actor = vtkActor::SafeDownCast(props->GetItemAsObject(n)))
      if (vtkHaspPointShellMapper::SafeDownCast(actor->GetMapper()) != nullptr)
        return actor;
  return nullptr;
}

/// A hand that has come down from 22 mm to 19, with the ball of 5 mm in it, on one of 15.
class DynamicTool : public ::testing::TestWithParam<bool>
{
protected:
  void SetUp() override
  {
    frames.haptic->SetDynamicShells(true);
    frames.haptic->AddTouchable(ground);
    if (this->GetParam())
      frames.haptic->AddTouchable(ball);
    tool = frames.haptic->AddTool(ball);
    ASSERT_TRUE(frames.haptic->SetDevice(HandAt(At(0, 0, 22)), Settings()));
    UpdateUntilReady(frames.haptic);
    ASSERT_TRUE(frames.haptic->SetDevice(
      HandAt(At(0, 0, 22), { HoldMotion{ 0.05 }, MinimumJerkMotion{ At(0, 0, 19), 0.3 } }),
      Settings()));
    ASSERT_TRUE(frames.haptic->Start());
    ASSERT_TRUE(frames.haptic->Grab(tool));
    frames.UntilTicks(800); // twice what the motion takes
  }
  const HapticSnapshot& Seen() { return frames.haptic->GetLoop()->GetSnapshot(); }
  void SetRadius(double radius)
  {
    static_cast<vtkHaspClusteredCellMapper*>(ball->GetMapper())->SetIsoValue(-radius);
    frames.haptic->Update(); // said from here on
    frames.UntilTicks(Seen().ticks + 500);
  }
  /// Springs of k an area where balls overlap by D: F = pi k R D^2, R = r r' / (r + r'). A tenth,
  /// and 0.1 mm, as of a mesh in hand.
  void HoldsABallOf(double radius)
  {
    ASSERT_GT(Seen().contacts, 0u) << radius;
    const double reduced = radius * GroundRadius / (radius + GroundRadius);
    const double overlap = std::sqrt(
      Seen().contact.force.z / (std::numbers::pi * Settings().step.contact.stiffness * reduced));
    EXPECT_NEAR(radius + GroundRadius - Seen().tool.position.z, overlap, 0.1 * overlap + 0.1)
      << radius;
  }

  Frames frames;
  vtkSmartPointer<vtkActor> ground = BallActor(GroundRadius),
                            ball = GreyBallActor(5.0, { 0, 0, 22 });
  int tool = -1;
};

// Whether others can touch it as well or not: its own map is not what it feels with.
TEST_P(DynamicTool, StaysInHandAndFeelsAnotherIsovalue)
{
  HoldsABallOf(5.0);
  const double force = Seen().onDevice.force.z;
  SetRadius(6.0);
  EXPECT_EQ(frames.haptic->GetHeldTool(), tool);
  HoldsABallOf(6.0);
  EXPECT_GT(Seen().onDevice.force.z, 1.2 * force);
  SetRadius(3.0); // 18 mm together: the hand at 19 is free
  EXPECT_EQ(frames.haptic->GetHeldTool(), tool);
  EXPECT_EQ(Seen().contacts, 0u);
  EXPECT_LT(std::abs(Seen().onDevice.force.z), 0.01);
  SetRadius(5.0);
  HoldsABallOf(5.0);
}

TEST_P(DynamicTool, ItsPointsAreDrawnWhereItIsWhileAskedFor)
{
  EXPECT_EQ(ShellActor(frames.renderer), nullptr);
  frames.haptic->SetShowShell(true);
  frames.haptic->Update(); // asks
  frames.UntilTicks(Seen().ticks + 50);
  vtkActor* shell = ShellActor(frames.renderer);
  ASSERT_NE(shell, nullptr);
  EXPECT_TRUE(shell->GetVisibility());
  auto* mapper = static_cast<vtkHaspPointShellMapper*>(shell->GetMapper());
  EXPECT_GT(mapper->GetNumberOfDiscs(), 0);
  EXPECT_LT(glm::length(Pose(shell).position - Seen().tool.position), 1e-9);
  const double* bounds = shell->GetBounds(); // on the ball, the underside for one
  EXPECT_NEAR(bounds[4], Seen().tool.position.z - 5.0, 0.5);
  EXPECT_LT(bounds[5], Seen().tool.position.z + 5.5);
  frames.haptic->SetShowShell(false);
  frames.haptic->Update();
  EXPECT_EQ(ShellActor(frames.renderer), nullptr);
}

INSTANTIATE_TEST_SUITE_P(Touchable, DynamicTool, ::testing::Bool());

} // namespace
