#include "PlanFixture.h"
#include "Planning/PlanEditsFile.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace hasp;

TEST(PlanEditsFile, EditsOfAllKindsSurviveTheRoundTrip)
{
  RandomEdits random(5);
  std::vector<PlanEdit> edits;
  Plan plan;
  for (int n = 0; n < 300; ++n)
  {
    edits.push_back(random.Next(plan, plan.nextId));
    plan = Apply(std::move(plan), edits.back());
  }
  EXPECT_FALSE(plan.plates.empty() || plan.implants.empty() || plan.transplants.empty());
  const auto has = [&]<typename T>(T)
  {
    return std::any_of(edits.begin(), edits.end(),
      [](const PlanEdit& edit) { return std::holds_alternative<T>(edit); });
  };
  EXPECT_TRUE(has(AddSegmentationStep{}) && has(AddSegmentationStroke{}));
  const std::string text = FormatEdits(edits);
  EXPECT_EQ(ParseEdits(text), edits);
  EXPECT_EQ(FormatEdits(ParseEdits(text)), text);
}

TEST(PlanEditsFile, StepsAndStrokesAreWrittenByHand)
{
  const std::string begin = R"({"format":"hasp-edits-5","edits":[)";
  const std::vector<PlanEdit> edits = ParseEdits(
    begin +
    R"({"addStep":2,"step":{"step":"split","label":1,"beta":90,"crack":0.1,"norm":1,"strokes":[]}},
       {"addStroke":2,"stroke":{"label":3,"radiusMm":1.5,"points":[[1,2,3]]}}]})");
  ASSERT_EQ(edits.size(), 2U);
  EXPECT_EQ(edits[0], PlanEdit(AddSegmentationStep{ 2, SplitStep{} }));
  EXPECT_EQ(edits[1], PlanEdit(AddSegmentationStroke{ 2, { 3, 1.5, { { 1, 2, 3 } } } }));
  const auto refusal = [&](const std::string& edit)
  { return Thrown([&] { ParseEdits(begin + edit + "]}"); }); };
  EXPECT_EQ(refusal(R"({"addStep":2,"step":{"step":"Erika"}})")
              .find("plan: edits[0].step.step must be gaussian, median,"),
    0U);
  EXPECT_EQ(refusal(R"({"addStroke":2,"stroke":{"label":3,"radiusMm":1.5,"points":[[1,2]]}})"),
    "plan: edits[0].stroke.points[0] must be three numbers");
  EXPECT_EQ(refusal(R"({"addStroke":0,"stroke":{}})"),
    "plan: edits[0].addStroke must be a whole number in [1, 1000000000]");
}

TEST(PlanEditsFile, OlderOnesAreRead)
{
  const std::vector<PlanEdit> edits = ParseEdits(
    R"({"format":"hasp-edits-1","edits":[{"add":"cut","object":{"id":1,"name":"","blade":{
      "point":[0,0,0],"normal":[0,0,1],"along":[1,0,0],"widthMm":9,"depthMm":9,"kerfMm":1},
      "fragments":[]}}]})");
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(std::get<AddObject<PlanCut>>(edits[0]).object.reachMm, 8.0);
}

TEST(PlanEditsFile, ErrorsNameTheKeyAndNothingElse)
{
  const auto refusal = [](const std::string& text) { return Thrown([&] { ParseEdits(text); }); };
  EXPECT_EQ(refusal("[Erika"), "edits: no JSON: a mistake at byte 2");
  EXPECT_EQ(refusal("[]"), "edits: the whole must be an object");
  EXPECT_EQ(refusal(R"({"format":"Erika","edits":[]})"),
    "edits: format is none that this version of Hasp reads: hasp-edits-1 to 5");
  EXPECT_EQ(refusal(R"({"format":"hasp-edits-2","edits":{}})"), "edits: edits must be a list");
  EXPECT_EQ(refusal(R"({"format":"hasp-edits-2","edits":[{"remove":1},{"add":"Erika"}]})"),
    "plan: edits[1].add is of no kind that a plan holds");
  EXPECT_EQ(
    refusal(R"({"format":"hasp-edits-2","edits":[7]})"), "plan: edits[0] must be an object");
}

} // namespace
