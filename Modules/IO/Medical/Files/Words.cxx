#include "Files/Words.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace hasp
{
namespace
{

constexpr std::string_view Blanks = " \t\r\n\v\f";

char Lower(char c)
{
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// std::from_chars knows no plus.
std::string_view WithoutPlus(std::string_view word)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  return word;
}

} // namespace

std::string_view Words::Next()
{
  const std::size_t start = this->Rest.find_first_not_of(Blanks);
  if (start == this->Rest.npos)
    return this->Rest = {};
  this->Rest.remove_prefix(start);
  const std::string_view word = this->Rest.substr(0, this->Rest.find_first_of(Blanks));
  this->Rest.remove_prefix(word.size());
  return word;
}

bool ToNumber(std::string_view word, double& value)
{
  word = WithoutPlus(word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const std::size_t exponent = word.find_first_of("eE");
  if (error == std::errc::result_out_of_range && exponent < word.size() - 1 &&
      word[exponent + 1] == '-')
  {
    value = 0.0;
    return end == word.data() + word.size();
  }
  return error == std::errc() && end == word.data() + word.size();
}

bool ToInteger(std::string_view word, std::int64_t& value)
{
  word = WithoutPlus(word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

std::optional<std::vector<double>> FiniteNumbers(std::string_view text, std::size_t count)
{
  std::vector<double> numbers;
  Words words(text);
  for (std::string_view word = words.Next(); !word.empty(); word = words.Next())
  {
    double number = 0.0;
    if (numbers.size() == count || !ToNumber(word, number) || !std::isfinite(number))
      return std::nullopt;
    numbers.push_back(number);
  }
  if (numbers.size() != count)
    return std::nullopt;
  return numbers;
}

bool IsWord(std::string_view word, std::string_view lower)
{
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
    [](char a, char b) { return Lower(a) == b; });
}

std::string LowerCase(std::string_view text)
{
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), Lower);
  return lower;
}

std::string Trimmed(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == text.npos
           ? std::string()
           : std::string(text.substr(first, text.find_last_not_of(Blanks) - first + 1));
}

} // namespace hasp
