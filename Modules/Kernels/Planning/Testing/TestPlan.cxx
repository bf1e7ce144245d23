#include "Planning/PlanEdits.h"
#include "Planning/PlanLists.h"
#include "RandomEdits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace
{
using namespace hasp;

/// volume 1, segmentation 2, fragments 3, 4 (a piece of 3) and 5 (locked), cut 6, group 7, guide 8,
/// measures 9 and 10.
Plan Case()
{
  Plan plan;
  const auto add = [&]<typename T>(T object)
  {
    object.id = plan.nextId;
    plan = Apply(plan, AddObject<T>{ object });
  };
  add(PlanVolume{ 0, "head", std::string(64, 'a') });
  add(PlanSegmentation{ 0, "bones", 1, std::string(64, 'b') });
  PlanFragment fragment;
  fragment.source = LabelSource{ 2, 1 };
  add(fragment);
  fragment.source = PieceSource{ 3, { 1, 2, 3 } };
  add(fragment);
  fragment.source = ComponentSource{ 1, 226, { 0, 0, 0 } };
  fragment.locked = true;
  add(fragment);
  add(PlanCut{ 0, "left", {}, { 3 } });
  add(PlanGroup{ 0, "mandible", { 3, 4 } });
  PlanGuide guide;
  guide.bone = 5;
  guide.recipe.landmarks = { { 0, 0, 0 }, { 10, 0, 0 } };
  guide.cuts = { 6 };
  add(guide);
  add(PlanMeasure{ 0, "gap", MeasureKind::Distance, { { 0, { 0, 0, 0 } }, { 4, { 3, 0, 0 } } } });
  add(PlanMeasure{ 0, "angle", MeasureKind::Angle,
    { { 0, { 1, 0, 0 } }, { 0, { 0, 0, 0 } }, { 0, { -1, 1, 0 } } } });
  return plan;
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

/// What a plan that was spoilt behind the edits' back is refused with.
std::string Spoilt(const std::function<void(Plan&)>& spoil)
{
  Plan plan = Case();
  spoil(plan);
  return Refusal([&] { ValidatePlan(plan); });
}

std::string Refused(const PlanEdit& edit)
{
  const Plan plan = Case();
  return Refusal([&] { Apply(plan, edit); });
}

TEST(Plan, FaultsAreNamedByTheirKey)
{
  const double nan = std::nan("");
  EXPECT_EQ(Spoilt([](Plan&) {}), "");
  EXPECT_EQ(
    Spoilt([](Plan& p) { p.nextId = 10; }), "plan: measures[1].id is 10, must be below nextId");
  EXPECT_EQ(Spoilt([](Plan& p) { p.nextId = MaxPlanId + 2; }).find("plan: nextId is 1e+09"), 0U);
  EXPECT_EQ(Spoilt([](Plan& p) { p.volumes[0].id = 0; }),
    "plan: volumes[0].id is 0, must be above that of the entry before");
  EXPECT_EQ(Spoilt([](Plan& p) { p.fragments[1].id = 3; }),
    "plan: fragments[1].id is 3, must be above that of the entry before");
  EXPECT_EQ(Spoilt([](Plan& p) { p.cuts[0].id = 3; }),
    "plan: cuts[0].id is 3, must be given once in the plan");
  EXPECT_EQ(Spoilt([](Plan& p) { p.segmentations[0].volume = 3; }),
    "plan: segmentations[0]: volume is 3, must be the id of a volume of the plan");
  EXPECT_EQ(Spoilt([](Plan& p) { p.guides[0].cuts = { 5 }; }),
    "plan: guides[0]: cuts[0] is 5, must be the id of a cut of the plan");
  EXPECT_EQ(Spoilt([](Plan& p) { p.guides[0].bone = 2; }),
    "plan: guides[0]: bone is 2, must be the id of a volume or fragment of the plan");
  EXPECT_EQ(Spoilt(
              [](Plan& p) {
                p.groups[0].fragments = { 3, 3 };
              }),
    "plan: groups[0]: fragments must name each once");
  EXPECT_EQ(Spoilt(
              [](Plan& p) {
                p.fragments[1].source = PieceSource{ 4, {} };
              }),
    "plan: fragments[1]: source.fragment is 4, must be older than the piece's id");
  EXPECT_EQ(Spoilt(
              [](Plan& p) {
                p.fragments[0].source = LabelSource{ 2, 0 };
              }),
    "plan: fragments[0]: source.label is 0, must be in [1, 65535]");
  EXPECT_EQ(Spoilt([=](Plan& p) { p.fragments[2].scanToPlanned.orientation.w = nan; }),
    "plan: fragments[2]: scanToPlanned.orientation's length is nan, must be 1 within 1e-6");
  EXPECT_EQ(Spoilt([](Plan& p) { p.cuts[0].blade.kerfMm = 0; }),
    "plan: cuts[0].blade: kerfMm is 0, must be in (0, 5]");
  EXPECT_EQ(Spoilt([](Plan& p) { p.guides[0].recipe.gapMm = -1; })
              .find("plan: guides[0]: recipe: guide recipe: gapMm is -1"),
    0U);
  EXPECT_EQ(Spoilt([](Plan& p) { p.measures[0].points.pop_back(); }),
    "plan: measures[0]: the number of points is 1, must be 2");
  EXPECT_EQ(Spoilt([](Plan& p) { p.volumes[0].hash[5] = 'A'; }),
    "plan: volumes[0]: hash must be 64 hexadecimal digits in lower case, a SHA-256");
  EXPECT_EQ(Spoilt([](Plan& p) { p.measures.resize(MaxPlanObjects + 1); }),
    "plan: measures has more than 10000 entries");
}

TEST(Plan, TextsAreUtf8AndNotQuoted)
{
  const std::string bad = "plan: volumes[0]: name holds a control character or is not UTF-8";
  const auto named = [](const std::string& name)
  { return Spoilt([&](Plan& p) { p.volumes[0].name = name; }); };
  EXPECT_EQ(named("Unterkiefer \xc3\xa4 \xe9\xaa\xa8 \xf0\x9f\xa6\xb4"), "");
  for (const char* text :
    { "Erika\n", "\x7f", "\xc3", "\x80", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
      "\xf4\x90\x80\x80", "\xff", "\xc2\x85", "\xe9\xaa", "\xf8\x88\x80\x80\x80" })
    EXPECT_EQ(named(text), bad) << text;
  EXPECT_EQ(named(std::string(200, 'x')), "");
  EXPECT_EQ(named(std::string(201, 'x')), "plan: volumes[0]: name is longer than 200 bytes");
  EXPECT_EQ(Spoilt([](Plan& p) { p.caseLabel = std::string("\t"); }),
    "plan: caseLabel holds a control character or is not UTF-8");
}

TEST(Plan, MeasuresFollowTheFragments)
{
  Plan plan = Case();
  EXPECT_DOUBLE_EQ(MeasureValue(plan, plan.measures[0]), 3.0);
  EXPECT_DOUBLE_EQ(MeasureValue(plan, plan.measures[1]), 135.0);
  // A quarter turn about z and 4 mm up: (3, 0, 0) goes to (0, 3, 4), which is 5 mm away.
  const PlanPose pose{ { 0, 0, 4 }, glm::angleAxis(M_PI / 2, glm::dvec3(0, 0, 1)) };
  plan = Apply(plan, PoseFragments{ { { 4, pose } } });
  EXPECT_NEAR(MeasureValue(plan, plan.measures[0]), 5.0, 1e-12);
  PlanMeasure flat = plan.measures[1];
  flat.points[0].point = flat.points[1].point;
  EXPECT_EQ(MeasureValue(plan, flat), 0.0);
}

/// The case, and plate 11 on fragments 3 and 4, implant 12, transplant 13 out of 5 between cut 6's
/// face of fragment 3 and a joint that stays.
Plan Reconstruction()
{
  Plan plan = Case();
  PlanPlate plate{ 11, "", 0, { 3, 4 }, {} };
  plate.recipe.landmarks = { { 0, 0, 0 }, { 10, 0, 0 } };
  PlanImplant implant{ 12, "", 1, {} };
  implant.recipe.outline = { { 0, 0, 0 }, { 10, 0, 0 }, { 0, 10, 0 } };
  PlanTransplant transplant{ 13, "", 5, { 6, 3 }, {}, {}, 0.5, 0.5 };
  const glm::dvec3 line[] = { { 1, 0, 4 }, { 0, 0, 40 } };
  transplant.transplant.joints = MitreJoints(line);
  transplant.transplant.outward = { { 1, 0, 0 } };
  transplant.transplant.donor.axis = { { 0, 0, 0 }, { 0, 0, 350 } };
  plan = Apply(plan, AddObject<PlanPlate>{ plate });
  plan = Apply(plan, AddObject<PlanImplant>{ implant });
  return Apply(plan, AddObject<PlanTransplant>{ transplant });
}

TEST(Plan, PlatesImplantsAndTransplantsAreHeldToTheirRules)
{
  const Plan plan = Reconstruction();
  ValidatePlan(plan);
  const auto plate = [&](const std::function<void(PlanPlate&)>& spoil)
  {
    PlanPlate object = plan.plates[0];
    spoil(object);
    return Refusal([&] { Apply(plan, ChangeObject<PlanPlate>{ object }); });
  };
  const std::string oneOfTwo =
    "plate 11: volume and fragments must be one of the two: a scan as it is, or fragments";
  EXPECT_EQ(plate([](auto& p) { p.volume = 1; }), oneOfTwo);
  EXPECT_EQ(plate([](auto& p) { p.fragments.clear(); }), oneOfTwo);
  EXPECT_EQ(plate(
              [](auto& p) {
                p.fragments = { 3, 6 };
              }),
    "plate 11: fragments[1] is 6, must be the id of a fragment of the plan");
  EXPECT_EQ(plate([](auto& p) { p.recipe.fragments = { {} }; }),
    "plate 11: recipe.fragments must be none: they are the plan's");
  EXPECT_EQ(
    plate([](auto& p) { p.recipe.gapMm = 9; }).find("plate 11: recipe: plate recipe: gapMm"), 0U);
  PlanImplant implant = plan.implants[0];
  implant.volume = 3;
  EXPECT_EQ(Refusal([&] { Apply(plan, ChangeObject<PlanImplant>{ implant }); }),
    "implant 12: volume is 3, must be the id of a volume of the plan");
  PlanTransplant transplant = plan.transplants[0];
  transplant.last.cut = 3;
  EXPECT_EQ(Refusal([&] { Apply(plan, ChangeObject<PlanTransplant>{ transplant }); }),
    "transplant 13: last.cut is 3, must be the id of a cut of the plan");
  transplant = plan.transplants[0];
  transplant.transplant.kerfMm = 0;
  EXPECT_EQ(Refusal([&] { Apply(plan, ChangeObject<PlanTransplant>{ transplant }); })
              .find("transplant 13: transplant: transplant: kerfMm is 0"),
    0U);
  transplant = plan.transplants[0];
  transplant.mostOverlapMm = 11;
  EXPECT_EQ(Refusal([&] { Apply(plan, ChangeObject<PlanTransplant>{ transplant }); }),
    "transplant 13: mostOverlapMm is 11, must be in [0, 10]");
  EXPECT_EQ(Refused(AddObject<PlanCut>{ { 11, "", {}, {}, 501 } }),
    "cut 11: reachMm is 501, must be in [0, 500]");
  EXPECT_EQ(UsersOf(plan, 3), (std::vector<PlanId>{ 4, 7, 6, 11, 13 }));
  EXPECT_EQ(UsersOf(plan, 5), (std::vector<PlanId>{ 8, 13 }));
  EXPECT_EQ(UsersOf(plan, 6), (std::vector<PlanId>{ 8, 13 }));
  EXPECT_EQ(EditLabel(plan, RemoveObject{ 13 }), "Remove transplant 13");
}

TEST(Plan, MitreGuidesAreOfTransplants)
{
  Plan plan = Apply(Reconstruction(), AddObject<PlanMitreGuide>{ { 14, "saw", 13, {} } });
  ValidatePlan(plan);
  const auto change = [&](const std::function<void(PlanMitreGuide&)>& spoil)
  {
    PlanMitreGuide object = plan.mitreGuides[0];
    spoil(object);
    return Refusal([&] { Apply(plan, ChangeObject<PlanMitreGuide>{ object }); });
  };
  EXPECT_EQ(change([](auto& g) { g.transplant = 11; }),
    "mitre-guide 14: transplant is 11, must be the id of a transplant of the plan");
  EXPECT_EQ(change([](auto& g) { g.choices.beyondMm = 4; }),
    "mitre-guide 14: choices.beyondMm is 4, must be in [5, 100]");
  EXPECT_EQ(
    change([](auto& g) { g.name = std::string("\n"); }).find("mitre-guide 14: name holds"), 0U);
  EXPECT_EQ(EditLabel(plan, RemoveObject{ 14 }), "Remove mitre-guide 14");
  EXPECT_EQ(UsersOf(plan, 13), std::vector<PlanId>{ 14 });
  plan.mitreGuides[0].choices.gapMm = -1;
  EXPECT_EQ(Refusal([&] { ValidatePlan(plan); }),
    "plan: mitreGuides[0]: choices.gapMm is -1, must be in [0, 10]");
}

TEST(Plan, APlatesFragmentsAreWhereTheReductionPutsThem)
{
  Plan plan = Reconstruction();
  const PlanPose pose{ { 1, 2, 3 }, glm::angleAxis(0.5, glm::dvec3(0, 0, 1)) };
  plan = Apply(plan, PoseFragments{ { { 4, pose } } });
  PlateRecipe recipe = PlateRecipeOf(plan, plan.plates[0]);
  ASSERT_EQ(recipe.fragments.size(), 2U);
  EXPECT_EQ(recipe.fragments[0], PlateFragment{});
  EXPECT_EQ(recipe.fragments[1], (PlateFragment{ 2, pose.position, pose.orientation }));
  ValidatePlateRecipe(recipe);
  plan = Apply(plan, SetFragmentState{ { 3 } });
  recipe = PlateRecipeOf(plan, plan.plates[0]);
  ASSERT_EQ(recipe.fragments.size(), 1U);
  EXPECT_EQ(recipe.fragments[0].label, 2);
}

TEST(Plan, ATransplantsJointsFollowTheirCuts)
{
  Plan plan = Reconstruction();
  PlanCut cut = plan.cuts[0];
  cut.blade = { { 5, 5, 3 }, { 0, 0, -1 }, { 1, 0, 0 }, 60, 60, 2.0 };
  plan = Apply(plan, ChangeObject<PlanCut>{ cut });
  Transplant placed = TransplantOf(plan, plan.transplants[0]);
  // The joint's normal looks to the segments, away from the jaw: so does the blade's, turned; the
  // jaw's face is half a kerf below the blade's middle.
  EXPECT_EQ(placed.joints[0].normal, glm::dvec3(0, 0, 1));
  EXPECT_EQ(placed.joints[0].point, glm::dvec3(1, 0, 2));
  EXPECT_EQ(placed.joints[1], plan.transplants[0].transplant.joints[1]);
  const double before = LayOutSegments(placed)[0].lengthMm;
  cut.blade.point.z -= 10;
  plan = Apply(plan, ChangeObject<PlanCut>{ cut });
  placed = TransplantOf(plan, plan.transplants[0]);
  EXPECT_EQ(placed.joints[0].point, glm::dvec3(1, 0, -8));
  EXPECT_GT(LayOutSegments(placed)[0].lengthMm, before + 9.9);
  // The fragment takes its face along; the last joint's jaw is on the other side.
  plan = Apply(
    plan, PoseFragments{ { { 3, { { 0, 7, 0 }, glm::angleAxis(M_PI, glm::dvec3(0, 0, 1)) } } } });
  placed = TransplantOf(plan, plan.transplants[0]);
  EXPECT_LT(glm::distance(placed.joints[0].point, glm::dvec3(-1, 7, -8)), 1e-12);
  PlanTransplant other = plan.transplants[0];
  other.first = {};
  other.last = { 6, 0 };
  cut.blade.point.z = 50;
  plan = Apply(plan, ChangeObject<PlanCut>{ cut });
  EXPECT_EQ(TransplantOf(plan, other).joints[1].point.z, 51.0);
}

TEST(Plan, SaysWhatCutsWhat)
{
  const Plan plan = Case();
  EXPECT_EQ(CutsThrough(plan, 3), std::vector<PlanId>{ 6 });
  EXPECT_TRUE(CutsThrough(plan, 5).empty());
  EXPECT_TRUE(IsDivided(plan, 3));
  EXPECT_FALSE(IsDivided(plan, 4));
  EXPECT_EQ(BladesOf(plan, plan.guides[0]), std::vector<Osteotomy>{ plan.cuts[0].blade });
  EXPECT_STREQ(PlanNoun(plan, 6), "cut");
  EXPECT_EQ(PlanNoun(plan, 11), nullptr);
}

TEST(PlanEdits, AreRefusedByKindAndId)
{
  EXPECT_EQ(Refused(AddObject<PlanVolume>{ { 3, "", std::string(64, 'a') } }),
    "volume 3: its id must be new: at least 11, at most 1000000000");
  EXPECT_EQ(Refused(AddObject<PlanCut>{ { 11, "", {}, { 6 } } }),
    "cut 11: fragments[0] is 6, must be the id of a fragment of the plan");
  EXPECT_EQ(Refused(AddObject<PlanGroup>{ { 11, "", { 11 } } }),
    "group 11: fragments[0] is 11, must be the id of a fragment of the plan");
  EXPECT_EQ(Refused(ChangeObject<PlanCut>{ { 7, "", {}, {} } }), "cut 7: the plan has none");
  EXPECT_EQ(Refused(RemoveObject{ 6 }), "cut 6: is named by guide 8; remove or change that first");
  EXPECT_EQ(
    Refused(RemoveObject{ 3 }), "fragment 3: is named by fragment 4; remove or change that first");
  EXPECT_EQ(Refused(RemoveObject{ 11 }), "object 11: the plan has none");
  EXPECT_EQ(
    Refused(RenameObject{ 6, "\n" }), "cut 6: name holds a control character or is not UTF-8");
  EXPECT_EQ(Refused(RenameObject{ 0, "x" }), "object 0: the plan has none");
  EXPECT_EQ(Refused(PoseFragments{ { { 3, {} }, { 5, {} } } }),
    "fragment 5: is locked; unlock it to move it");
  EXPECT_EQ(Refused(PoseFragments{ { { 3, { {}, { 2, 0, 0, 0 } } } } }),
    "fragment 3: scanToPlanned.orientation's length is 2, must be 1 within 1e-6");
  EXPECT_EQ(Refused(PoseFragments{}), "move fragments: no fragment is named");
  EXPECT_EQ(Refused(SetFragmentState{ { 6 } }), "fragment 6: the plan has none");
}

TEST(PlanEdits, DoWhatTheirLabelsSay)
{
  const Plan plan = Case();
  EXPECT_EQ(EditLabel(plan, AddObject<PlanCut>{ { 11, "", {}, {} } }), "Add cut 11");
  EXPECT_EQ(EditLabel(plan, ChangeObject<PlanGuide>{ plan.guides[0] }), "Change guide 8");
  EXPECT_EQ(EditLabel(plan, RemoveObject{ 7 }), "Remove group 7");
  EXPECT_EQ(EditLabel(plan, RenameObject{ 4, "Erika" }), "Rename fragment 4");
  EXPECT_EQ(EditLabel(plan, PoseFragments{ { { 3, {} } } }), "Move fragment 3");
  EXPECT_EQ(EditLabel(plan, SetFragmentState{ { 3, 4 } }), "Resect fragments 3 and 4");
  EXPECT_EQ(EditLabel(plan, SetFragmentState{ { 3, 4, 5 }, FragmentState::Kept }),
    "Keep fragments 3, 4 and 1 other");
  EXPECT_EQ(
    EditLabel(plan, SetFragmentState{ { 3, 4, 5, 9 } }), "Resect fragments 3, 4 and 2 others");
  EXPECT_EQ(EditLabel(plan, SetCaseLabel{ "Erika" }), "Change the case label");

  EXPECT_TRUE(Apply(plan, RemoveObject{ 7 }).groups.empty());
  EXPECT_EQ(Apply(plan, RenameObject{ 6, "right" }).cuts[0].name, "right");
  EXPECT_EQ(Apply(plan, SetFragmentState{ { 3 } }).fragments[0].state, FragmentState::Resected);
  EXPECT_EQ(Apply(plan, SetCaseLabel{ "K-17" }).caseLabel, "K-17");
  PlanCut cut = plan.cuts[0];
  cut.blade.kerfMm = 0.5;
  EXPECT_EQ(Apply(plan, ChangeObject<PlanCut>{ cut }).cuts[0], cut);
}

TEST(PlanEdits, AGroupMovesAsOneAndKeepsItsPoses)
{
  Plan plan = Case();
  const glm::dvec3 z(0, 0, 1);
  plan = Apply(plan, PoseFragments{ { { 4, { { 1, 0, 0 }, glm::angleAxis(0.5, z) } } } });
  const PlanPose motion{ { 0, 10, 0 }, glm::angleAxis(M_PI / 2, z) };
  plan = Apply(plan, MovedGroup(plan, 7, motion));
  EXPECT_EQ(plan.fragments[0].scanToPlanned.position, glm::dvec3(0, 10, 0));
  // (1, 0, 0) turned to (0, 1, 0), then 10 along y; the turns add up.
  EXPECT_NEAR(
    glm::distance(plan.fragments[1].scanToPlanned.position, glm::dvec3(0, 11, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::angle(plan.fragments[1].scanToPlanned.orientation), M_PI / 2 + 0.5, 1e-12);
  const Plan apart = Apply(plan, RemoveObject{ 7 });
  EXPECT_EQ(apart.fragments, plan.fragments);
  EXPECT_THROW(MovedGroup(apart, 7, motion), std::invalid_argument);
}

TEST(PlanEdits, IdsAreNeverUsedAgain)
{
  Plan plan = Case();
  plan = Apply(plan, RemoveObject{ 10 });
  EXPECT_EQ(plan.nextId, 11U);
  EXPECT_THROW(Apply(plan, AddObject<PlanGroup>{ { 10, "", {} } }), std::invalid_argument);
  plan = Apply(plan, AddObject<PlanGroup>{ { 20, "", {} } });
  EXPECT_THROW(Apply(plan, AddObject<PlanGroup>{ { 15, "", {} } }), std::invalid_argument);
  plan = Apply(plan, AddObject<PlanGroup>{ { MaxPlanId, "", {} } });
  ValidatePlan(plan);
  EXPECT_THROW(
    Apply(plan, AddObject<PlanGroup>{ { MaxPlanId + 1, "", {} } }), std::invalid_argument);
}

TEST(PlanEdits, AValidPlanStaysValid)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    RandomEdits random(seed);
    Plan plan;
    for (int n = 0; n < 60; ++n)
    {
      const PlanEdit edit = random.Next(plan, plan.nextId);
      plan = Apply(std::move(plan), edit);
      ASSERT_EQ(Refusal([&] { ValidatePlan(plan); }), "") << seed << ", edit " << n;
      ASSERT_FALSE(EditLabel(plan, edit).empty());
    }
  }
}

} // namespace
