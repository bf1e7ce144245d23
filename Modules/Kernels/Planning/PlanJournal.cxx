#include "Planning/PlanJournal.h"

#include "Planning/DurableFile.h"
#include "Planning/JournalRecords.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace hasp
{

namespace
{
namespace fs = std::filesystem;

constexpr const char* Subject = "the journal";
constexpr const char* CannotWrite = "the journal cannot be written";
constexpr const char* CannotRemove = "the journal cannot be removed";
constexpr std::size_t Grain = std::size_t(1) << 20U; // of how far a journal grows

[[noreturn]] void Fail(const char* what, int error)
{
  throw std::runtime_error(std::string(what) + ": " + std::generic_category().message(error));
}

class Descriptor
{
public:
  explicit Descriptor(int number = -1) : Number(number) {}
  Descriptor(Descriptor&& other) noexcept : Number(std::exchange(other.Number, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept
  {
    std::swap(this->Number, other.Number);
    return *this;
  }
  ~Descriptor()
  {
    if (this->Number >= 0)
      close(this->Number);
  }
  int Get() const { return this->Number; }

private:
  int Number;
};

fs::path LockOf(fs::path file)
{
  return file += ".lock";
}

/// A lock of the whole file that belongs to the descriptor, and not, as POSIX's older ones, to the
/// process; unlike flock's it can be asked for without being taken, so that who asks is in no one's
/// way.
int Lock(int file, int command, struct flock& lock)
{
  lock = {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return fcntl(file, command, &lock);
}

/// Whether the path is still the name of the open file, and how large that is.
bool Names(const fs::path& path, int file, std::size_t& size)
{
  struct stat held, named;
  if (fstat(file, &held) != 0 || stat(path.c_str(), &named) != 0)
    return false;
  size = std::size_t(held.st_size);
  return held.st_ino == named.st_ino && held.st_dev == named.st_dev;
}

/// The lock, or an error: nobody waits for a planner to end.
Descriptor Locked(const fs::path& file, const char* cannot)
{
  const fs::path path = LockOf(file);
  // Where RemoveJournal takes the name away in between, others would lock another file: once more.
  for (int tries = 0; tries < 100; ++tries)
  {
    Descriptor held(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (held.Get() < 0)
      Fail(cannot, errno);
    struct flock lock;
    if (Lock(held.Get(), F_OFD_SETLK, lock) != 0 && (errno == EAGAIN || errno == EACCES))
      break;
    if (std::size_t size = 0; Names(path, held.Get(), size))
      return held;
  }
  throw std::runtime_error(std::string(cannot) + ": it is in use by a planner that runs");
}

/// Errno of the write that failed, 0 if none did.
int WriteAll(int file, std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR)
      return errno;
    bytes.remove_prefix(written < 0 ? 0 : std::size_t(written));
  }
  return 0;
}
} // namespace

class PlanJournal::Writer
{
public:
  Writer(fs::path file, const PlanDocument& start)
    : Path(std::move(file)),
      Held(Locked(this->Path, CannotWrite)),
      State(start)
  {
    this->Begin(start, 0);
  }

  void Begin(const PlanDocument& start, std::size_t actions)
  {
    JournalState state(start);
    JournalSeal seal;
    const std::string records = StartRecords(seal, start, actions);
    WriteDurably(this->Path, records, Subject);
    Descriptor file(open(this->Path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
    if (file.Get() < 0)
      Fail(CannotWrite, errno);
    this->File = std::move(file);
    this->State = std::move(state);
    this->Seal = std::move(seal);
    this->Actions = actions;
    this->Size = records.size();
    this->MostSize = std::min(4 * records.size() + Grain, MostJournal);
    this->Doubtful = false;
  }

  void Append(const PlanDocument& now)
  {
    if (!CanLeadTo(this->State, now))
      return this->Begin(now, this->Actions + 1);
    std::optional<JournalChange> change = ChangeTo(this->State, now);
    if (!change && this->IsMine())
      return;
    if (!change || !this->IsMine())
      return this->Begin(now, this->Actions + (change ? 1 : 0));
    JournalSeal seal = this->Seal;
    const std::string record = seal.Record(FormatChange(*change));
    if (record.size() > MostRecord || this->Size + record.size() > MostJournal)
      return this->Begin(now, this->Actions + 1);
    if (this->Size + record.size() > this->MostSize && this->HasBegunAnew(now))
      return;
    MakeRoom(this->State, *change);
    this->Write(record);
    Take(this->State, std::move(*change));
    this->Seal = std::move(seal);
    ++this->Actions;
  }

private:
  /// Whether the file is the one that is open, and ends with what was written last.
  bool IsMine() const
  {
    std::size_t size = 0;
    return !this->Doubtful && Names(this->Path, this->File.Get(), size) && size == this->Size;
  }

  /// False if there is no room for another whole document, but there may be for a record.
  bool HasBegunAnew(const PlanDocument& now)
  {
    try
    {
      this->Begin(now, this->Actions + 1);
      return true;
    }
    catch (const std::runtime_error&)
    {
      if (!this->IsMine()) // it is in place, but may not be safe there
        throw;
      this->MostSize += Grain; // not again at each action
      return false;
    }
  }

  /// Behind the last record, or not at all.
  void Write(std::string_view record)
  {
    int error = WriteAll(this->File.Get(), record);
    if (error == 0 && fdatasync(this->File.Get()) != 0)
    {
      error = errno;
      this->Doubtful = true; // what the system could not write once, it may never write
    }
    if (error != 0)
    {
      if (ftruncate(this->File.Get(), off_t(this->Size)) != 0)
        this->Doubtful = true;
      Fail(CannotWrite, error);
    }
    this->Size += record.size();
  }

  const fs::path Path;
  const Descriptor Held; ///< the lock
  Descriptor File;
  JournalState State;
  JournalSeal Seal;
  std::size_t Actions = 0;
  std::size_t Size = 0;     ///< of the whole records
  std::size_t MostSize = 0; ///< above, it begins anew
  bool Doubtful = false;    ///< what is on disk is not known: it begins anew
};

PlanJournal::PlanJournal(const fs::path& file, const PlanDocument& start)
  : Own(std::make_unique<Writer>(file, start))
{
}

PlanJournal::~PlanJournal() = default;

void PlanJournal::Append(const PlanDocument& now)
{
  this->Own->Append(now);
}

void PlanJournal::Begin(const PlanDocument& start)
{
  this->Own->Begin(start, 0);
}

RecoveredPlan ReadJournal(const fs::path& file)
{
  return ReadRecords(ReadWhole(file, MostJournal, Subject));
}

bool JournalInUse(const fs::path& file)
{
  const Descriptor asked(open(LockOf(file).c_str(), O_RDONLY | O_CLOEXEC));
  struct flock lock;
  return asked.Get() >= 0 && Lock(asked.Get(), F_OFD_GETLK, lock) == 0 && lock.l_type != F_UNLCK;
}

void RemoveJournal(const fs::path& file)
{
  const Descriptor held = Locked(file, CannotRemove);
  for (const fs::path& path : { file, LockOf(file) })
    if (unlink(path.c_str()) != 0 && errno != ENOENT)
      Fail(CannotRemove, errno);
}

} // namespace hasp
