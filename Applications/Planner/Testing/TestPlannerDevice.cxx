// A haptic device moves what the mouse does: places, strokes, blades, fragments.
#include "StepsDesk.h"

#include "Planning/PlanLists.h"
#include "Steps/CutPanel.h"
#include "Tools/BladeTool.h"
#include "Tools/DevicePointer.h"
#include "Tools/GrabTool.h"
#include "Tools/LandmarkTool.h"
#include "Tools/PaintTool.h"
#include "Tools/RecordedHand.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <memory>

namespace
{
using namespace hasp;
using namespace hasp::testing;

/// Where a device's tip is to be, in the world, and for how long it takes to get there.
struct Way
{
  glm::dvec3 place;
  double forS = 0.4;
  bool pressed = false;
};

/// A hand that goes such a way, as a recording: in the axes that the view has now.
class HandPath
{
public:
  explicit HandPath(FrameView& view)
  {
    vtkCamera* camera = view.Renderer()->GetActiveCamera();
    glm::dvec3 way, up;
    camera->GetFocalPoint(&this->Focus.x);
    camera->GetDirectionOfProjection(&way.x);
    camera->GetViewUp(&up.x);
    const glm::dvec3 right = glm::normalize(glm::cross(way, up));
    this->Axes = { right, glm::cross(right, way), -way };
  }
  void Go(const Way& way)
  {
    const glm::dvec3 to = glm::transpose(this->Axes) * (way.place - this->Focus), from = this->At;
    const int ticks = int(1000.0 * way.forS);
    for (int tick = 1; tick <= ticks; ++tick)
    {
      HapticRecord record;
      record.number = this->Hand.records.size();
      record.nowNs = std::int64_t(record.number) * this->Hand.periodNs;
      record.sample.timeNs = record.nowNs;
      record.sample.pose.position = from + (double(tick) / ticks) * (to - from);
      record.sample.buttons = way.pressed ? 1U : 0U;
      this->Hand.records.push_back(record);
    }
    this->At = to;
  }
  /// In and out at a place.
  void Click(const glm::dvec3& place)
  {
    this->Go({ place });
    this->Go({ place, 0.4, true });
    this->Go({ place });
  }
  void Drag(const glm::dvec3& from, const glm::dvec3& to)
  {
    this->Go({ from });
    this->Go({ from, 0.4, true });
    this->Go({ to, 0.5, true });
    this->Go({ to, 0.3, true });
    this->Go({ to });
  }
  std::unique_ptr<HapticDevice> Device() const
  {
    return std::make_unique<RecordedHand>(std::make_shared<HapticRecording>(this->Hand));
  }

private:
  glm::dvec3 Focus{ 0.0 }, At{ 0.0 };
  glm::dmat3 Axes{ 1.0 };
  HapticRecording Hand;
};

class PlannerDevice : public ::testing::Test
{
protected:
  /// Takes the tool with that hand until something holds.
  bool Take(Tool& tool, const HandPath& hand, const std::function<bool()>& until)
  {
    this->desk.planner.openDevice = [&hand] { return hand.Device(); };
    this->desk.planner.tools.Take(&tool);
    const bool holds = this->desk.views.Wait(until, 20'000);
    this->desk.Settle();
    return holds;
  }
  HandPath Path() { return HandPath(this->desk.views.scene); }

  StepsDesk desk{ ScanOfBar() };
  DevicePointer pointer{ this->desk.planner };
};

TEST_F(PlannerDevice, NoneIsMadeForAToolWithoutOne)
{
  LandmarkTool tool(this->desk.planner, {});
  this->desk.planner.tools.Take(&tool);
  EXPECT_FALSE(this->pointer.IsOn());
  this->desk.planner.openDevice = [] { return std::unique_ptr<HapticDevice>(); };
  this->desk.planner.tools.Take(nullptr);
  this->desk.planner.tools.Take(&tool);
  EXPECT_FALSE(this->pointer.IsOn());
}

TEST_F(PlannerDevice, TouchesBoneWhereItsTipIs)
{
  LandmarkTool tool(this->desk.planner, {});
  HandPath hand = this->Path();
  for (const double x : { -12.0, 3.0, 15.0 })
    hand.Click(Front(x));
  EXPECT_TRUE(this->Take(tool, hand, [&] { return tool.Places().size() == 3; }));
  ASSERT_EQ(tool.Places().size(), 3U);
  const double at[3]{ -12.0, 3.0, 15.0 };
  for (std::size_t n = 0; n < 3; ++n)
  {
    EXPECT_LT(OffBar(tool.Places()[n].world), SurfaceMm);
    EXPECT_NEAR(tool.Places()[n].world.x, at[n], ClickMm);
  }
  EXPECT_TRUE(this->pointer.IsOn());
  this->desk.planner.tools.Take(nullptr);
  EXPECT_FALSE(this->pointer.IsOn());
}

TEST_F(PlannerDevice, PaintsAStroke)
{
  PaintTool tool(this->desk.planner);
  HandPath hand = this->Path();
  hand.Drag(Front(-10.0), Front(10.0));
  const std::size_t before = this->desk.Steps();
  EXPECT_TRUE(this->Take(tool, hand, [&] { return this->desk.Steps() > before; }));
  EXPECT_EQ(this->desk.Steps(), before + 1) << this->desk.said.toStdString();
  ASSERT_EQ(this->desk.Now().segmentations.size(), 1U);
  this->desk.planner.tools.Take(nullptr);
}

TEST_F(PlannerDevice, MovesABladeByItsHandle)
{
  const PlanId cut = this->desk.CutBar(0.0);
  BladeTool tool(this->desk.planner);
  tool.SetCut(cut);
  const Osteotomy before = FindPlanObject<PlanCut>(this->desk.Now(), cut)->blade;
  HandPath hand = this->Path();
  const glm::dvec3 grip = HandlePlace(before, BladeHandle::Normal);
  hand.Drag(grip, grip + 5.0 * before.normal);
  const auto way = [&]
  {
    const Osteotomy now = FindPlanObject<PlanCut>(this->desk.Now(), cut)->blade;
    return glm::dot(now.point - before.point, before.normal);
  };
  EXPECT_TRUE(this->Take(tool, hand, [&] { return way() != 0.0; }));
  EXPECT_NEAR(way(), 5.0, ClickMm);
  this->desk.planner.tools.Take(nullptr);
}

TEST_F(PlannerDevice, TakesAFragmentInHand)
{
  this->desk.CutBar(0.0); // it is a fragment by that
  const PlanId bar = this->desk.Now().fragments.at(0).id;
  GrabTool tool(this->desk.planner);
  HandPath hand = this->Path();
  hand.Go({ Front(10.0), 3.0 }); // while what can be felt is made
  hand.Drag(Front(10.0), Front(10.0) + glm::dvec3(0.0, -4.0, 8.0));
  const auto moved = [&]
  { return FindPlanObject<PlanFragment>(this->desk.Now(), bar)->scanToPlanned.position; };
  EXPECT_TRUE(this->Take(tool, hand, [&] { return moved() != glm::dvec3(0.0); }));
  EXPECT_FALSE(this->pointer.IsOn()) << "the tool has the device";
  EXPECT_LT(glm::distance(moved(), { 0.0, -4.0, 8.0 }), 0.5) << this->desk.said.toStdString();
  this->desk.planner.tools.Take(nullptr);
}

} // namespace
