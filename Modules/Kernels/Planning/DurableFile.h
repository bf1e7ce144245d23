#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace hasp
{

/// Puts a whole file in place, or leaves what was there: a temporary .hasp-… beside it, fsync,
/// rename, fsync of the folder. So at each moment, a crash or a full disk included, the name is of
/// the old bytes or of the new ones, and after the return of the new. Throws std::runtime_error
/// "SUBJECT cannot be written: …" without the path, which may name a patient; the temporary is gone
/// then, unless the program is. Two programs may write at once: the last one stays. Internal. Any
/// thread.
void WriteDurably(
  const std::filesystem::path& path, std::string_view bytes, const std::string& subject);

/// Makes a folder, if it is not there, so that a crash does not lose it.
void MakeFolderDurably(const std::filesystem::path& folder, const std::string& subject);

/// The whole of a regular file of at most `most` bytes. Throws std::runtime_error "SUBJECT …".
std::string ReadWhole(
  const std::filesystem::path& path, std::size_t most, const std::string& subject);

/// The temporaries of WriteDurably begin so; one that is left was a program's that ended meanwhile.
constexpr std::string_view TemporaryBegin = ".hasp-";

} // namespace hasp
