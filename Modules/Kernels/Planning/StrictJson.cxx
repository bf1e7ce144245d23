#include "Planning/StrictJson.h"

#include "Planning/ValueChecks.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace hasp
{

Json ParseJson(const std::string& text, const std::string& subject)
{
  std::vector<std::set<std::string>> keys; // of the objects that are open
  bool twice = false;
  const Json::parser_callback_t watch = [&](int, Json::parse_event_t event, Json& parsed)
  {
    if (event == Json::parse_event_t::object_start)
      keys.emplace_back();
    else if (event == Json::parse_event_t::object_end)
      keys.pop_back();
    else if (event == Json::parse_event_t::key)
      twice |= !keys.back().insert(parsed.get_ref<const std::string&>()).second;
    return true;
  };
  const std::string no = subject + ": no JSON: ";
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
    return json.dump(2) + "\n";
  }
  catch (const Json::exception&) // its text quotes the value
  {
    throw std::invalid_argument(subject + ": a text is not UTF-8");
  }
}

StrictJson::StrictJson(
  const Json& json, std::string subject, std::string name, std::initializer_list<const char*> keys)
  : Members(json),
    Subject(std::move(subject)),
    Name(std::move(name))
{
  if (!json.is_object())
    this->Fail("", "must be an object");
  int number = 0;
  for (const auto& [key, value] : json.items())
    if (++number; std::none_of(keys.begin(), keys.end(), [&](const char* k) { return key == k; }))
      this->Fail("key " + std::to_string(number), "is unknown; mend its spelling or take it out");
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

std::vector<glm::dvec3> StrictJson::Vectors(const char* key) const
{
  std::vector<glm::dvec3> vectors;
  for (const Json& value : this->List(key))
    vectors.push_back(this->AsVector(ListKey(key, vectors.size()), value));
  return vectors;
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
