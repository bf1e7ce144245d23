#include "Files/PendingNames.h"
#include "vtkHaspOutputFile.h"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>

namespace hasp
{
namespace
{

/// A name where a signal handler can read it, whatever else is going on: memory that is never
/// freed.
struct Slot
{
  std::atomic<bool> taken{ false };
  std::atomic<bool> whole{ false };
  char text[PATH_MAX];
};
std::array<Slot, 16> Slots;
static_assert(std::atomic<bool>::is_always_lock_free);

/// opendir takes memory, which a signal handler must not.
void RemoveTree(int parent, const char* name, int depth) noexcept
{
  if (unlinkat(parent, name, 0) == 0 || depth == 0)
    return;
  const int folder = openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (folder < 0)
    return;
  alignas(dirent64) char entries[2048];
  // An entry that goes may hide another from this pass: again, until there is nothing more to do.
  for (int pass = 0; pass < 64 && unlinkat(parent, name, AT_REMOVEDIR) != 0; ++pass)
  {
    lseek(folder, 0, SEEK_SET);
    for (ssize_t got = 0; (got = getdents64(folder, entries, sizeof entries)) > 0;)
      for (ssize_t at = 0; at < got;)
      {
        const auto* entry = reinterpret_cast<const dirent64*>(entries + at);
        if (std::strcmp(entry->d_name, ".") != 0 && std::strcmp(entry->d_name, "..") != 0)
          RemoveTree(folder, entry->d_name, depth - 1);
        at += entry->d_reclen;
      }
  }
  close(folder);
}

} // namespace

PendingName::PendingName(const std::filesystem::path& name)
{
  const std::string& text = name.native();
  for (std::size_t n = 0; n < Slots.size() && text.size() < PATH_MAX; ++n)
    if (!Slots[n].taken.exchange(true))
    {
      std::memcpy(Slots[n].text, text.c_str(), text.size() + 1);
      Slots[n].whole = true;
      this->Slot = static_cast<int>(n);
      return;
    }
}

void PendingName::Forget() noexcept
{
  if (this->Slot < 0)
    return;
  Slots[this->Slot].whole = false;
  Slots[this->Slot].taken = false;
  this->Slot = -1;
}

void RemoveTree(const char* name) noexcept
{
  RemoveTree(AT_FDCWD, name, 4);
}

void RemovePendingFiles() noexcept
{
  for (const auto& slot : Slots)
    if (slot.whole)
      RemoveTree(slot.text);
}

} // namespace hasp
