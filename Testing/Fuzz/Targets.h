#pragma once
#include "Batch.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace hasp
{

/// What is fed with mutated bytes: a reader of one format.
struct Target
{
  std::string name;
  std::string fileName; ///< inputs are written under this name, whose ending chooses the reader
  /// Sound files of the format, of different kinds, into an empty folder.
  std::function<void(const std::filesystem::path& folder)> makeSeeds;
  /// Reads the file. std::exception: refused. std::bad_alloc is let through, because a reader that
  /// takes memory before it checks is at fault. The seeds are still there.
  std::function<void(const std::filesystem::path& file, const std::filesystem::path& seeds)> read;
  /// What stands between the mutated bytes and the file, where a checksum would find every fault;
  /// may be empty.
  std::function<std::string(const std::string& bytes)> pack = {};
};

/// Every reader of this build.
std::vector<Target> Targets();
/// Those of Devices, a part of Targets().
std::vector<Target> DeviceTargets();

/// The bytes of each seed, a file directly in the folder, in the order of their names. They are
/// made in a process of their own: libraries that start threads cannot be used before a fork.
std::vector<std::string> SeedsOf(const Target& target, const std::filesystem::path& emptyFolder);

/// Writes the bytes to folder/fileName, reads them and removes them.
Outcome Try(const Target& target, const std::string& bytes, const std::filesystem::path& folder,
  const std::filesystem::path& seeds);

} // namespace hasp
