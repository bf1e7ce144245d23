#pragma once
#include <cstdint>
#include <string_view>

namespace hasp
{

/// The words of a line, told apart by blanks and tabs.
class Words
{
public:
  explicit Words(std::string_view line) : Rest(line) {}
  /// Empty when there are no more.
  std::string_view Next();

private:
  std::string_view Rest;
};

/// The whole word as a number, whatever the locale: "-1.5e3", "+2", ".5". False for anything else,
/// also for numbers beyond double precision; "inf" and "nan" are numbers here. Too small is 0.
bool ToNumber(std::string_view word, double& value);
/// The whole word as an integer of 64 bits.
bool ToInteger(std::string_view word, std::int64_t& value);
/// `word` equals `lower`, a word in small letters, letters of either case.
bool IsWord(std::string_view word, std::string_view lower);

} // namespace hasp
