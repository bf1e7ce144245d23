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
    } },
  { [](Json& plan) { plan["notes"] = Json::array(); }, nullptr },
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

TEST(PlanMigration, LeavesWhatIsNoPlanToTheStrictReader)
{
  for (const char* text :
    { "[]", "{}", "1", R"({"plan":[],"history":1})",
      R"({"plan":{"cuts":{}},"history":{"start":"","steps":[1,{"edits":[1,{"add":1,"object":2}]}]}})" })
    EXPECT_NO_THROW(Migrated(text, 1)) << text;
}

} // namespace
