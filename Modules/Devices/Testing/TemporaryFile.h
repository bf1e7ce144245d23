#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

/// A name in the temporary folder; what lies there goes with it.
class TemporaryFile
{
public:
  TemporaryFile()
    : Path((std::filesystem::temp_directory_path() / ("hasp-ticks-" + std::to_string(getpid())))
             .string())
  {
  }
  ~TemporaryFile() { std::filesystem::remove(this->Path); }
  const std::string Path;
};
