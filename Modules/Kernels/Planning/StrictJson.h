#pragma once
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hasp
{

/// Keys stay in the order in which they were written, so that equal values are equal texts.
using Json = nlohmann::ordered_json;

/// Reads a text. Throws std::runtime_error "SUBJECT: no JSON: …" with the byte of the first
/// mistake; a key that stands twice in one object is a mistake, too, and so is a nesting deeper
/// than
/// 64. Never quotes the text. Internal.
Json ParseJson(const std::string& text, const std::string& subject);

/// A key that is none. Says which of ours is nearest to it.
struct UnknownKey : std::invalid_argument
{
  UnknownKey(const std::string& text, const Json& whose, std::size_t number)
    : std::invalid_argument(text),
      object(&whose),
      key(number)
  {
  }
  const Json* object; ///< that it is in
  std::size_t key;    ///< from 0, in the order of the text
};
/// On what line of the text that `json` was parsed from the key stands, from 1.
std::size_t LineOf(const UnknownKey& unknown, const Json& json, const std::string& text);

/// read(ParseJson(text, subject)); an UnknownKey says its line, too.
template <typename Read>
auto ReadJson(const std::string& text, const std::string& subject, const Read& read)
{
  const Json json = ParseJson(text, subject);
  try
  {
    return read(json);
  }
  catch (const UnknownKey& unknown)
  {
    throw std::invalid_argument(
      unknown.what() + (" (line " + std::to_string(LineOf(unknown, json, text)) + ")"));
  }
}

/// Two spaces a level, lists of numbers on one line, a line feed at the end. Throws
/// std::invalid_argument "SUBJECT: a text is not UTF-8" rather than write what no one can read
/// back.
std::string FormatJson(const Json& json, const std::string& subject);

/// One object of a file, read strictly: only the keys named are in it, and what is asked for is
/// there and of its kind. Errors are std::invalid_argument "SUBJECT: NAME.KEY …" and say our own
/// keys and no text of the file, which may name a patient. The JSON must live longer. Internal. Any
/// thread.
class StrictJson
{
public:
  /// `name` is where the object stands in the file, such as "cuts[2]"; empty for the file itself.
  StrictJson(const Json& json, std::string subject, std::string name,
    std::initializer_list<const char*> keys);
  /// Of a file whose format is not ours: other keys may be there, and are not looked at.
  StrictJson(const Json& json, std::string subject, std::string name);

  bool Has(const char* key) const;
  const Json& Get(const char* key) const;
  double Number(const char* key) const;
  /// A whole number in [least, most], at most 2^53.
  std::uint64_t Count(const char* key, std::uint64_t least, std::uint64_t most) const;
  /// An array of such numbers.
  std::vector<std::uint32_t> Counts(const char* key, std::uint32_t least, std::uint32_t most) const;
  bool Flag(const char* key) const;
  std::string Text(const char* key) const;
  std::vector<double> Numbers(const char* key, std::size_t count) const;
  glm::dvec3 Vector(const char* key) const;
  std::vector<glm::dvec3> Vectors(const char* key, std::size_t most = 10000) const;
  /// Red, green, blue of "#e3dac9".
  std::array<std::uint8_t, 3> Colour(const char* key) const;
  /// An array of at most `most` entries.
  const Json& List(const char* key, std::size_t most = 10000) const;
  /// The value of the enum whose name the text is; the error lists the names.
  template <typename Enum, std::size_t N>
  Enum Named(const char* key, const std::pair<Enum, const char*> (&names)[N]) const;

  /// "SUBJECT: NAME.KEY TEXT"
  [[noreturn]] void Fail(const std::string& key, const std::string& text) const;

private:
  std::string Path(const std::string& key) const;
  std::uint64_t AsCount(
    const std::string& key, const Json& value, std::uint64_t least, std::uint64_t most) const;
  double AsNumber(const std::string& key, const Json& value) const;
  glm::dvec3 AsVector(const std::string& key, const Json& value) const;

  const Json& Members;
  std::string Subject, Name;
};

inline Json ToJson(const glm::dvec3& v)
{
  return { v.x, v.y, v.z };
}

/// "#e3dac9"
std::string ColourText(const std::array<std::uint8_t, 3>& colour);

/// The name of a value of an enum; all values are in `names`.
template <typename Enum, std::size_t N>
const char* NameOf(Enum value, const std::pair<Enum, const char*> (&names)[N])
{
  for (const auto& [named, name] : names)
    if (named == value)
      return name;
  return "";
}

template <typename Enum, std::size_t N>
Enum StrictJson::Named(const char* key, const std::pair<Enum, const char*> (&names)[N]) const
{
  const std::string text = this->Text(key);
  std::string all;
  for (std::size_t n = 0; n < N; ++n)
  {
    if (text == names[n].second)
      return names[n].first;
    all += (n == 0 ? "" : n + 1 == N ? " or " : ", ") + std::string(names[n].second);
  }
  this->Fail(key, "must be " + all);
}

} // namespace hasp
