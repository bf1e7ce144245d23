#include "PlanFixture.h"
#include "Planning/PlanLists.h"
#include "Planning/PlanMigration.h"

#include <gtest/gtest.h>

namespace
{
using hasp::Json;

// Two steps as they could be: version 2 calls a cut's "saw" a blade, version 3 has notes.
constexpr hasp::PlanMigration Steps[] = {
  { nullptr,
    [](const std::string& noun, Json& object)
    {
      if (noun == "cut" && object.contains("saw"))
      {
        object["blade"] = object["saw"];
        object.erase("saw");
      }
    },
    nullptr },
  { [](Json& plan) { plan["notes"] = Json::array(); }, nullptr,
    [](Json& part) { part["weight"] = 2; } },
};

std::string File(const std::string& blade, const std::string& notes)
{
  const std::string plan =
    R"({"cuts":[{"id":1,")" + blade + R"(":7}],"guides":[{"saw":1}])" + notes + "}";
  return R"({"plan":)" + plan + R"(,"history":{"start":)" + plan +
         R"(,"steps":[{"edits":[{"add":"cut","object":{")" + blade +
         R"(":8}},{"change":"cut","object":{")" + blade +
         R"(":9}},{"change":"guide","object":{"saw":9}},{"remove":1}]}]}})";
}

std::string Migrated(const std::string& text, std::size_t version)
{
  Json json = Json::parse(text);
  hasp::MigratePlanFile(json, version, Steps);
  return json.dump();
}

TEST(PlanMigration, TakesPlanAndHistoryThroughEachVersion)
{
  const std::string newest = File("blade", ",\"notes\":[]");
  EXPECT_EQ(Migrated(File("saw", ""), 1), newest);
  EXPECT_EQ(Migrated(File("blade", ""), 2), newest);
  EXPECT_EQ(Migrated(newest, 3), newest);
}

TEST(PlanMigration, MendsParts)
{
  Json json = Json::parse(R"({"parts":[{"object":1},{"object":2}]})");
  hasp::MigratePlanFile(json, 1, Steps);
  EXPECT_EQ(json.dump(), R"({"parts":[{"object":1,"weight":2},{"object":2,"weight":2}]})");
}

/// A file that the first version wrote: all of its kinds, a step undone, a made part.
TEST(PlanMigration, AKeptFileOfVersion1IsRead)
{
  const std::string text = ReadBytes(HASP_KEPT_PLAN_1);
  ASSERT_NE(text.find("hasp-plan-1"), std::string::npos);
  hasp::PlanDocument document = hasp::ParsePlan(text);
  const hasp::Plan& plan = document.history.Current();
  EXPECT_EQ(plan.caseLabel, "K-17");
  ASSERT_EQ(plan.fragments.size(), 3U);
  const auto& jaw = std::get<hasp::ComponentSource>(plan.fragments[0].source);
  EXPECT_EQ(jaw.isovalue, 300.5);
  EXPECT_EQ(jaw.spacingMm, 0.5);
  EXPECT_EQ(std::get<hasp::LabelSource>(plan.fragments[1].source).isovalue, 226.0);
  EXPECT_EQ(plan.fragments[2].scanToPlanned.position, glm::dvec3(1, 2, 3));
  ASSERT_EQ(plan.cuts.size(), 1U);
  EXPECT_EQ(plan.cuts[0].blade.kerfMm, 1.25);
  EXPECT_EQ(plan.cuts[0].reachMm, 8.0);
  ASSERT_EQ(plan.guides.size(), 1U);
  EXPECT_EQ(plan.guides[0].side, hasp::BodySide::None);
  EXPECT_TRUE(plan.plates.empty() && plan.implants.empty() && plan.transplants.empty());
  ASSERT_EQ(document.parts.size(), 1U);
  EXPECT_EQ(document.parts[0].report, "");
  EXPECT_EQ(hasp::ParsePlan(hasp::FormatPlan(document)), document);
  document.history.Redo();
  EXPECT_EQ(document.history.Current().cuts[0].blade.kerfMm, 0.75);
  EXPECT_EQ(document.history.Current().cuts[0].reachMm, 8.0);
  for (; document.history.ToUndo(); document.history.Undo())
    hasp::ValidatePlan(document.history.Current());
}

