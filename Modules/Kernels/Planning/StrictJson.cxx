#include "Planning/StrictJson.h"

#include "Planning/ValueChecks.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <functional>
#include <numeric>
#include <set>
#include <stdexcept>

namespace hasp
{

namespace
{
constexpr int MostDepth = 64;

/// How many letters to put in, take out or change (Levenshtein), of the first 100; a letter's case
/// is half a change.
double Misspelling(const std::string& wrong, const std::string& right)
{
  const std::string a = wrong.substr(0, 100);
  std::vector<double> row(right.size() + 1);
  std::iota(row.begin(), row.end(), 0.0);
  for (std::size_t n = 0; n < a.size(); ++n)
  {
    double corner = row[0];
    row[0] = double(n + 1);
    for (std::size_t m = 0; m < right.size(); ++m)
    {
      const bool letter = std::tolower(static_cast<unsigned char>(a[n])) ==
                          std::tolower(static_cast<unsigned char>(right[m]));
      const double change = corner + (a[n] == right[m] ? 0.0 : letter ? 0.5 : 1.0);
      corner = row[m + 1];
      row[m + 1] = std::min({ change, row[m] + 1.0, row[m + 1] + 1.0 });
    }
  }
  return row.back();
}

/// Of our own keys; one that the object has already is a letter farther.
std::string Nearest(
  const std::string& wrong, const Json& object, std::initializer_list<const char*> keys)
{
  const auto far = [&](const char* key)
  { return Misspelling(wrong, key) + (object.contains(key) ? 1.0 : 0.0); };
  return *std::min_element(
    keys.begin(), keys.end(), [&](const char* a, const char* b) { return far(a) < far(b); });
}

bool IsNumbers(const Json& json)
{
  return json.is_array() && !json.empty() &&
         std::all_of(json.begin(), json.end(), [](const Json& value) { return value.is_number(); });
}

/// As dump(2), but for lists of numbers: a point of a stroke is one line and not five.
void Write(const Json& json, std::size_t indent, std::string& text)
{
  if (!json.is_structured() || json.empty())
  {
    text += json.dump();
    return;
  }
  const bool object = json.is_object(), oneLine = IsNumbers(json);
  const auto newLine = [&](std::size_t spaces) { text.append(1, '\n').append(spaces, ' '); };
  char before = object ? '{' : '[';
  for (auto member = json.begin(); member != json.end(); ++member)
  {
    text += before;
    if (!oneLine)
      newLine(indent + 2);
    else if (before == ',')
      text += ' ';
    if (object)
      text.append(Json(member.key()).dump()).append(": ");
    Write(*member, indent + 2, text);
    before = ',';
  }
  if (!oneLine)
    newLine(indent);
  text += object ? '}' : ']';
}
} // namespace

std::size_t LineOf(const UnknownKey& unknown, const Json& json, const std::string& text)
{
  std::size_t before = 0; // keys of the whole, down to the one wanted
  const std::function<bool(const Json&)> counted = [&](const Json& value)
  {
    std::size_t number = 0;
    for (auto member = value.begin(); value.is_structured() && member != value.end(); ++member)
    {
      if (&value == unknown.object && number++ == unknown.key)
        return true;
      before += value.is_object();
      if (counted(*member))
        return true;
    }
    return false;
  };
  counted(json);
  std::size_t line = 1, keys = 0;
  for (std::size_t n = 0; n < text.size(); ++n)
  {
    line += text[n] == '\n';
    if (text[n] != '"')
      continue;
    while (text[++n] != '"')
      n += text[n] == '\\';
    const std::size_t after = text.find_first_not_of(" \t\r\n", n + 1);
    if (after != std::string::npos && text[after] == ':' && keys++ == before)
      return line;
  }
  return line;
}

Json ParseJson(const std::string& text, const std::string& subject)
{
  std::vector<std::set<std::string>> keys; // of the objects that are open
  bool twice = false;
  const std::string no = subject + ": no JSON: ";
  const Json::parser_callback_t watch = [&](int depth, Json::parse_event_t event, Json& parsed)
  {
    if (depth > MostDepth)
      throw std::runtime_error(no + "it is nested deeper than " + std::to_string(MostDepth));
    if (event == Json::parse_event_t::object_start)
      keys.emplace_back();
    else if (event == Json::parse_event_t::object_end)
      keys.pop_back();
    else if (event == Json::parse_event_t::key)
      twice |= !keys.back().insert(parsed.get_ref<const std::string&>()).second;
    return true;
  };
  try
  {
    Json json = Json::parse(text, watch);
    if (twice)
      throw std::runtime_error(no + "a key stands twice in one object");
    return json;
  }
  catch (const Json::parse_error& error) // its text quotes the file
  {
    throw std::runtime_error(no + "a mistake at byte " + std::to_string(error.byte));
  }
  catch (const Json::exception&)
  {
    throw std::runtime_error(no + "a number is too large for any double");
  }
}

std::string FormatJson(const Json& json, const std::string& subject)
{
  try
  {
    std::string text;
    Write(json, 0, text);
    return text + "\n";
  }
  catch (const Json::exception&) // its text quotes the value
  {
    throw std::invalid_argument(subject + ": a text is not UTF-8");
  }
}

std::string ColourText(const std::array<std::uint8_t, 3>& colour)
{
  char text[8];
  std::snprintf(text, sizeof(text), "#%02x%02x%02x", colour[0], colour[1], colour[2]);
  return text;
}

StrictJson::StrictJson(
  const Json& json, std::string subject, std::string name, std::initializer_list<const char*> keys)
  : StrictJson(json, std::move(subject), std::move(name))
{
  std::size_t number = 0;
  for (auto member = json.begin(); member != json.end(); ++member, ++number)
    if (const std::string& key = member.key();
        std::none_of(keys.begin(), keys.end(), [&](const char* k) { return key == k; }))
      throw UnknownKey(this->Subject + ": a key" + (this->Name.empty() ? "" : " of " + this->Name) +
                         " is unknown, the nearest known is '" + Nearest(key, json, keys) +
                         "'; mend its spelling or take it out",
        json, number);
}

StrictJson::StrictJson(const Json& json, std::string subject, std::string name)
  : Members(json),
    Subject(std::move(subject)),
    Name(std::move(name))
{
  if (!json.is_object())
    this->Fail("", "must be an object");
}

bool StrictJson::Has(const char* key) const
{
  return this->Members.contains(key);
}

const Json& StrictJson::Get(const char* key) const
{
  const auto found = this->Members.find(key);
  if (found == this->Members.end())
    this->Fail(key, "is missing");
  return *found;
}

double StrictJson::Number(const char* key) const
{
  return this->AsNumber(key, this->Get(key));
}

std::uint64_t StrictJson::Count(const char* key, std::uint64_t least, std::uint64_t most) const
{
  return this->AsCount(key, this->Get(key), least, most);
}

std::vector<std::uint32_t> StrictJson::Counts(
  const char* key, std::uint32_t least, std::uint32_t most) const
{
  std::vector<std::uint32_t> counts;
  for (const Json& value : this->List(key))
    counts.push_back(
      static_cast<std::uint32_t>(this->AsCount(ListKey(key, counts.size()), value, least, most)));
  return counts;
}

bool StrictJson::Flag(const char* key) const
{
  const Json& value = this->Get(key);
  if (!value.is_boolean())
    this->Fail(key, "must be true or false");
  return value.get<bool>();
}

std::string StrictJson::Text(const char* key) const
{
  const Json& value = this->Get(key);
  if (!value.is_string())
    this->Fail(key, "must be text");
  return value.get<std::string>();
}

std::vector<double> StrictJson::Numbers(const char* key, std::size_t count) const
{
  std::vector<double> numbers;
  for (const Json& value : this->List(key))
    numbers.push_back(this->AsNumber(ListKey(key, numbers.size()), value));
  if (numbers.size() != count)
    this->Fail(key, "must be " + std::to_string(count) + " numbers");
  return numbers;
}

glm::dvec3 StrictJson::Vector(const char* key) const
{
  return this->AsVector(key, this->Get(key));
}

std::vector<glm::dvec3> StrictJson::Vectors(const char* key, std::size_t most) const
{
  std::vector<glm::dvec3> vectors;
  for (const Json& value : this->List(key, most))
    vectors.push_back(this->AsVector(ListKey(key, vectors.size()), value));
  return vectors;
}

std::array<std::uint8_t, 3> StrictJson::Colour(const char* key) const
{
  const std::string text = this->Text(key);
  if (text.size() != 7 || text[0] != '#' ||
      text.find_first_not_of("0123456789abcdef", 1) != std::string::npos)
    this->Fail(key, "must be # and six hexadecimal digits in lower case");
  const unsigned long value = std::stoul(text.substr(1), nullptr, 16);
  return { static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U),
    static_cast<std::uint8_t>(value) };
}

