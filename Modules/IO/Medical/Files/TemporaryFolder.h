#pragma once
#include "Files/PendingNames.h"

#include <filesystem>
#include <optional>

namespace hasp
{

/// A hidden folder beside `target`, on its file system, whose name says nothing. Removed at the end
/// with all that is still in it, and by RemovePendingFiles. Throws std::runtime_error.
class TemporaryFolder
{
public:
  explicit TemporaryFolder(const std::filesystem::path& target);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& Name() const { return this->Path; }

private:
  std::filesystem::path Path;
  std::optional<PendingName> Noted;
};

/// Renames a file or folder that is on the disk already to `target`, and brings the name to the
/// disk, too. A file takes the place of a file and gets its rights; a folder takes the place of
/// nothing or of an empty folder. Throws std::runtime_error; the earlier file is then as it was.
void PutInPlace(const std::filesystem::path& from, const std::filesystem::path& target);

/// fsync of one file or folder; what cannot be synced by its kind is none. False: errno says why.
bool SyncToDisk(const std::filesystem::path& name);

} // namespace hasp
