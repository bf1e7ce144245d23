#pragma once
#include <filesystem>
#include <memory>
#include <vector>

namespace hasp
{

/// The folder that a running planner works in: STATE/work/RANDOM, with the plan's blobs and its
/// journal. It is locked while the program lives, however it ends, and is removed when it ends
/// well; what is there without a lock was left by a crash.
///
/// Threads: RENDER. Throws std::runtime_error where the disk refuses, without a path.
class WorkFolder
{
public:
  explicit WorkFolder(const std::filesystem::path& state);
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  const std::filesystem::path& Path() const { return this->Folder; }
  /// It stays when this goes: what was not saved is offered at the next start.
  void Keep() { this->Stays = true; }

  /// Remembers where the plan is saved, for a start after a crash; only if that lies below the
  /// folder of plans, since elsewhere a folder's name may be a patient's. Any other: forgets it.
  void SetPlace(const std::filesystem::path& plans, const std::filesystem::path& place);
  /// Empty: none was remembered, it is gone, or somebody has saved another plan there since, which
  /// a save after the crash must not replace.
  static std::filesystem::path PlaceOf(
    const std::filesystem::path& folder, const std::filesystem::path& plans);

  /// Those that crashes left, with a journal, newest first.
  static std::vector<std::filesystem::path> Crashed(const std::filesystem::path& state);
  /// Removes one of them. Nothing if it is in use.
  static void Remove(const std::filesystem::path& folder);

private:
  std::filesystem::path Folder;
  int Lock = -1; ///< descriptor of the folder's lock file
  bool Stays = false;
};

/// The place as it stands below the folder of plans; empty: it is elsewhere.
std::filesystem::path BelowPlans(
  const std::filesystem::path& plans, const std::filesystem::path& place);

/// The journal in such a folder.
std::filesystem::path JournalIn(const std::filesystem::path& work);

} // namespace hasp
