// Fragments in somebody's hand, whatever holds them: what is let go is a step of the plan.
#include "vtkHaspReductionSession.h"

#include "HapticRenderScene.h"

#include "Planning/PlanHistory.h"
#include "Planning/PlanLists.h"

#include "vtkCellArray.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTDxMotionEventInfo.h"

#include <gtest/gtest.h>

#include <numbers>

namespace
{

using namespace hasp;
using namespace hasp::testing;

constexpr PlanId Lower = 3, Upper = 4, Other = 5;
constexpr double HalfX = 12.0, HalfY = 8.0, HalfZ = 10.0; // of the block, mm
constexpr int Columns = 48, Rows = 32;

/// Where the block broke: no shift along the face and no turn is like another.
double Face(double x, double y)
{
  return 1.5 * std::sin(0.45 * x + 0.2 * y) + 1.0 * std::cos(0.6 * y - 0.15 * x) + 0.02 * x * y;
}

/// Half of the block, closed, in its right place: above the face, or below.
vtkSmartPointer<vtkActor> Half(bool above)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const bool broken : { true, false })
    for (int row = 0; row <= Rows; ++row)
      for (int column = 0; column <= Columns; ++column)
      {
        const double x = HalfX * (2.0 * column / Columns - 1.0),
                     y = HalfY * (2.0 * row / Rows - 1.0);
        points->InsertNextPoint(x, y, broken ? Face(x, y) : above ? HalfZ : -HalfZ);
      }
  const auto at = [](bool broken, int column, int row)
  { return vtkIdType((broken ? 0 : (Rows + 1) * (Columns + 1)) + row * (Columns + 1) + column); };
  const auto quad = [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d, bool turned)
  {
    const vtkIdType one[3] = { a, turned ? c : b, turned ? b : c },
                    two[3] = { a, turned ? d : c, turned ? c : d };
    cells->InsertNextCell(3, one);
    cells->InsertNextCell(3, two);
  };
  for (int row = 0; row < Rows; ++row)
    for (int column = 0; column < Columns; ++column)
      for (const bool broken : { true, false })
        quad(at(broken, column, row), at(broken, column + 1, row), at(broken, column + 1, row + 1),
          at(broken, column, row + 1), broken == above);
  for (int column = 0; column < Columns; ++column)
    for (const int row : { 0, Rows })
      quad(at(true, column, row), at(true, column + 1, row), at(false, column + 1, row),
        at(false, column, row), (row != 0) == above);
  for (int row = 0; row < Rows; ++row)
    for (const int column : { 0, Columns })
      quad(at(true, column, row), at(true, column, row + 1), at(false, column, row + 1),
        at(false, column, row), (column == 0) == above);
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

PlanFragment Fragment(PlanId id, const glm::dvec3& off)
{
  PlanFragment fragment;
  fragment.id = id;
  fragment.name = "half";
  fragment.source = LabelSource{ 2, id, 226.0, 0.5 };
  fragment.scanToPlanned.position = off;
  return fragment;
}

/// The block's lower half is the reference; the upper half, 2 mm too high and aside; a ball.
Plan BrokenPlan()
{
  Plan plan;
  plan.volumes = { { 1, "scan", std::string(64, 'a') } };
  plan.segmentations = { { 2, "halves", 1, std::string(64, 'b') } };
  plan.fragments = { Fragment(Lower, {}), Fragment(Upper, { 0.6, 0.5, 2.0 }),
    Fragment(Other, { 0, 0, 60 }) };
  plan.fragments[0].locked = true;
  plan.nextId = 6;
  return plan;
}

