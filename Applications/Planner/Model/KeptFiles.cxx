#include "Model/KeptFiles.h"

#include <algorithm>
#include <map>
#include <system_error>
#include <vector>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

/// Files of one name.
struct KeptFiles
{
  fs::file_time_type time = fs::file_time_type::min();
  std::uintmax_t bytes = 0;
  std::vector<fs::path> paths;
};

/// Oldest first.
std::vector<KeptFiles> FilesOf(const fs::path& folder)
{
  std::map<fs::path, KeptFiles> byName;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
  {
    std::error_code gone; // meanwhile, by another planner
    const auto time = entry.last_write_time(gone);
    const auto bytes = gone ? 0 : entry.file_size(gone);
    if (gone)
      continue;
    KeptFiles& files = byName[entry.path().stem()];
    files.time = std::max(files.time, time);
    files.bytes += bytes;
    files.paths.push_back(entry.path());
  }
  std::vector<KeptFiles> all;
  for (auto& [name, files] : byName)
    all.push_back(std::move(files));
  std::stable_sort(
    all.begin(), all.end(), [](const KeptFiles& a, const KeptFiles& b) { return a.time < b.time; });
  return all;
}
} // namespace

void DropOldestFiles(const fs::path& folder, std::uintmax_t mostBytes)
{
  const std::vector<KeptFiles> all = FilesOf(folder);
  std::uintmax_t sum = 0;
  for (const KeptFiles& files : all)
    sum += files.bytes;
  for (std::size_t n = 0; sum > mostBytes && n + 1 < all.size(); ++n)
  {
    std::error_code error;
    for (const fs::path& path : all[n].paths)
      fs::remove(path, error);
    sum -= all[n].bytes;
  }
}

} // namespace hasp
