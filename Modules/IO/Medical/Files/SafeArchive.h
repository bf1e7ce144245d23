#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

struct archive;

namespace hasp
{

/// The entry a walk stands on.
class ArchiveEntry
{
public:
  ArchiveEntry(archive* from, std::filesystem::path file, std::string name, std::size_t size)
    : From(from),
      File(std::move(file)),
      Named(std::move(name)),
      Bytes(size)
  {
  }
  const std::string& Name() const { return this->Named; } ///< without the archive's one top folder
  std::size_t Size() const { return this->Bytes; }        ///< as declared
  /// The next `size` bytes. Throws std::runtime_error if the archive ends or breaks before.
  void Read(void* into, std::size_t size) const;

private:
  archive* From;
  std::filesystem::path File;
  std::string Named;
  std::size_t Bytes;
};

/// Calls visit for each regular file of a tar or gzipped tar, until it returns false. Nothing is
/// ever extracted to disk. Throws std::runtime_error, with the archive's label, on an entry
/// that is a link or device, has an absolute path, "..", a second top folder or a name seen before;
/// on more than 4096 entries or more declared bytes than the limit plus 512 MiB; and on damage.
void WalkArchive(const std::filesystem::path& file, std::size_t limitBytes,
  const std::function<bool(const ArchiveEntry&)>& visit);

} // namespace hasp
