#pragma once
#include <filesystem>

namespace hasp
{

/// Notes a temporary file or folder for RemovePendingFiles, while this lives. A seventeenth at the
/// same time is not noted. Any thread.
class PendingName
{
public:
  explicit PendingName(const std::filesystem::path& name);
  ~PendingName() { this->Forget(); }
  PendingName(const PendingName&) = delete;
  PendingName& operator=(const PendingName&) = delete;
  void Forget() noexcept;

private:
  int Slot = -1;
};

/// Removes a file, or a folder with what is in it four folders deep. Safe in a signal handler.
void RemoveTree(const char* name) noexcept;

} // namespace hasp
