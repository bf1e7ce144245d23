// What changes while it is touched: another tool, another image, another device.
#include "HapticRenderScene.h"

#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace
{

using namespace hasp;
using namespace hasp::testing;

// Ticks without a frame after the grab: what the new tool feels at first is its own surface.
TEST(HapticChanges, ANewToolFeelsItsOwnIsovalueFromTheFirstTick)
{
  Frames frames;
  frames.haptic->SetSpacing(1.0); // who is pressed, not how hard
  frames.haptic->SetDynamicShells(true);
  const auto ground = BallActor(15.0), large = GreyBallActor(6.0, { 0, 0, 19.5 }),
             small = GreyBallActor(3.0, { 0, 0, 19.5 });
  frames.haptic->AddTouchable(ground);
  const int tools[] = { frames.haptic->AddTool(large), frames.haptic->AddTool(small) };
  ASSERT_TRUE(frames.haptic->SetDevice(HandAt(At(0, 0, 19.5)), Settings()));
  ASSERT_TRUE(frames.haptic->Start());
  UpdateUntilReady(frames.haptic);
  vtkHaspHapticLoop* loop = frames.haptic->GetLoop();
  const auto feels = [&](int tool)
  {
    EXPECT_TRUE(frames.haptic->Grab(tool));
    const std::uint64_t until = loop->GetSnapshot().ticks + 200;
    do
      loop->Update(); // no frame of the interactor's
    while (loop->IsRunning() && loop->GetSnapshot().ticks < until);
    return loop->GetSnapshot().contacts;
  };
  EXPECT_GT(feels(tools[0]), 0u) << "15 + 6 > 19.5";
  frames.haptic->Update(); // its isovalue is said
  EXPECT_EQ(feels(tools[1]), 0u) << "15 + 3 < 19.5";
  frames.haptic->Update();
  EXPECT_GT(feels(tools[0]), 0u);
}

/// A ball of 3 mm in a hand at `height`, above a body that can be touched: how hard it is pressed.
class TouchedData : public ::testing::Test
{
protected:
  void Begin(vtkActor* body, double height)
  {
    frames.haptic->SetSpacing(1.0); // who is pressed, not how hard
    ball->SetPosition(0, 0, height);
    frames.haptic->AddTouchable(body);
    tool = frames.haptic->AddTool(ball);
    ASSERT_TRUE(frames.haptic->SetDevice(HandAt(At(0, 0, height)), Settings()));
    UpdateUntilReady(frames.haptic);
    ASSERT_TRUE(frames.haptic->Start());
  }
  double Pressed()
  {
    ball->SetUserMatrix(nullptr);
    EXPECT_TRUE(frames.haptic->Grab(tool));
    frames.UntilTicks(frames.haptic->GetLoop()->GetSnapshot().ticks + 500);
    const double force = frames.haptic->GetLoop()->GetSnapshot().contact.force.z;
    frames.haptic->Release();
    return force;
  }
  void ExpectMadeAnew()
  {
    frames.haptic->Update();
    EXPECT_EQ(frames.haptic->GetState(), vtkHaspHapticInteractor::Baking);
    UpdateUntilReady(frames.haptic);
  }

  Frames frames;
  vtkSmartPointer<vtkActor> ball = BallActor(3.0);
  int tool = -1;
};

TEST_F(TouchedData, AnotherImageOfAMapperIsMadeAnew)
{
  const auto body = GreyBallActor(8.0, glm::dvec3(0.0));
  auto* mapper = static_cast<vtkHaspClusteredCellMapper*>(body->GetMapper());
  this->Begin(body, 9.0);
  EXPECT_GT(this->Pressed(), 0.1);
  // What merely looks at data changes nothing.
  double range[2];
  mapper->GetImage()->GetScalarRange(range);
  mapper->GetImage()->GetBounds();
  mapper->Update();
  frames.haptic->Update();
  EXPECT_EQ(frames.haptic->GetState(), vtkHaspHapticInteractor::Ready);
  mapper->SetInputData(GreyBall(2.0)); // 4 mm high
  this->ExpectMadeAnew();
  EXPECT_EQ(this->Pressed(), 0.0);
  // The first one's samples, written over what is there.
  mapper->GetImage()->GetPointData()->GetScalars()->DeepCopy(
    GreyBall()->GetPointData()->GetScalars());
  mapper->GetImage()->Modified();
  this->ExpectMadeAnew();
  EXPECT_GT(this->Pressed(), 0.1);
}

TEST_F(TouchedData, AnotherSurfaceOfAMapperIsMadeAnew)
{
  const auto body = BallActor(8.0), flat = BallActor(4.0);
  this->Begin(body, 9.0);
  EXPECT_GT(this->Pressed(), 0.1);
  auto* small = static_cast<vtkPolyDataMapper*>(flat->GetMapper());
  small->Update();
  // What merely looks at data changes nothing.
  vtkPolyData* before = static_cast<vtkPolyDataMapper*>(body->GetMapper())->GetInput();
  before->BuildLinks();
  before->GetCell(0);
  double range[2];
  before->GetScalarRange(range);
  body->GetMapper()->Update();
  frames.haptic->Update();
  EXPECT_EQ(frames.haptic->GetState(), vtkHaspHapticInteractor::Ready);
  static_cast<vtkPolyDataMapper*>(body->GetMapper())->SetInputData(small->GetInput());
  this->ExpectMadeAnew();
  EXPECT_EQ(this->Pressed(), 0.0);
  // Another mapper, of another kind.
  body->SetMapper(GreyBallActor(8.0, glm::dvec3(0.0))->GetMapper());
  this->ExpectMadeAnew();
  EXPECT_GT(this->Pressed(), 0.1);
}

TEST_F(TouchedData, ADynamicToolOfAnotherImageIsLetGo)
{
  frames.haptic->SetDynamicShells(true);
  ball = GreyBallActor(3.0, glm::dvec3(0.0));
  const auto body = BallActor(8.0);
  this->Begin(body, 12.0);
  ASSERT_TRUE(frames.haptic->Grab(tool));
  static_cast<vtkHaspClusteredCellMapper*>(ball->GetMapper())->SetInputData(GreyBall(2.0));
  frames.haptic->Update();
  EXPECT_EQ(frames.haptic->GetHeldTool(), -1) << "it would feel with samples that are gone";
  UpdateUntilReady(frames.haptic);
  EXPECT_TRUE(frames.haptic->Grab(tool));
}

// Where the one before stood is nothing to the next.
TEST(HapticChanges, ANewDeviceBeginsAsAFreshOne)
{
  const auto seen = [](vtkHaspHapticInteractor* haptic)
  {
    for (int frame = 0; frame < 3; ++frame)
      haptic->Update();
    return haptic->GetLoop()->GetSnapshot().device;
  };
  Frames frames;
  const auto begin = [&] { return frames.haptic->SetDevice(HandAt(At(2, 0, 0))); };
  ASSERT_TRUE(begin());
  ASSERT_TRUE(frames.haptic->Start()); // or nobody reads it
  vtkNew<vtkMatrix4x4> matrix;
  Set(matrix, { { 100, 0, 0 }, TurnBy({ 0, 0, 0.5 * std::numbers::pi }) });
  ASSERT_TRUE(frames.haptic->SetDeviceToWorld(matrix));
  EXPECT_LT(glm::length(seen(frames.haptic).position - glm::dvec3(100, 2, 0)), 0.01);
  ASSERT_TRUE(begin());
  EXPECT_TRUE(frames.haptic->GetCameraRelative());
  EXPECT_LT(glm::length(seen(frames.haptic).position - glm::dvec3(2, 0, 0)), 0.01);
  // Without a camera it stands where nobody has put it: as it says itself.
  frames.haptic->CameraRelativeOff();
  ASSERT_TRUE(frames.haptic->SetDeviceToWorld(matrix));
  ASSERT_TRUE(begin());
  EXPECT_FALSE(frames.haptic->GetCameraRelative()) << "that was said by whoever uses it";
  EXPECT_LT(glm::length(seen(frames.haptic).position - glm::dvec3(2, 0, 0)), 0.01);
  ASSERT_TRUE(frames.haptic->SetDevice(nullptr));
  EXPECT_NE(ErrorsOf(frames.haptic, [&] { EXPECT_FALSE(frames.haptic->SetDeviceToWorld(matrix)); })
              .find("SetDevice"),
    std::string::npos);
}

} // namespace
