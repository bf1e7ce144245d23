#include "PlanFixture.h"
#include "Planning/PlanEditsFile.h"

#include <gtest/gtest.h>

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
  const std::string text = FormatEdits(edits);
  EXPECT_EQ(ParseEdits(text), edits);
  EXPECT_EQ(FormatEdits(ParseEdits(text)), text);
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
    "edits: format is none that this version of Hasp reads: hasp-edits-1 to 3");
  EXPECT_EQ(refusal(R"({"format":"hasp-edits-2","edits":{}})"), "edits: edits must be a list");
  EXPECT_EQ(refusal(R"({"format":"hasp-edits-2","edits":[{"remove":1},{"add":"Erika"}]})"),
    "plan: edits[1].add is of no kind that a plan holds");
  EXPECT_EQ(
    refusal(R"({"format":"hasp-edits-2","edits":[7]})"), "plan: edits[0] must be an object");
}

} // namespace