/// A file that the second version wrote: a transplant that was changed and changed back, and two
/// made parts.
TEST(PlanMigration, AKeptFileOfVersion2IsRead)
{
  const std::string text = ReadBytes(HASP_KEPT_PLAN_2);
  ASSERT_NE(text.find("hasp-plan-2"), std::string::npos);
  hasp::PlanDocument document = hasp::ParsePlan(text);
  const hasp::Plan& plan = document.history.Current();
  EXPECT_TRUE(plan.mitreGuides.empty());
  ASSERT_EQ(plan.transplants.size(), 1U);
  EXPECT_EQ(plan.transplants[0].donor, 2U);
  EXPECT_EQ(plan.transplants[0].transplant.kerfMm, 1.0);
  EXPECT_EQ(plan.transplants[0].mostGapMm, 0.5);
  EXPECT_EQ(plan.transplants[0].mostOverlapMm, 0.5);
  ASSERT_EQ(document.parts.size(), 2U);
  EXPECT_EQ(hasp::WhyOutOfDate(plan, document.parts[0]), ""); // a fragment says what it did
  const std::string written = hasp::FormatPlan(document);
  EXPECT_NE(written.find("hasp-plan-5"), std::string::npos);
  EXPECT_EQ(hasp::ParsePlan(written), document);
  document.history.Redo();
  EXPECT_EQ(document.history.Current().transplants[0].transplant.kerfMm, 0.8);
  for (; document.history.ToUndo(); document.history.Undo())
    hasp::ValidatePlan(document.history.Current());
}

/// A file that the third version wrote: a segmentation that was changed and changed back, and a
/// part that was made of one of its labels.
TEST(PlanMigration, AKeptFileOfVersion3IsRead)
{
  const std::string text = ReadBytes(HASP_KEPT_PLAN_3);
  ASSERT_NE(text.find("hasp-plan-3"), std::string::npos);
  hasp::PlanDocument document = hasp::ParsePlan(text);
  const hasp::Plan& plan = document.history.Current();
  EXPECT_EQ(plan.caseLabel, "K-18");
  ASSERT_EQ(plan.segmentations.size(), 1U);
  EXPECT_EQ(plan.segmentations[0].labels, std::string(64, 'b'));
  EXPECT_EQ(plan.segmentations[0].recipe, hasp::SegmentationRecipe{});
  EXPECT_EQ(plan.transplants.at(0).mostGapMm, 0.75);
  EXPECT_EQ(plan.mitreGuides.size(), 1U);
  ASSERT_EQ(document.parts.size(), 1U);
  EXPECT_EQ(document.parts[0].report, std::string(64, 'f'));
  EXPECT_EQ(hasp::WhyOutOfDate(plan, document.parts[0]), ""); // without steps it says what it did
  EXPECT_EQ(hasp::LabelMapOf(plan, document.parts, 2), std::string(64, 'b'));
  const std::string written = hasp::FormatPlan(document);
  EXPECT_NE(written.find("hasp-plan-5"), std::string::npos);
  EXPECT_EQ(hasp::ParsePlan(written), document);
  document.history.Redo();
  EXPECT_EQ(document.history.Current().segmentations[0].labels, std::string(64, 'c'));
  EXPECT_NE(hasp::WhyOutOfDate(document.history.Current(), document.parts[0]), "");
  for (; document.history.ToUndo(); document.history.Undo())
    hasp::ValidatePlan(document.history.Current());
}

/// A file that the fourth version wrote: a segmentation with a step, a group, a pose undone, a
/// part.
TEST(PlanMigration, AKeptFileOfVersion4IsRead)
{
  const std::string text = ReadBytes(HASP_KEPT_PLAN_4);
  ASSERT_NE(text.find("hasp-plan-4"), std::string::npos);
  hasp::PlanDocument document = hasp::ParsePlan(text);
  const hasp::Plan& plan = document.history.Current();
  EXPECT_EQ(plan.caseLabel, "K-19");
  EXPECT_TRUE(plan.surfaces.empty() && plan.mirrors.empty());
  ASSERT_EQ(plan.fragments.size(), 2U);
  EXPECT_TRUE(plan.fragments[0].locked);
  EXPECT_EQ(plan.fragments[1].scanToPlanned.position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(plan.groups.at(0).fragments, (std::vector<hasp::PlanId>{ 3, 4 }));
  ASSERT_EQ(document.parts.size(), 1U);
  EXPECT_EQ(hasp::WhyOutOfDate(plan, document.parts[0]), ""); // a scan's fragment says what it did
  const std::string written = hasp::FormatPlan(document);
  EXPECT_NE(written.find("hasp-plan-5"), std::string::npos);
  EXPECT_EQ(hasp::ParsePlan(written), document);
  document.history.Redo();
  EXPECT_EQ(document.history.Current().fragments[1].scanToPlanned.position, glm::dvec3(4, 5, 6));
  for (; document.history.ToUndo(); document.history.Undo())
    hasp::ValidatePlan(document.history.Current());
}

TEST(PlanMigration, LeavesWhatIsNoPlanToTheStrictReader)
{
  for (const char* text :
    { "[]", "{}", "1", R"({"plan":[],"history":1})",
      R"({"plan":{"cuts":{}},"history":{"start":"","steps":[1,{"edits":[1,{"add":1,"object":2}]}]}})" })
    EXPECT_NO_THROW(Migrated(text, 1)) << text;
}

} // namespace
