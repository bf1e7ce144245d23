#include "Model/RecentPlans.h"

#include "Model/WorkFolder.h"

#include "Planning/DurableFile.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr std::size_t MostBytes = 1 << 20;
} // namespace

RecentPlans::RecentPlans(const fs::path& state, const fs::path& plans)
  : File(state / "recent.json"),
    Plans(plans)
{
}

std::vector<RecentPlans::Entry> RecentPlans::Entries() const
{
  std::vector<Entry> entries;
  try
  {
    for (const Json& one :
      Json::parse(ReadWhole(this->File, MostBytes, "the list of recent plans")))
    {
      Entry entry{ one.at("case"), this->Plans / one.at("plan").get<std::string>() };
      if (!BelowPlans(this->Plans, entry.place).empty() && fs::exists(entry.place / "plan.json"))
        entries.push_back(std::move(entry));
    }
  }
  catch (const std::exception&) // none yet, or not ours
  {
  }
  return entries;
}

void RecentPlans::Add(const std::string& caseLabel, const fs::path& place)
{
  const fs::path below = BelowPlans(this->Plans, place);
  if (below.empty())
    return;
  std::vector<Entry> entries = this->Entries();
  std::erase_if(
    entries, [&](const Entry& one) { return BelowPlans(this->Plans, one.place) == below; });
  entries.insert(entries.begin(), { caseLabel, place });
  entries.resize(std::min(entries.size(), Most));
  Json list = Json::array();
  for (const Entry& one : entries)
    list.push_back(
      { { "case", one.caseLabel }, { "plan", BelowPlans(this->Plans, one.place).string() } });
  try
  {
    WriteDurably(this->File, list.dump(1), "the list of recent plans");
  }
  catch (const std::exception&) // as the header says
  {
  }
}

} // namespace hasp
