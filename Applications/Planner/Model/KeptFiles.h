#pragma once
#include <cstdint>
#include <filesystem>

namespace hasp
{

/// Removes the oldest files of a folder until all together have at most so many bytes; the newest
/// stays, however large it is. Files that differ in their ending alone go together, and are as old
/// as the newest of them. What cannot be removed stays; no folder is no error. Any thread.
void DropOldestFiles(const std::filesystem::path& folder, std::uintmax_t mostBytes);

} // namespace hasp