const Json& StrictJson::List(const char* key, std::size_t most) const
{
  const Json& value = this->Get(key);
  if (!value.is_array())
    this->Fail(key, "must be a list");
  if (value.size() > most)
    this->Fail(key, "has " + std::to_string(value.size()) + " entries, at most " +
                      std::to_string(most) + " are read");
  return value;
}

void StrictJson::Fail(const std::string& key, const std::string& text) const
{
  const std::string path = this->Path(key);
  throw std::invalid_argument(
    this->Subject + ": " + (path.empty() ? "the whole" : path) + " " + text);
}

std::string StrictJson::Path(const std::string& key) const
{
  return this->Name + (this->Name.empty() || key.empty() ? "" : ".") + key;
}

std::uint64_t StrictJson::AsCount(
  const std::string& key, const Json& value, std::uint64_t least, std::uint64_t most) const
{
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() < least ||
      value.get<std::uint64_t>() > most)
    this->Fail(key,
      "must be a whole number in [" + std::to_string(least) + ", " + std::to_string(most) + "]");
  return value.get<std::uint64_t>();
}

double StrictJson::AsNumber(const std::string& key, const Json& value) const
{
  if (!value.is_number())
    this->Fail(key, "must be a number");
  return value.get<double>();
}

glm::dvec3 StrictJson::AsVector(const std::string& key, const Json& value) const
{
  if (!value.is_array() || value.size() != 3)
    this->Fail(key, "must be three numbers");
  return { this->AsNumber(key, value[0]), this->AsNumber(key, value[1]),
    this->AsNumber(key, value[2]) };
}

} // namespace hasp
