#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// How text of files is read: one way for all formats, whatever the locale.
namespace hasp
{

/// The words of a line, told apart by blanks, tabs and line ends.
class Words
{
public:
  explicit Words(std::string_view line) : Rest(line) {}
  /// Empty when there are no more.
  std::string_view Next();

private:
  std::string_view Rest;
};

/// The whole word as a number: "-1.5e3", "+2", ".5". False for anything else, also for numbers
/// beyond double precision; "inf" and "nan" are numbers here. Too small is 0.
bool ToNumber(std::string_view word, double& value);
/// The whole word as an integer of 64 bits.
bool ToInteger(std::string_view word, std::int64_t& value);
/// The words as numbers; nothing unless there are `count` of them, all finite, and nothing else.
std::optional<std::vector<double>> FiniteNumbers(std::string_view text, std::size_t count);

/// `word` equals `lower`, a word in small letters, letters of either case.
bool IsWord(std::string_view word, std::string_view lower);
/// ASCII's capitals in small letters, all else as it is.
std::string LowerCase(std::string_view text);
/// Without blanks and line ends around it.
std::string Trimmed(std::string_view text);

} // namespace hasp
