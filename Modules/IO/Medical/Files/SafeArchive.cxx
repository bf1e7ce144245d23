#include "Files/SafeArchive.h"
#include "Volumes/VolumeFormat.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <cstring>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>

namespace hasp
{
namespace
{

/// While it lives, this thread's names are UTF-8. libarchive turns the names of a pax archive into
/// the thread's encoding, and in the "C" locale gives up on any that is not ASCII.
class UTF8Names
{
public:
  UTF8Names() : Names(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr))
  {
    if (this->Names)
      this->Before = uselocale(this->Names);
  }
  ~UTF8Names()
  {
    if (!this->Names)
      return;
    uselocale(this->Before);
    freelocale(this->Names);
  }
  UTF8Names(const UTF8Names&) = delete;
  void operator=(const UTF8Names&) = delete;

private:
  locale_t Names, Before{};
};

constexpr std::size_t EntryLimit = 4096;
constexpr std::size_t BesideSamples = std::size_t(512) << 20; // masks and surfaces of a project

/// In our words: libarchive's name the file.
std::string Reason(archive* from)
{
  const int number = archive_errno(from);
  return number > 0 && number != EILSEQ ? strerror(number) : "broken format";
}

[[noreturn]] void ThrowDamaged(const std::filesystem::path& file, archive* from)
{
  ThrowFileError(file, "the archive is damaged or cut off (" + Reason(from) + "); copy it again");
}

/// The name below the one top folder. Refuses what could reach outside of it.
std::string NameInside(
  const std::filesystem::path& file, const char* stored, std::string& topFolder)
{
  const std::filesystem::path path = stored ? stored : "";
  if (path.empty() || path.is_absolute())
    ThrowFileError(file, "the archive holds an absolute path or none; it is not to be trusted");
  std::filesystem::path inside;
  std::string top;
  for (const auto& part : path)
  {
    if (part == "..")
      ThrowFileError(file, "the archive holds a path with \"..\"; it is not to be trusted");
    if (part == "." || part.empty())
      continue;
    if (top.empty())
      top = part.string();
    else
      inside /= part;
  }
  if (!topFolder.empty() && top != topFolder && !top.empty())
    ThrowFileError(file, "the archive holds more than one top folder; a project has one");
  if (topFolder.empty())
    topFolder = top;
  return inside.generic_string();
}

} // namespace

void ArchiveEntry::Read(void* into, std::size_t size) const
{
  auto* bytes = static_cast<char*>(into);
  while (size > 0)
  {
    const la_ssize_t got = archive_read_data(this->From, bytes, size);
    if (got <= 0)
      ThrowDamaged(this->File, this->From);
    bytes += got;
    size -= static_cast<std::size_t>(got);
  }
}

void WalkArchive(const std::filesystem::path& file, std::size_t limitBytes,
  const std::function<bool(const ArchiveEntry&)>& visit)
{
  const UTF8Names names;
  const std::unique_ptr<archive, int (*)(archive*)> from(archive_read_new(), &archive_read_free);
  if (!from)
    throw std::bad_alloc();
  archive_read_support_filter_gzip(from.get());
  archive_read_support_format_tar(from.get());
  if (archive_read_open_filename(from.get(), file.c_str(), 1 << 17) != ARCHIVE_OK)
    ThrowFileError(file, "is no gzipped tar archive (" + Reason(from.get()) + ")");
  std::set<std::string> seen;
  std::string topFolder;
  std::size_t declared = 0;
  const std::size_t most =
    limitBytes + std::min(BesideSamples, std::numeric_limits<std::size_t>::max() - limitBytes);
  for (;;)
  {
    archive_entry* header = nullptr;
    const int result = archive_read_next_header(from.get(), &header);
    if (result == ARCHIVE_EOF)
      return;
    if (result != ARCHIVE_OK)
      ThrowDamaged(file, from.get());
    const auto type = archive_entry_filetype(header);
    if (archive_entry_hardlink(header) || (type != AE_IFREG && type != AE_IFDIR))
      ThrowFileError(file, "the archive holds a link or device; it is not to be trusted");
    const std::string name = NameInside(file, archive_entry_pathname(header), topFolder);
    if (!seen.insert(name).second)
      ThrowFileError(file, "the archive holds two entries of one name; it is not to be trusted");
    const std::int64_t size = archive_entry_size(header);
    if (size < 0 || std::uint64_t(size) > most - declared)
      ThrowFileError(file, "the archive declares more than the memory limit of " +
                             Text(double(limitBytes) / (1 << 20)) +
                             " MiB; if it is to be trusted, raise the limit");
    declared += static_cast<std::size_t>(size);
    if (seen.size() > EntryLimit)
      ThrowFileError(
        file, "the archive holds more than " + std::to_string(EntryLimit) + " entries");
    if (type == AE_IFREG &&
        !visit(ArchiveEntry(from.get(), file, name, static_cast<std::size_t>(size))))
      return;
  }
}

} // namespace hasp
