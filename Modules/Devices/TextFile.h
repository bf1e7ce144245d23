#pragma once
#include <cstddef>
#include <string>

namespace hasp
{

/// The file's bytes. `what` begins each message ("head path"); the file's name is in none. Throws
/// std::runtime_error if it cannot be read or is larger than `mostBytes`, which is held against its
/// size before memory is taken. Any thread.
std::string ReadTextFile(const std::string& file, std::size_t mostBytes, const char* what);

/// Writes a temporary file beside `file` and renames it: the old file or the new one, never half.
/// Throws std::runtime_error; nothing is left then. Any thread, one for each file.
void WriteTextFile(const std::string& file, const std::string& text, const char* what);

} // namespace hasp
