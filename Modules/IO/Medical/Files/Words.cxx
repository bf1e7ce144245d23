#include "Files/Words.h"

#include <algorithm>
#include <charconv>

namespace hasp
{
namespace
{

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
  const std::size_t start = this->Rest.find_first_not_of(" \t\r\v\f");
  if (start == this->Rest.npos)
    return this->Rest = {};
  this->Rest.remove_prefix(start);
  const std::string_view word = this->Rest.substr(0, this->Rest.find_first_of(" \t\r\v\f"));
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

bool IsWord(std::string_view word, std::string_view lower)
{
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
    [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); });
}

} // namespace hasp
