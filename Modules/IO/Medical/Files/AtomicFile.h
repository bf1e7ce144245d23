#pragma once
#include "Files/PendingNames.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>

namespace hasp
{

/// A file that appears whole or not at all: written under a temporary name in the same folder,
/// flushed to the disk, then renamed over the old one. Without Commit the old file is untouched and
/// the temporary one is removed. All errors throw std::runtime_error with the file's label and the
/// system's reason.
class AtomicFile
{
public:
  /// `ending`: of the temporary name, for readers that go by it; one of ours and never the file's.
  explicit AtomicFile(const std::filesystem::path& file, std::string_view ending = ".tmp");
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void Write(const void* bytes, std::size_t size);
  /// For a library that writes to a name: it may truncate and write this one.
  const std::filesystem::path& TemporaryName() const { return this->Temporary; }
  /// fsync, rename, fsync of the folder.
  void Commit();

private:
  [[noreturn]] void Throw(const char* what) const;

  std::filesystem::path Target, Temporary;
  int Descriptor = -1;
  std::optional<PendingName> Noted; ///< for RemovePendingFiles
};

} // namespace hasp
