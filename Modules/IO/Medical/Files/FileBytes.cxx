#include "Files/FileBytes.h"
#include "Files/FileError.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace hasp
{

FileBytes::FileBytes(const std::filesystem::path& file, const ProgressFunction& progress)
  : Named(file),
    Progress(progress),
    Descriptor(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) // a pipe must not block
{
  struct stat facts
  {
  };
  if (this->Descriptor < 0 || fstat(this->Descriptor, &facts) != 0)
  {
    const std::string reason = strerror(errno);
    if (this->Descriptor >= 0)
      close(this->Descriptor);
    ThrowFileError(file, "cannot be opened: " + reason);
  }
  if (!S_ISREG(facts.st_mode))
  {
    close(this->Descriptor);
    ThrowFileError(file, "is no regular file");
  }
  this->Bytes = static_cast<std::uint64_t>(facts.st_size);
  this->Buffer.resize(std::clamp<std::uint64_t>(this->Bytes, 1, Piece));
}

FileBytes::~FileBytes()
{
  close(this->Descriptor);
}

void FileBytes::ThrowCutOff(std::uint64_t wanted) const
{
  ThrowFileError(this->Named, "ends at byte " + std::to_string(this->Bytes) + ", " +
                                std::to_string(wanted) + " bytes from byte " +
                                std::to_string(this->Offset()) +
                                " on are missing: it is cut off or damaged. Copy it again");
}

bool FileBytes::Fill()
{
  std::copy(this->Buffer.data() + this->Next, this->Buffer.data() + this->End, this->Buffer.data());
  this->BufferStart += this->Next;
  this->End -= this->Next;
  this->Next = 0;
  // Not beyond the size it had: the checks of declared counts were made against that.
  const std::uint64_t unread = this->Bytes - this->BufferStart - this->End;
  const std::size_t room = std::min<std::uint64_t>(this->Buffer.size() - this->End, unread);
  if (room == 0)
    return false;
  ReportProgress(this->Progress, double(this->BufferStart) / double(this->Bytes));
  ssize_t got = 0;
  do
    got = read(this->Descriptor, this->Buffer.data() + this->End, room);
  while (got < 0 && errno == EINTR);
  if (got < 0)
    ThrowFileError(this->Named, std::string("cannot be read: ") + strerror(errno));
  if (got == 0)
    ThrowFileError(this->Named, "was shortened while it was read; open it again");
  this->End += static_cast<std::size_t>(got);
  return true;
}

std::string_view FileBytes::Peek(std::size_t size)
{
  while (this->End - this->Next < size && this->Fill())
    ;
  return { this->Buffer.data() + this->Next, std::min(size, this->End - this->Next) };
}

void FileBytes::Read(void* into, std::size_t size)
{
  if (size > this->Left())
    this->ThrowCutOff(size);
  auto* to = static_cast<char*>(into);
  while (size > 0)
  {
    const std::size_t there = std::min(size, this->End - this->Next);
    std::memcpy(to, this->Buffer.data() + this->Next, there);
    this->Next += there;
    to += there;
    size -= there;
    if (size > 0)
      this->Fill();
  }
}

void FileBytes::Skip(std::uint64_t size)
{
  if (size > this->Left())
    this->ThrowCutOff(size);
  while (size > 0)
  {
    const std::size_t there = std::min<std::uint64_t>(size, this->End - this->Next);
    this->Next += there;
    size -= there;
    if (size > 0)
      this->Fill();
  }
}

bool FileBytes::Line(std::string_view& line)
{
  if (this->Lines == 0 && this->Offset() == 0 && this->Peek(3) == "\xEF\xBB\xBF")
    this->Next += 3;
  std::size_t searched = 0;
  const char* end = nullptr;
  do
  {
    const char* start = this->Buffer.data() + this->Next;
    const std::size_t there = this->End - this->Next;
    end = static_cast<const char*>(std::memchr(start + searched, '\n', there - searched));
    searched = there;
    if (!end && searched >= Piece)
      ThrowFileError(this->Named, "line " + std::to_string(this->Lines + 1) +
                                    " has more than 1048576 bytes; this is no text of a surface");
  } while (!end && this->Fill());
  const char* start = this->Buffer.data() + this->Next;
  const std::size_t length = end ? end - start : this->End - this->Next;
  if (!end && length == 0)
    return false;
  ++this->Lines;
  this->Open = !end;
  this->Next += length + (end ? 1 : 0);
  line = { start, length };
  if (!line.empty() && line.back() == '\r')
    line.remove_suffix(1);
  return true;
}

} // namespace hasp
