#pragma once
#include <array>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hasp
{

/// Text of numbers, a line a row, under a line that names the columns; commas and nothing else
/// between them. Errors are std::invalid_argument, begin with `what` and the line, and hold none of
/// the text.
template <std::size_t Columns>
class NumberTable
{
public:
  using Row = std::array<double, Columns>;

  /// Takes the first line off the text: throws unless it is `names`.
  NumberTable(const char* what, std::string_view names, std::string_view text)
    : What(what),
      Text(text)
  {
    if (this->NextLine() != names)
      this->Refuse("it must be " + std::string(names));
  }
  bool AtEnd() const { return this->Text.empty(); }
  std::size_t BytesLeft() const { return this->Text.size(); }
  Row Next()
  {
    const std::string_view line = this->NextLine();
    Row values{};
    const char *at = line.data(), *const end = line.data() + line.size();
    for (std::size_t c = 0; c < Columns; ++c)
    {
      if (c > 0 && (at == end || *at++ != ','))
        this->Refuse(
          "there must be " + std::to_string(Columns) + " numbers with commas between them");
      const auto [next, error] = std::from_chars(at, end, values[c]);
      if (error != std::errc())
        this->Refuse("column " + std::to_string(c + 1) + " is no number that a double holds");
      at = next;
    }
    if (at != end)
      this->Refuse("something stands behind the last number");
    return values;
  }
  /// Says why the last line, or `line`, will not do.
  [[noreturn]] void Refuse(const std::string& why) const { this->Refuse(this->Line, why); }
  [[noreturn]] void Refuse(std::size_t line, const std::string& why) const
  {
    throw std::invalid_argument(
      std::string(this->What) + ": line " + std::to_string(line) + ": " + why);
  }

private:
  /// Without its end; "\r\n" ends one, too.
  std::string_view NextLine()
  {
    ++this->Line;
    const std::size_t end = std::min(this->Text.find('\n'), this->Text.size());
    std::string_view line = this->Text.substr(0, end);
    this->Text.remove_prefix(std::min(end + 1, this->Text.size()));
    if (line.ends_with('\r'))
      line.remove_suffix(1);
    return line;
  }

  const char* What;
  std::string_view Text;
  std::size_t Line = 0; ///< the last that was taken, from 1
};

} // namespace hasp
