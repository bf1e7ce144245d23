// A chin that is resected and made anew of two segments of a fibula, with the guide for the saw: as
// a user does it.
#include "SampleCase.h"

#include "../../CommandLine/Testing/HaspProcess.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <iostream>

namespace
{

using glm::dvec3;

/// Ids as the plan gives them: scans 1 and 2, the jaw 3, cuts 4 and 5, pieces 6 to 8, the leg 9.
class PlannerFibula : public SampleCase
{
protected:
  static constexpr int LeftStump = 6, RightStump = 7, Chin = 8, Fibula = 9;

  /// Seen from below, each across its arm of the jaw.
  static void CutTheChinOut(PlannerProcess& planner)
  {
    planner.Click("step.cut");
    LookFrom(planner, "alt+shift+7");
    planner.Click("cut.place");
    Touch(planner, { { -0.113, -0.218 }, { -0.085, -0.200 } });
    planner.Click("cut.new");
    Touch(planner, { { 0.0464, -0.300 }, { 0.0464, -0.276 } });
    planner.ClickRow("cut.pages", 2);
    planner.Click("cut.pieces");
    planner.ClickId("cut.piece.list", Chin);
    planner.Click("cut.resect");
  }
  /// Along the chin that is seen as a ghost, from stump to stump.
  static void LayThePath(PlannerProcess& planner)
  {
    planner.Click("step.plate");
    planner.Choose("plate.kind", 2);
    planner.Click("transplant.new");
    Touch(planner, { { -0.090, -0.221 }, { -0.050, -0.287 }, { 0.034, -0.287 } });
    planner.Click("transplant.middle");
    EXPECT_FALSE(planner.Has("transplant.fault")) << planner.Text("transplant.fault");
  }
  static void TouchTheDonor(PlannerProcess& planner)
  {
    planner.ClickRow("transplant.pages", 1);
    planner.Click("transplant.look.donor");
    LookFrom(planner, "alt+1");
    planner.Click("transplant.tips");
    Touch(planner, { { -0.003, -0.480 }, { -0.003, 0.478 } });
    planner.SetNumber("transplant.between", 7); // slots of the guide need room
    EXPECT_NE(planner.Text("transplant.segments").find("Segment 2"), std::string::npos)
      << planner.Text("transplant.segments");
  }
  static void PlanTheSawGuide(PlannerProcess& planner)
  {
    planner.Choose("plate.kind", 3);
    planner.Click("mitre.new");
  }
  /// The guide goes onto the leg where it is planned, before it is printed.
  static void TryTheGuideOn(PlannerProcess& planner)
  {
    planner.ClickRow("check.table", 0);
    planner.Key("ctrl+End"); // the last part
    planner.Click("check.seat");
    const std::string seat = planner.Text("check.seat.result");
    std::cout << seat << '\n';
    EXPECT_NE(seat.find("seats"), std::string::npos)
      << planner.State("message") << planner.Text("check.fit.state");
  }

  static dvec3 PointOf(const Json& numbers)
  {
    const auto p = numbers.get<std::array<double, 3>>();
    return { p[0], p[1], p[2] };
  }
  /// What was planned, against the phantom's closed forms: the jaw's middle line has a corner at
  /// the chin's right end and lies at z = -96; the leg's is a bow of 5 mm.
  void ExpectInTheDefect() const
  {
    const Json plan = Json::parse(ReadBytes(this->SavedPlan() + "/plan.json")).at("plan");
    EXPECT_EQ(plan.at("fragments").at(3).at("state"), "resected");
    const Json& planned = plan.at("transplants").at(0);
    EXPECT_EQ(planned.at("donor"), Fibula);
    EXPECT_EQ(planned.at("first"), (Json{ { "cut", 4 }, { "fragment", RightStump } }));
    EXPECT_EQ(planned.at("last"), (Json{ { "cut", 5 }, { "fragment", LeftStump } }));
    const Json& joints = planned.at("transplant").at("joints");
    ASSERT_EQ(joints.size(), 3U);
    const std::array<dvec3, 3> truth{ dvec3(-27.0574, -54.0462, -96.0),
      dvec3(-13.0740, -75.6938, -96.0), dvec3(13.0740, -75.6938, -96.0) };
    double mostMm = 0.0;
    for (std::size_t n = 0; n < truth.size(); ++n)
    {
      const dvec3 joint = PointOf(joints[n].at("point"));
      const double offMm = glm::distance(joint, truth[n]);
      std::cout << "joint " << n << ": " << offMm << " mm from the jaw's line\n";
      mostMm = std::max(mostMm, offMm);
      EXPECT_LT(offMm, 5.0);                 // touched by eye on a jaw of 10 mm
      EXPECT_NEAR(joint.z, truth[n].z, 3.0); // its underside is 8 mm below
    }
    RecordProperty("off_mm", std::to_string(mostMm));
    const Json& axis = planned.at("transplant").at("donor").at("axis");
    ASSERT_GT(axis.size(), 20U);
    for (std::size_t n = 1; n + 1 < axis.size(); ++n)
    {
      const dvec3 place = PointOf(axis[n]);
      EXPECT_NEAR(place.y, -5.0 * (1.0 - place.z * place.z / 28'900.0), 1.0);
      EXPECT_NEAR(place.x, 0.0, 1.0);
    }
  }
};

TEST_F(PlannerFibula, AChinIsMadeOfTwoSegmentsAndTheirSawGuideExported)
{
  const auto planner = this->BeginSample("file.sample.fibula");
  CutTheChinOut(*planner);
  LayThePath(*planner);
  TouchTheDonor(*planner);
  PlanTheSawGuide(*planner);
  SaveAs(*planner, this->SavedPlan());
  this->ExpectInTheDefect();
  ASSERT_EQ(MakeAll(*planner), "mitre-guide 11 is made: green, held to fragment 9 alone.");
  Picture(*planner, "PlannerFibula-sawn");
  TryTheGuideOn(*planner);
  planner->Click("step.plate");
  planner->Choose("plate.kind", 2);
  planner->ClickRow("transplant.pages", 0);
  planner->Click("transplant.look.jaw");
  LookFrom(*planner, "alt+shift+7");
  Picture(*planner, "PlannerFibula-planned");
  EXPECT_LE(planner->Effort().clicks, 250U);
  ExpectThereAndBack(*planner);
  this->ExpectExportAsRun(*planner, "PlannerFibula");
  EXPECT_EQ(this->Verdicts()["mitre-guide-11.stl"], "green");
  planner->Key("ctrl+s");
  Close(*planner, "a chin of two segments");
}

} // namespace