/// Seen from the side, half a millimetre a pixel.
struct Scene : Frames
{
  Scene()
  {
    this->window->SetOffScreenRendering(true);
    this->window->SetMultiSamples(0);
    vtkCamera* camera = this->renderer->GetActiveCamera();
    camera->SetPosition(0, -100, 0);
    camera->SetViewUp(0, 0, 1);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(50.0);
    this->interactor->SetRenderWindow(this->window);
    this->interactor->SetInteractorStyle(nullptr);
    for (vtkActor* actor : { this->lower.Get(), this->upper.Get(), this->other.Get() })
      this->renderer->AddActor(actor);
    this->session->SetHistory(this->history);
    this->session->SetInteractor(this->haptic);
    EXPECT_TRUE(this->session->AddFragment(Lower, this->lower));
    EXPECT_TRUE(this->session->AddFragment(Upper, this->upper));
    EXPECT_TRUE(this->session->AddFragment(Other, this->other));
    EXPECT_TRUE(this->session->Follow());
  }
  void Begin()
  {
    UpdateUntilReady(this->haptic);
    ASSERT_TRUE(this->haptic->Start());
    this->haptic->Update();
    this->window->Render();
  }
  const PlanPose& PoseOf(PlanId id) const
  {
    return FindPlanObject<PlanFragment>(this->history->Current(), id)->scanToPlanned;
  }
  /// By how much the broken face is off, rms, mm: its right place is the identity.
  double Off() const
  {
    double sum = 0.0;
    int count = 0;
    for (double x = -HalfX; x <= HalfX; x += 2.0)
      for (double y = -HalfY; y <= HalfY; y += 2.0, ++count)
      {
        const glm::dvec3 p(x, y, Face(x, y)), off = this->PoseOf(Upper).Place(p) - p;
        sum += glm::dot(off, off);
      }
    return std::sqrt(sum / count);
  }
  void Say(unsigned long event, double x, double z)
  {
    this->interactor->SetEventInformation(int(100 + 2 * x), int(100 + 2 * z));
    this->interactor->InvokeEvent(event);
    this->haptic->Update();
  }
  void LetGo(double x, double z)
  {
    this->Say(vtkCommand::LeftButtonReleaseEvent, x, z);
    while (this->haptic->GetHeldTool() >= 0) // until a tick has seen it
    {
      std::this_thread::yield();
      this->haptic->Update();
    }
  }
  void Wait(std::uint64_t ticks)
  {
    this->UntilTicks(this->haptic->GetLoop()->GetSnapshot().ticks + ticks);
  }

  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkSmartPointer<vtkActor> lower = Half(false), upper = Half(true), other = BallActor(4.0);
  std::shared_ptr<PlanHistory> history = std::make_shared<PlanHistory>(BrokenPlan());
  vtkNew<vtkHaspReductionSession> session;
};

/// Takes the upper half by its side, puts it down by two millimetres, lets it go.
double OffAfterADrag(bool snap)
{
  Scene scene;
  scene.haptic->SetSnapToFit(snap);
  EXPECT_TRUE(scene.haptic->UseMouse());
  scene.Begin();
  const Count changed(scene.session, vtkHaspReductionSession::PlanChangedEvent);
  scene.Say(vtkCommand::LeftButtonPressEvent, 2.0, 8.0);
  EXPECT_EQ(scene.haptic->GetHeldTool(), scene.session->GetTool(Upper));
  scene.Say(vtkCommand::MouseMoveEvent, 2.0, 8.0);
  scene.Say(vtkCommand::MouseMoveEvent, 2.0, 6.0);
  scene.Wait(2000);
  scene.LetGo(2.0, 6.0);
  EXPECT_EQ(changed.times, 1);
  EXPECT_EQ(scene.history->ToRedo(), nullptr);
  const PlanPose kept = scene.PoseOf(Upper);
  EXPECT_LT(glm::length(Pose(scene.upper).position - kept.position), 1e-9);
  const double off = scene.Off();
  scene.history->Undo();
  EXPECT_EQ(scene.PoseOf(Upper).position, glm::dvec3(0.6, 0.5, 2.0));
  EXPECT_TRUE(scene.session->Follow());
  EXPECT_EQ(Pose(scene.upper).position, glm::dvec3(0.6, 0.5, 2.0));
  EXPECT_EQ(scene.history->ToUndo(), nullptr); // to follow is no step
  return off;
}

TEST(ReductionSession, AMouseSnapsAFragmentIntoThePlan)
{
  const double snapped = OffAfterADrag(true), touched = OffAfterADrag(false);
  RecordProperty("snapped_mm", std::to_string(snapped));
  RecordProperty("touched_mm", std::to_string(touched));
  EXPECT_LT(snapped, 0.3);
  EXPECT_LT(snapped, 0.6 * touched);
}

TEST(ReductionSession, ASixDofMouseLeavesTheSameKindOfStep)
{
  Scene scene;
  scene.haptic->SetSnapToFit(true);
  ASSERT_TRUE(scene.haptic->UseMouse());
  scene.Begin();
  ASSERT_TRUE(scene.haptic->Grab(scene.session->GetTool(Upper)));
  vtkTDxMotionEventInfo down{ 0.0, -175.0, 0.0, 0.0, 0.0, 1.0, 0.0 }, rest{ 0, 0, 0, 0, 0, 1, 0 };
  scene.interactor->InvokeEvent(vtkCommand::TDxMotionEvent, &down);
  scene.Wait(67); // 2 mm at half of 60 mm/s
  scene.interactor->InvokeEvent(vtkCommand::TDxMotionEvent, &rest);
  scene.Wait(1500);
  scene.haptic->Release();
  ASSERT_NE(scene.history->ToUndo(), nullptr);
  EXPECT_LT(scene.Off(), 0.3);
}

