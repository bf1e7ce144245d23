#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

struct vtksysMD5_s;

namespace hasp
{

/// UIDs that follow from content alone: the same bytes give the same UIDs on any machine and day.
/// MD5, as UUIDs of version 3 use it: it tells volumes apart and is no proof against forgery.
class ContentUid
{
public:
  ContentUid();
  ~ContentUid();
  ContentUid(const ContentUid&) = delete;
  ContentUid& operator=(const ContentUid&) = delete;

  void Add(const void* bytes, std::size_t size);
  /// Texts are kept apart: "ab", "c" is not "a", "bc".
  void Add(std::string_view text);
  /// No more is added afterwards.
  void Finish();

  /// "2.25." and a UUID as a number, for the thing of this name: "series", "slice 7".
  std::string Uid(std::string_view thing) const;
  /// Sixteen hexadecimal digits.
  std::string Short() const;

private:
  using Bytes = std::array<unsigned char, 16>;
  vtksysMD5_s* State;
  Bytes Digest{};
};

} // namespace hasp
