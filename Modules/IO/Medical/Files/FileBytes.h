#pragma once
#include "Grid/Progress.h"

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace hasp
{

/// A regular file, read once from front to end through a buffer of 1 MiB. All errors throw
/// std::runtime_error with the file's label; progress is reported and may cancel. One thread.
class FileBytes
{
public:
  /// What the buffer holds, and what a line may be long.
  static constexpr std::size_t Piece = std::size_t(1) << 20;

  FileBytes(const std::filesystem::path& file, const ProgressFunction& progress);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  const std::filesystem::path& File() const { return this->Named; }
  std::uint64_t Size() const { return this->Bytes; } ///< when it was opened
  std::uint64_t Offset() const { return this->BufferStart + this->Next; }
  std::uint64_t Left() const { return this->Bytes - this->Offset(); }

  /// The next bytes, or up to the file's end if there are fewer; they stay unread. `size` is at
  /// most Piece.
  std::string_view Peek(std::size_t size);
  /// Throws, with the offset, if the file ends before.
  void Read(void* into, std::size_t size);
  void Skip(std::uint64_t size);

  /// The next line without its end, LF or CR LF; a byte order mark at the file's start is left out.
  /// False at the end of the file. The text is there until the next call. Throws if it has more
  /// than 1 MiB.
  bool Line(std::string_view& line);
  std::uint64_t LineNumber() const { return this->Lines; } ///< of that line, from 1
  bool LastLineHadNoEnd() const { return this->Open; }

private:
  [[noreturn]] void ThrowCutOff(std::uint64_t wanted) const;
  /// Moves what is unread to the front and fills the rest. False if nothing came.
  bool Fill();

  const std::filesystem::path Named;
  const ProgressFunction Progress;
  int Descriptor = -1;
  std::uint64_t Bytes = 0, BufferStart = 0, Lines = 0;
  std::vector<char> Buffer;
  std::size_t Next = 0, End = 0; ///< unread part of the buffer
  bool Open = false;
};

} // namespace hasp
