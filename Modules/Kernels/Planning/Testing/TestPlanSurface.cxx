#include "Planning/DerivedPart.h"
#include "Planning/PlanEdits.h"
#include "Planning/PlanLists.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

namespace
{
using namespace hasp;

/// volume 1, surface 2, fragment 3 of the volume, 4 of the surface, group 5 of both, group 6 of 3.
Plan Case()
{
  Plan plan;
  plan = Apply(plan, AddObject<PlanVolume>{ { 1, "", std::string(64, 'a') } });
  plan = Apply(plan, AddObject<PlanSurface>{ { 2, "sherd", std::string(64, 'b') } });
  PlanFragment fragment;
  fragment.id = 3;
  fragment.source = ComponentSource{ 1, 226, { 0, 0, 0 } };
  plan = Apply(plan, AddObject<PlanFragment>{ fragment });
  fragment.id = 4;
  fragment.source = SurfaceSource{ 2, 3.0, SheetSide::Both, 0.4 };
  plan = Apply(plan, AddObject<PlanFragment>{ fragment });
  plan = Apply(plan, AddObject<PlanGroup>{ { 5, "", { 3, 4 } } });
  return Apply(plan, AddObject<PlanGroup>{ { 6, "", { 3 } } });
}

std::string Refusal(const std::function<void()>& act)
{
  try
  {
    act();
    return {};
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
}

std::string Refused(const PlanEdit& edit)
{
  return Refusal([&] { Apply(Case(), edit); });
}

PlanFragment Sherd(const SurfaceSource& source)
{
  PlanFragment fragment = Case().fragments[1];
  fragment.source = source;
  return fragment;
}

TEST(PlanSurface, FaultsAreNamedByTheirKey)
{
  ValidatePlan(Case());
  EXPECT_EQ(Refused(AddObject<PlanSurface>{ { 7, "", "" } }).find("surface 7: hash"), 0U);
  EXPECT_EQ(Refused(ChangeObject<PlanFragment>{ Sherd({ 1, 0.0 }) }),
    "fragment 4: source.surface is 1, must be the id of a surface of the plan");
  EXPECT_EQ(Refused(ChangeObject<PlanFragment>{ Sherd({ 2, -1.0 }) }),
    "fragment 4: source.thicknessMm is -1, must be in [0, 50]");
  EXPECT_EQ(Refused(ChangeObject<PlanFragment>{ Sherd({ 2, 1.0, SheetSide::Behind, 0.01 }) }),
    "fragment 4: source.spacingMm is 0.01, must be in [0.1, 2]");
  EXPECT_EQ(
    Refused(RemoveObject{ 2 }), "surface 2: is named by fragment 4; remove or change that first");
}

TEST(PlanSurface, WhatIsMadeOfVoxelsIsRefusedOfIt)
{
  const std::string must =
    "must be a fragment of a scan: a surface's cannot be cut, guided or plated";
  EXPECT_EQ(
    Refused(AddObject<PlanCut>{ { 7, "", {}, { 3, 4 } } }), "cut 7: fragments[1] is 4, " + must);
  PlanFragment piece;
  piece.id = 7;
  piece.source = PieceSource{ 4, { 0, 0, 0 } };
  EXPECT_EQ(Refused(AddObject<PlanFragment>{ piece }), "fragment 7: source.fragment is 4, " + must);
  PlanGuide guide;
  guide.id = 7;
  guide.bone = 4;
  guide.recipe.landmarks = { { 0, 0, 0 }, { 10, 0, 0 } };
  EXPECT_EQ(Refused(AddObject<PlanGuide>{ guide }),
    "guide 7: bone is 4, must be a volume, or a fragment of a scan: a surface's cannot be guided");
  PlanPlate plate{ 7, "", 0, { 4 }, {} };
  plate.recipe.landmarks = { { 0, 0, 0 }, { 10, 0, 0 } };
  EXPECT_EQ(Refused(AddObject<PlanPlate>{ plate }), "plate 7: fragments[0] is 4, " + must);
}

TEST(PlanSurface, AFragmentStaysOfItsKind)
{
  const std::string why =
    "a scan's fragment stays a scan's, and a surface's a surface's; add another";
  PlanFragment fragment = Case().fragments[0];
  fragment.source = SurfaceSource{ 2 };
  EXPECT_EQ(Refused(ChangeObject<PlanFragment>{ fragment }), "fragment 3: " + why);
  fragment = Case().fragments[1];
  fragment.source = ComponentSource{ 1, 226, { 0, 0, 0 } };
  EXPECT_EQ(Refused(ChangeObject<PlanFragment>{ fragment }), "fragment 4: " + why);
  EXPECT_EQ(Refused(ChangeObject<PlanFragment>{ Sherd({ 2, 5.0 }) }), "");
  EXPECT_TRUE(IsOfScan(Case(), 3));
  EXPECT_FALSE(IsOfScan(Case(), 4));
  EXPECT_FALSE(IsOfScan(Case(), 2));
}

TEST(PlanSurface, IsPosedGroupedAndMeasuredAsAnyFragment)
{
  Plan plan = Case();
  plan = Apply(plan, MovedGroup(plan, 5, { { 0, 0, 9 }, { 1, 0, 0, 0 } }));
  EXPECT_EQ(plan.fragments[1].scanToPlanned.position, glm::dvec3(0, 0, 9));
  plan = Apply(plan, SetFragmentState{ { 4 } });
  EXPECT_EQ(plan.fragments[1].state, FragmentState::Resected);
  plan = Apply(plan, AddObject<PlanMeasure>{ { 7, "", MeasureKind::Distance,
                       { { 0, { 0, 0, 0 } }, { 4, { 0, 0, 0 } } } } });
  EXPECT_EQ(MeasureValue(plan, plan.measures[0]), 9.0);
}

TEST(PlanSurface, NothingIsMadeOfItAndItsPartsAreNotOwed)
{
  const Plan plan = Case();
  EXPECT_EQ(PartObjects(plan), (std::vector<PlanId>{ 3, 6 }));
  EXPECT_FALSE(IsPartObject(plan, 4));
  EXPECT_FALSE(IsPartObject(plan, 5));
  EXPECT_EQ(
    Refusal([&] { PartInputs(plan, 4); }).find("fragment 4: nothing is made of a surface"), 0U);
}

TEST(PlanMirror, FaultsAreNamedByTheirKey)
{
  const std::string oneOfTwo =
    "mirror 7: volume and fragments must be one of the two: a scan's bone, or fragments";
  EXPECT_EQ(Refused(AddObject<PlanMirror>{ { 7, "", 1, { 3 }, 226, {} } }), oneOfTwo);
  EXPECT_EQ(Refused(AddObject<PlanMirror>{ { 7, "", 0, {}, 226, {} } }), oneOfTwo);
  EXPECT_EQ(Refused(AddObject<PlanMirror>{ { 7, "", 3, {}, 226, {} } }),
    "mirror 7: volume is 3, must be the id of a volume of the plan");
  EXPECT_EQ(Refused(AddObject<PlanMirror>{ { 7, "", 0, { 3, 3 }, 226, {} } }),
    "mirror 7: fragments must name each once");
  EXPECT_EQ(Refused(AddObject<PlanMirror>{ { 7, "", 1, {}, 226, MirrorPlane{ {}, { 2, 0, 0 } } } })
              .find("mirror 7: plane.normal"),
    0U);
  const Plan plan = Apply(Case(), AddObject<PlanMirror>{ { 7, "", 0, { 3, 4 }, 226, {} } });
  ValidatePlan(plan);
  EXPECT_EQ(EditLabel(plan, RemoveObject{ 7 }), "Remove mirror 7");
  EXPECT_FALSE(IsPartObject(plan, 7)); // a ghost is no part
  EXPECT_EQ(UsersOf(plan, 4), (std::vector<PlanId>{ 5, 7 }));
}

} // namespace