TEST(ReductionSession, AHapticDeviceMovesAGroupAsOne)
{
  Scene scene;
  PlanGroup group;
  group.id = scene.history->NewId();
  group.name = "both";
  group.fragments = { Upper, Other };
  scene.history->Do(AddObject<PlanGroup>{ group });
  ASSERT_TRUE(scene.session->Follow());
  EXPECT_EQ(scene.session->GetTool(Upper), scene.session->GetTool(Other));
  ASSERT_TRUE(
    scene.haptic->SetDevice(HandAt(At(0, 0, 0), { MinimumJerkMotion{ At(3, 0, 0), 0.5 } })));
  scene.Begin();
  const glm::dvec3 upper = scene.PoseOf(Upper).position, other = scene.PoseOf(Other).position;
  ASSERT_TRUE(scene.haptic->Grab(scene.session->GetTool(Other)));
  scene.Wait(1500);
  scene.haptic->Release();
  const glm::dvec3 moved = scene.PoseOf(Upper).position - upper;
  EXPECT_GT(glm::length(moved), 1.0);
  // One rigid motion of both.
  const PlanPose a = scene.PoseOf(Upper), b = scene.PoseOf(Other);
  EXPECT_LT(glm::length((b.position - a.position) - a.orientation * (other - upper)), 1e-6);
  EXPECT_EQ(scene.history->Current().groups.size(), 1u);
  scene.history->Undo();
  EXPECT_EQ(scene.PoseOf(Upper).position, upper);
  EXPECT_EQ(scene.PoseOf(Other).position, other); // one step moved both
}

TEST(ReductionSession, WhatIsLockedStaysAndWhatIsResectedIsNotFelt)
{
  Scene scene;
  EXPECT_EQ(scene.session->GetTool(Lower), -1);
  EXPECT_GE(scene.session->GetTool(Upper), 0);
  scene.history->Do(SetFragmentState{ { Other }, FragmentState::Resected });
  ASSERT_TRUE(scene.session->Follow());
  EXPECT_EQ(scene.session->GetTool(Other), -1);
}

TEST(ReductionSession, AStepThatThePlanRefusesPutsThePropsBack)
{
  Scene scene;
  scene.haptic->SetSnapToFit(false);
  ASSERT_TRUE(scene.haptic->UseMouse());
  scene.Begin();
  scene.Say(vtkCommand::LeftButtonPressEvent, 2.0, 8.0);
  ASSERT_EQ(scene.haptic->GetHeldTool(), scene.session->GetTool(Upper));
  scene.Say(vtkCommand::MouseMoveEvent, 2.0, 8.0);
  scene.Say(vtkCommand::MouseMoveEvent, 2.0, 14.0);
  scene.Wait(300);
  EXPECT_FALSE(ErrorsOf(scene.session, [&] { scene.session->Follow(); }).empty()); // in hand
  PlanFragment locked = *FindPlanObject<PlanFragment>(scene.history->Current(), Upper);
  locked.locked = true;
  scene.history->Do(ChangeObject<PlanFragment>{ locked });
  const std::string said = ErrorsOf(scene.session, [&] { scene.LetGo(2.0, 14.0); });
  EXPECT_NE(said.find("locked"), std::string::npos) << said;
  EXPECT_EQ(Pose(scene.upper).position, glm::dvec3(0.6, 0.5, 2.0));
}

TEST(ReductionSession, WhatIsMissingIsSaid)
{
  vtkNew<vtkHaspReductionSession> session;
  const auto ball = BallActor(5.0);
  EXPECT_NE(
    ErrorsOf(session, [&] { EXPECT_FALSE(session->Follow()); }).find("history"), std::string::npos);
  session->SetHistory(std::make_shared<PlanHistory>(BrokenPlan()));
  EXPECT_FALSE(ErrorsOf(session, [&] { EXPECT_FALSE(session->AddFragment(9, ball)); }).empty());
  EXPECT_TRUE(session->AddFragment(Lower, ball));
  EXPECT_FALSE(ErrorsOf(session, [&] { EXPECT_FALSE(session->AddFragment(Upper, ball)); }).empty());
}

} // namespace
