#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace hasp
{

/// The plans that were saved last, by their case labels. A plan's place is remembered only if it
/// lies in the planner's own folder of plans: elsewhere a folder's name may be a patient's.
///
/// In STATE/recent.json, replaced whole or not at all. A list that cannot be read is an empty one,
/// one that cannot be written stays as it was: nobody's work depends on it. Threads: RENDER.
class RecentPlans
{
public:
  struct Entry
  {
    std::string caseLabel;       ///< as it was saved; may be empty
    std::filesystem::path place; ///< in the folder of plans; not shown
  };
  static constexpr std::size_t Most = 10;

  /// `plans`: the folder of plans.
  RecentPlans(const std::filesystem::path& state, const std::filesystem::path& plans);

  std::vector<Entry> Entries() const; ///< newest first; only those that are still there
  void Add(const std::string& caseLabel, const std::filesystem::path& place);

private:
  std::filesystem::path File, Plans;
};

} // namespace hasp
