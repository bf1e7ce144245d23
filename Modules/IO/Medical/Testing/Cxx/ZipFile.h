#pragma once
#include "vtk_zlib.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// The bytes of a zip file of these names and contents, stored as they are.
inline std::string ZipFile(const std::vector<std::pair<std::string, std::string>>& entries)
{
  const auto add = [](std::string& to, std::uint32_t value, int bytes)
  {
    for (int n = 0; n < bytes; ++n)
      to += static_cast<char>(value >> (8 * n));
  };
  std::string file, directory;
  for (const auto& [name, content] : entries)
  {
    std::string common; // of both heads, from the version needed on
    add(common, 20, 2);
    add(common, 0, 4);        // neither flags nor compression
    add(common, 33 << 16, 4); // 1 January 1980
    add(common,
      static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(content.data()), uInt(content.size()))),
      4);
    add(common, std::uint32_t(content.size()), 4);
    add(common, std::uint32_t(content.size()), 4);
    add(common, std::uint32_t(name.size()), 2);
    add(common, 0, 2);
    directory += std::string("PK\1\2\24\0", 6) + common;
    add(directory, 0, 10);
    add(directory, std::uint32_t(file.size()), 4);
    directory += name;
    file += std::string("PK\3\4", 4) + common + name + content;
  }
  const auto start = std::uint32_t(file.size());
  file += directory + std::string("PK\5\6\0\0\0\0", 8);
  add(file, std::uint32_t(entries.size()), 2);
  add(file, std::uint32_t(entries.size()), 2);
  add(file, std::uint32_t(directory.size()), 4);
  add(file, start, 4);
  add(file, 0, 2);
  return file;
}
