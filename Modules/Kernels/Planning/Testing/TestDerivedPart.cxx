#include "Planning/DerivedPart.h"
#include "Planning/PlanEdits.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace
{
using namespace hasp;

/// volume 1, segmentation 2, fragment 3, its pieces 4 and 5, cut 6 through 3, guide 7 on 3 for cut
/// 6, group 8 of both pieces, and what none of them hangs on: volume 9, cut 10. Plate 11 on both
/// pieces, plate 12 and implant 13 on volume 1, transplant 14 out of 3, at cut 10's face of 5, and
/// its mitre guide 15.
Plan Case()
{
  Plan plan;
  const auto add = [&]<typename T>(T object)
  {
    object.id = plan.nextId;
    plan = Apply(plan, AddObject<T>{ object });
  };
  add(PlanVolume{ 0, "", std::string(64, 'a') });
  add(PlanSegmentation{ 0, "", 1, std::string(64, 'b') });
  PlanFragment fragment;
  fragment.source = LabelSource{ 2, 1 };
  add(fragment);
  fragment.source = PieceSource{ 3, { -10, 0, 0 } };
  add(fragment);
  fragment.source = PieceSource{ 3, { 10, 0, 0 } };
  add(fragment);
  add(PlanCut{ 0, "", {}, { 3 } });
  PlanGuide guide;
  guide.bone = 3;
  guide.recipe.landmarks = { { 0, 0, 0 }, { 10, 0, 0 } };
  guide.cuts = { 6 };
  add(guide);
  add(PlanGroup{ 0, "", { 4, 5 } });
  add(PlanVolume{ 0, "", std::string(64, 'c') });
  add(PlanCut{ 0, "", {}, {} });
  PlanPlate plate;
  plate.fragments = { 4, 5 };
  plate.recipe.landmarks = { { 0, 0, 0 }, { 10, 0, 0 } };
  add(plate);
  plate.fragments.clear();
  plate.volume = 1;
  add(plate);
  PlanImplant implant;
  implant.volume = 1;
  implant.recipe.outline = { { 0, 0, 0 }, { 10, 0, 0 }, { 0, 10, 0 } };
  add(implant);
  PlanTransplant transplant;
  transplant.donor = 3;
  transplant.first = { 10, 5 };
  const glm::dvec3 line[] = { { 0, 0, 2 }, { 0, 0, 32 } };
  transplant.transplant.joints = MitreJoints(line);
  transplant.transplant.outward = { { 1, 0, 0 } };
  transplant.transplant.donor.axis = { { 0, 0, 0 }, { 0, 0, 350 } };
  add(transplant);
  add(PlanMitreGuide{ 0, "", 14, {} });
  return plan;
}

/// Why the mesh of `object`, made before the edit, is out of date after it.
std::string Why(PlanId object, const PlanEdit& edit)
{
  const Plan before = Case();
  const DerivedPart part{ object, PartFormat::Stl, PartInputs(before, object), "", "" };
  EXPECT_EQ(WhyOutOfDate(before, part), "");
  return WhyOutOfDate(Apply(before, edit), part);
}

ChangeObject<PlanCut> Cut(PlanId id, double kerfMm, std::vector<PlanId> fragments)
{
  PlanCut cut{ id, "", {}, std::move(fragments) };
  cut.blade.kerfMm = kerfMm;
  return { cut };
}

TEST(DerivedPart, IsOutOfDateWhenWhatItIsMadeFromChanges)
{
  const std::string guide = "guide 7 is out of date: ", piece = "fragment 4 is out of date: ",
                    group = "group 8 is out of date: ";
  EXPECT_EQ(Why(7, Cut(6, 0.5, { 3 })), guide + "cut 6 has changed");
  EXPECT_EQ(Why(4, Cut(6, 0.5, { 3 })), piece + "cut 6 has changed");
  EXPECT_EQ(Why(8, Cut(6, 0.5, { 3 })), group + "cut 6 has changed");
  EXPECT_EQ(Why(4, Cut(6, 1.0, {})), piece + "it is not made from cut 6 any more");
  EXPECT_EQ(Why(4, Cut(10, 1.0, { 3 })), piece + "it is now made from cut 10, too");
  EXPECT_EQ(Why(7, ChangeObject<PlanSegmentation>{ { 2, "", 1, std::string(64, 'd') } }),
    guide + "segmentation 2 has changed");
  EXPECT_EQ(Why(3, ChangeObject<PlanVolume>{ { 1, "", std::string(64, 'd') } }),
    "fragment 3 is out of date: volume 1 has changed");
  EXPECT_EQ(
    Why(7, RemoveObject{ 7 }), "object 7 is out of date: the plan has no such object any more");
  const PoseFragments move{ { { 5, { { 0, 0, 1 }, { 1, 0, 0, 0 } } } } };
  EXPECT_EQ(Why(8, move), group + "fragment 5 has been moved, resected or kept");
  EXPECT_EQ(
    Why(8, SetFragmentState{ { 4 } }), group + "fragment 4 has been moved, resected or kept");
  EXPECT_EQ(Why(8, ChangeObject<PlanGroup>{ { 8, "", { 5 } } }),
    group + "it is not made from fragment 4 any more");
}

TEST(DerivedPart, IsInDateAfterWhatItDoesNotHangOn)
{
  const PoseFragments move{ { { 3, { { 0, 0, 1 }, { 1, 0, 0, 0 } } } } };
  for (const PlanId object : { 3U, 4U, 7U, 8U })
  {
    EXPECT_EQ(Why(object, move), ""); // made where the bone lies in the scan; 3 is in no group
    EXPECT_EQ(Why(object, RenameObject{ object, "x" }), "");
    EXPECT_EQ(Why(object, RenameObject{ 6, "x" }), "");
    EXPECT_EQ(Why(object, SetFragmentState{ { 3 } }), "");
    EXPECT_EQ(Why(object, SetCaseLabel{ "x" }), "");
    EXPECT_EQ(Why(object, Cut(10, 2.0, {})), "");
    EXPECT_EQ(Why(object, ChangeObject<PlanVolume>{ { 9, "", std::string(64, 'e') } }), "");
    EXPECT_EQ(Why(object, RemoveObject{ 9 }), "");
  }
}

TEST(DerivedPart, AGuideThatNamesTheCaseHangsOnItsLabel)
{
  Plan named = Case();
  PlanGuide guide = named.guides[0];
  guide.recipe.labels.emplace_back().kind = GuideLabelKind::Case;
  named = Apply(named, ChangeObject<PlanGuide>{ guide });
  const std::vector<PartInput> inputs = PartInputs(named, 7);
  EXPECT_EQ(inputs[0].id, 0U);
  EXPECT_EQ(inputs[0].facet, PartFacet::CaseLabel);
  const DerivedPart part{ 7, PartFormat::Stl, inputs, "", "" };
  const std::string why = "guide 7 is out of date: ";
  const Plan renamed = Apply(named, SetCaseLabel{ "K-17" });
  EXPECT_EQ(WhyOutOfDate(renamed, part), why + "the case label has changed");
  EXPECT_EQ(WhyOutOfDate(Apply(renamed, SetCaseLabel{ "" }), part), "");
  EXPECT_EQ(WhyOutOfDate(Apply(named, RenameObject{ 6, "x" }), part), ""); // though the hash is new
  EXPECT_EQ(WhyOutOfDate(Case(), part), why + "it is not made from the case label any more");
  EXPECT_EQ(Why(7, ChangeObject<PlanGuide>{ guide }), why + "guide 7 has changed");
  guide.side = BodySide::Left;
  EXPECT_EQ(WhyOutOfDate(Apply(named, ChangeObject<PlanGuide>{ guide }), part),
    why + "guide 7 has changed");
  // Said even if nothing else had changed.
  DerivedPart nameless = part;
  nameless.inputs.erase(nameless.inputs.begin());
  EXPECT_EQ(WhyOutOfDate(named, nameless), why + "it is now made from the case label, too");
}

TEST(DerivedPart, FragmentsHangOnTheRecipeOfTheirLabels)
{
  Plan plan = Case();
  const auto why = [&](const PlanEdit& edit, PlanId object)
  {
    const DerivedPart part{ object, PartFormat::Stl, PartInputs(plan, object), "", "" };
    return WhyOutOfDate(Apply(plan, edit), part);
  };
  const std::string changed = " is out of date: segmentation 2 has changed";
  const AddSegmentationStep threshold{ 2, ThresholdStep{} }, split{ 2, SplitStep{} };
  EXPECT_EQ(why(threshold, 3), "fragment 3" + changed);
  plan = Apply(Apply(plan, threshold), split);
  const AddSegmentationStroke stroke{ 2, { 2, 1.5, { { 1, 2, 3 } } } };
  for (const PlanId object : { 3U, 4U })
    EXPECT_EQ(why(stroke, object), "fragment " + std::to_string(object) + changed);
  EXPECT_EQ(why(stroke, 7), "guide 7" + changed);
  EXPECT_EQ(why(stroke, 12), ""); // on the scan
  // What labels are called and how they are drawn is no shape.
  PlanSegmentation named = plan.segmentations[0];
  named.recipe.names = { { 1, "ramus", { 1, 2, 3 } } };
  EXPECT_EQ(why(ChangeObject<PlanSegmentation>{ named }, 3), "");
}

TEST(DerivedPart, ALabelMapIsMadeOfARecipeAndFoundAfterAnUndo)
{
  Plan plan = Case();
  std::vector<DerivedPart> parts;
  const auto refusal = [&](PlanId id)
  {
    try
    {
      LabelMapOf(plan, parts, id);
      return std::string();
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(LabelMapOf(plan, parts, 2), std::string(64, 'b')); // no steps: from elsewhere
  EXPECT_EQ(refusal(1), "volume 1: it is no segmentation, and has no label map");
  EXPECT_EQ(refusal(99), "object 99: it is no segmentation, and has no label map");
  EXPECT_THROW(LabelInputs(plan, 1), std::invalid_argument);
  plan = Apply(plan, ChangeObject<PlanSegmentation>{ { 2, "", 1, "", {} } });
  EXPECT_EQ(refusal(2), "segmentation 2: it has neither labels nor steps yet");
  plan = Apply(Case(), AddSegmentationStep{ 2, ThresholdStep{} });
  EXPECT_EQ(refusal(2),
    "segmentation 2: its label map must be made first: segmentation 2 has not been made");
  const auto made = [&](char bytes) {
    return DerivedPart{ 2, PartFormat::Nrrd, LabelInputs(plan, 2), std::string(64, bytes), "" };
  };
  KeepPart(parts, made('x'));
  EXPECT_EQ(LabelMapOf(plan, parts, 2), std::string(64, 'x'));
  const Plan before = plan;
  plan = Apply(plan, AddSegmentationStep{ 2, FillStep{} });
  EXPECT_EQ(refusal(2), "segmentation 2: its label map must be made first: segmentation 2 is out "
                        "of date: segmentation 2 has changed");
  KeepPart(parts, made('y'));
  EXPECT_EQ(LabelMapOf(plan, parts, 2), std::string(64, 'y'));
  EXPECT_EQ(LabelMapOf(before, parts, 2), std::string(64, 'x'));
  // It is made of the map that it begins with and of the scan, too, and not of names.
  PlanSegmentation other = plan.segmentations[0];
  other.recipe.names = { { 1, "ramus", { 1, 2, 3 } } };
  plan = Apply(plan, ChangeObject<PlanSegmentation>{ other });
  EXPECT_EQ(LabelMapOf(plan, parts, 2), std::string(64, 'y'));
  other.labels.clear();
  plan = Apply(plan, ChangeObject<PlanSegmentation>{ other });
  EXPECT_NE(refusal(2), "");
  plan = Apply(before, ChangeObject<PlanVolume>{ { 1, "", std::string(64, 'd') } });
  EXPECT_EQ(refusal(2), "segmentation 2: its label map must be made first: segmentation 2 is out "
                        "of date: volume 1 has changed");
  EXPECT_FALSE(IsPartObject(plan, 2)); // no mesh is made of it
}

TEST(DerivedPart, PlatesHangOnShapesAndPlaces)
{
  const std::string posed = "plate 11 is out of date: ", scanned = "plate 12 is out of date: ";
  const PoseFragments move{ { { 5, { { 0, 0, 1 }, { 1, 0, 0, 0 } } } } };
  EXPECT_EQ(Why(11, move), posed + "fragment 5 has been moved, resected or kept");
  EXPECT_EQ(
    Why(11, SetFragmentState{ { 4 } }), posed + "fragment 4 has been moved, resected or kept");
  EXPECT_EQ(Why(11, Cut(6, 0.5, { 3 })), posed + "cut 6 has changed");
  PlanPlate plate = Case().plates[0];
  plate.recipe.widthMm = 6;
  EXPECT_EQ(Why(11, ChangeObject<PlanPlate>{ plate }), posed + "plate 11 has changed");
  const ChangeObject<PlanVolume> scan{ { 1, "", std::string(64, 'd') } };
  EXPECT_EQ(Why(12, scan), scanned + "volume 1 has changed");
  for (const PlanEdit& edit : { PlanEdit(move), PlanEdit(Cut(6, 0.5, { 3 })) })
    EXPECT_EQ(Why(12, edit), "");
}

TEST(DerivedPart, ImplantsHangOnTheScan)
{
  const ChangeObject<PlanVolume> scan{ { 1, "", std::string(64, 'd') } };
  EXPECT_EQ(Why(13, scan), "implant 13 is out of date: volume 1 has changed");
  EXPECT_EQ(Why(13, Cut(6, 0.5, { 3 })), "");
}

TEST(DerivedPart, TransplantsHangOnTheirFacesAndTheDonor)
{
  const std::string why = "transplant 14 is out of date: ";
  const PoseFragments move{ { { 5, { { 0, 0, 1 }, { 1, 0, 0, 0 } } } } };
  EXPECT_EQ(Why(14, move), why + "fragment 5 has been moved, resected or kept");
  EXPECT_EQ(Why(14, Cut(10, 2.0, {})), why + "cut 10 has changed");
  EXPECT_EQ(Why(14, ChangeObject<PlanSegmentation>{ { 2, "", 1, std::string(64, 'd') } }),
    why + "segmentation 2 has changed");
  EXPECT_EQ(Why(14, Cut(6, 0.5, { 3 })), why + "cut 6 has changed"); // which 5 is a piece by
  const PoseFragments donor{ { { 3, { { 0, 0, 1 }, { 1, 0, 0, 0 } } } } };
  EXPECT_EQ(Why(14, donor), ""); // taken where it lies in its scan
}

TEST(DerivedPart, MitreGuidesHangOnWhereTheDonorIsCut)
{
  const std::string why = "mitre-guide 15 is out of date: ";
  const PoseFragments move{ { { 5, { { 0, 0, 1 }, { 1, 0, 0, 0 } } } } };
  EXPECT_EQ(Why(15, move), why + "fragment 5 has been moved, resected or kept");
  EXPECT_EQ(Why(15, Cut(10, 2.0, {})), why + "cut 10 has changed");
  EXPECT_EQ(Why(15, ChangeObject<PlanSegmentation>{ { 2, "", 1, std::string(64, 'd') } }),
    why + "segmentation 2 has changed");
  PlanTransplant transplant = Case().transplants[0];
  transplant.transplant.startOffsetMm = 5;
  EXPECT_EQ(Why(15, ChangeObject<PlanTransplant>{ transplant }), why + "transplant 14 has changed");
  transplant = Case().transplants[0];
  transplant.mostGapMm = 1.0; // of its joints, that the donor's saw does not know
  EXPECT_EQ(Why(15, ChangeObject<PlanTransplant>{ transplant }), "");
  EXPECT_EQ(Why(14, ChangeObject<PlanTransplant>{ transplant }),
    "transplant 14 is out of date: transplant 14 has changed");
  PlanMitreGuide guide = Case().mitreGuides[0];
  guide.choices.widthMm = 10;
  EXPECT_EQ(Why(15, ChangeObject<PlanMitreGuide>{ guide }), why + "mitre-guide 15 has changed");
  EXPECT_EQ(Why(15, Cut(6, 0.5, { 3 })), ""); // the jaw's shape, not its place
  EXPECT_EQ(Why(14, ChangeObject<PlanMitreGuide>{ guide }), "");
}

TEST(DerivedPart, AllObjectsButCutFragmentsAreToBeMade)
{
  const Plan plan = Case();
  EXPECT_EQ(PartObjects(plan), (std::vector<PlanId>{ 4, 5, 8, 7, 11, 12, 13, 14, 15 }));
  for (const PlanId object : { 1U, 2U, 6U, 10U, 16U })
    EXPECT_FALSE(IsPartObject(plan, object)) << object;
  for (const PlanId object : { 3U, 8U, 7U, 11U, 13U, 14U, 15U })
    EXPECT_TRUE(IsPartObject(plan, object)) << object;
}

TEST(DerivedPart, WhatWasMadeBeforeAChangeIsFoundWhenItIsUndone)
{
  const Plan before = Case(), after = Apply(before, Cut(6, 0.5, { 3 }));
  const auto made = [](const Plan& plan, char bytes) {
    return DerivedPart{ 7, PartFormat::Stl, PartInputs(plan, 7), std::string(64, bytes), "" };
  };
  std::vector<DerivedPart> parts;
  EXPECT_EQ(WhyNoPart(before, parts, 7), "guide 7 has not been made");
  KeepPart(parts, made(before, 'a'));
  EXPECT_EQ(WhyNoPart(before, parts, 7), "");
  EXPECT_EQ(WhyNoPart(after, parts, 7), "guide 7 is out of date: cut 6 has changed");
  EXPECT_EQ(PartInDate(after, parts, 7), nullptr);
  KeepPart(parts, made(after, 'b'));
  EXPECT_EQ(PartInDate(after, parts, 7)->bytes[0], 'b');
  EXPECT_EQ(PartInDate(before, parts, 7)->bytes[0], 'a');
  KeepPart(parts, made(after, 'c')); // made anew
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(PartInDate(after, parts, 7)->bytes[0], 'c');
  for (const double kerf : { 2.0, 3.0, 4.0, 5.0 })
    KeepPart(parts, made(Apply(before, Cut(6, kerf, { 3 })), 'd'));
  EXPECT_EQ(parts.size(), MaxPartsOfObject);
  EXPECT_EQ(PartInDate(before, parts, 7), nullptr);
}

TEST(DerivedPart, APartOfAnotherFormatIsAnother)
{
  const Plan plan = Case();
  const auto made = [&](PartFormat format, char bytes) {
    return DerivedPart{ 7, format, PartInputs(plan, 7), std::string(64, bytes), "" };
  };
  std::vector<DerivedPart> parts;
  KeepPart(parts, made(PartFormat::ThreeMf, 'a'));
  EXPECT_EQ(PartInDate(plan, parts, 7), nullptr);
  EXPECT_EQ(WhyNoPart(plan, parts, 7), "guide 7 has not been made");
  EXPECT_EQ(WhyNoPart(plan, parts, 7, PartFormat::ThreeMf), "");
  KeepPart(parts, made(PartFormat::Stl, 'b'));
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(PartInDate(plan, parts, 7)->bytes[0], 'b');
  EXPECT_EQ(PartInDate(plan, parts, 7, PartFormat::ThreeMf)->bytes[0], 'a');
  // What is kept of one format takes no place of another's.
  for (const double kerf : { 2.0, 3.0, 4.0, 5.0 })
    KeepPart(
      parts, { 7, PartFormat::Ply, PartInputs(Apply(plan, Cut(6, kerf, { 3 })), 7), "", "" });
  EXPECT_NE(PartInDate(plan, parts, 7), nullptr);
}

TEST(DerivedPart, AnUndoneChangeIsNone)
{
  const Plan before = Case();
  const DerivedPart part{ 7, PartFormat::Stl, PartInputs(before, 7), "", "" };
  const Plan after = Apply(before, Cut(6, 0.5, { 3 }));
  EXPECT_NE(WhyOutOfDate(after, part), "");
  EXPECT_EQ(WhyOutOfDate(Apply(after, Cut(6, 1.0, { 3 })), part), "");
}

TEST(DerivedPart, InputsAreAllThatAShapeComesFrom)
{
  std::vector<PlanId> ids;
  for (const PartInput& input : PartInputs(Case(), 8))
    ids.push_back(input.id);
  EXPECT_EQ(ids, (std::vector<PlanId>{ 1, 2, 3, 4, 4, 5, 5, 6, 8 })); // pieces: shape and place
  EXPECT_THROW(PartInputs(Case(), 6), std::invalid_argument);         // a cut is no part
  EXPECT_THROW(PartInputs(Case(), 16), std::invalid_argument);
}

} // namespace
