#include "Model/WorkFolder.h"

#include "Planning/DurableFile.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

/// A descriptor that holds the folder's lock; -1: somebody else has it, or it is not there.
int TakeLock(const fs::path& folder, int more = 0)
{
  const int lock = open((folder / "lock").c_str(), O_RDWR | O_CLOEXEC | more, 0600);
  if (lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) != 0)
  {
    close(lock);
    return -1;
  }
  return lock;
}

/// The hash that plan.json ends with (PlanFile.h): another one is of another plan.
std::string SealOf(const fs::path& place)
{
  constexpr std::size_t MostPlan = std::size_t{ 64 } << 20, Digits = 64;
  const std::string text = ReadWhole(place / "plan.json", MostPlan, "plan.json");
  const std::size_t end = text.find_last_of("0123456789abcdef") + 1;
  return end < Digits ? std::string(Digits, '-') : text.substr(end - Digits, Digits);
}

[[noreturn]] void Refuse()
{
  throw std::runtime_error(std::string("the planner's own folder cannot be written: ") +
                           std::strerror(errno) + "; make room, or say another one with --state");
}
} // namespace

WorkFolder::WorkFolder(const fs::path& state)
{
  std::error_code error;
  fs::create_directories(state / "work", error);
  if (error)
    throw std::runtime_error("the planner's own folder cannot be made: " + error.message() +
                             "; say another one with --state");
  fs::permissions(state, fs::perms::owner_all, error); // plans are nobody else's business
  std::string name = (state / "work" / "XXXXXX").string();
  if (!mkdtemp(name.data()))
    Refuse();
  this->Folder = name;
  this->Lock = TakeLock(this->Folder, O_CREAT);
  if (this->Lock < 0)
    Refuse();
}

WorkFolder::~WorkFolder()
{
  if (!this->Stays)
  {
    std::error_code ignored; // the next start offers what is left
    fs::remove_all(this->Folder, ignored);
  }
  close(this->Lock);
}

void WorkFolder::SetPlace(const fs::path& plans, const fs::path& place)
{
  std::error_code ignored; // first: another plan's place is worse than none
  fs::remove(this->Folder / "place", ignored);
  try
  {
    if (const std::string below = BelowPlans(plans, place).string(); !below.empty())
      WriteDurably(this->Folder / "place", SealOf(place) + below, "the planner's own folder");
  }
  catch (const std::runtime_error&) // after a crash the user says it again
  {
  }
}

fs::path WorkFolder::PlaceOf(const fs::path& folder, const fs::path& plans)
{
  try
  {
    const std::string text = ReadWhole(folder / "place", 4096, "the planner's own folder");
    const std::string seal = text.substr(0, 64), below = text.substr(seal.size());
    if (!BelowPlans(plans, plans / below).empty() && SealOf(plans / below) == seal)
      return plans / below;
  }
  catch (const std::runtime_error&) // it was never saved, or is gone
  {
  }
  return {};
}

std::vector<fs::path> WorkFolder::Crashed(const fs::path& state)
{
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(state / "work", error))
  {
    const int lock = TakeLock(entry.path());
    if (lock < 0)
      continue;
    close(lock);
    const fs::file_time_type time = fs::last_write_time(JournalIn(entry.path()), error);
    if (!error)
      found.emplace_back(time, entry.path());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<fs::path> folders;
  for (auto& [time, folder] : found)
    folders.push_back(std::move(folder));
  return folders;
}

void WorkFolder::Remove(const fs::path& folder)
{
  const int lock = TakeLock(folder);
  if (lock < 0)
    return;
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  close(lock);
}

fs::path BelowPlans(const fs::path& plans, const fs::path& place)
{
  std::error_code error;
  const fs::path below = fs::relative(place, plans, error);
  if (error || below.empty() || below == "." || *below.begin() == "..")
    return {};
  return below;
}

fs::path JournalIn(const fs::path& work)
{
  return work / "journal";
}

} // namespace hasp
