#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
/// How many bytes the character that begins at `at` has; 0 if it is none: overlong, a surrogate,
/// above U+10FFFF, cut off, or a control character.
std::size_t CharacterBytes(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t n) -> unsigned
  { return at + n < text.size() ? static_cast<unsigned char>(text[at + n]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80)
    return first < 0x20 || first == 0x7F ? 0 : 1;
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  unsigned code = first & (0x7FU >> bytes);
  for (std::size_t n = 1; n < bytes; ++n)
  {
    if ((byte(n) & 0xC0U) != 0x80)
      return 0;
    code = code << 6U | (byte(n) & 0x3FU);
  }
  constexpr unsigned least[] = { 0, 0, 0xA0, 0x800, 0x10000 }; // U+0080 to U+009F are controls
  const bool sound =
    first >= 0xC0 && code >= least[bytes] && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
  return sound ? bytes : 0;
}

constexpr double FarthestMm = 4000.0;

std::string Range(char bracket, double low, double high)
{
  std::ostringstream range;
  range << "in " << bracket << low << ", " << high << "]";
  return range.str();
}
} // namespace

void ValueChecks::Closed(const std::string& key, double value, double low, double high) const
{
  if (!(value >= low && value <= high))
    this->Refuse(key, value, Range('[', low, high));
}

void ValueChecks::AboveUpTo(const std::string& key, double value, double low, double high) const
{
  if (!(value > low && value <= high))
    this->Refuse(key, value, Range('(', low, high));
}

void ValueChecks::Point(const std::string& key, const glm::dvec3& point) const
{
  for (int a = 0; a < 3; ++a)
    if (!(std::abs(point[a]) <= FarthestMm))
      this->Refuse(key + "[" + std::to_string(a) + "]", point[a], "in [-4000, 4000] mm");
}

void ValueChecks::Points(const char* list, const std::vector<glm::dvec3>& points) const
{
  for (std::size_t n = 0; n < points.size(); ++n)
    if (const glm::dvec3& p = points[n];
        !(std::abs(p.x) <= FarthestMm && std::abs(p.y) <= FarthestMm &&
          std::abs(p.z) <= FarthestMm))
      this->Point(ListKey(list, n), p);
}

void ValueChecks::Unit(const std::string& key, const glm::dvec3& direction) const
{
  if (const double length = glm::length(direction); !(std::abs(length - 1.0) <= 1e-3))
    this->Refuse(key + "'s length", length, "1 within 0.001");
}

void ValueChecks::Text(const std::string& key, const std::string& text) const
{
  if (text.size() > 200)
    this->Refuse(key, "is longer than 200 bytes");
  for (std::size_t at = 0, bytes = 0; at < text.size(); at += bytes)
    if (bytes = CharacterBytes(text, at); bytes == 0)
      this->Refuse(key, "holds a control character or is not UTF-8");
}

void ValueChecks::Hash(const std::string& key, const std::string& hash) const
{
  if (hash.size() != 64 || hash.find_first_not_of("0123456789abcdef") != std::string::npos)
    this->Refuse(key, "must be 64 hexadecimal digits in lower case, a SHA-256");
}

void ValueChecks::Refuse(const std::string& key, double value, const std::string& must) const
{
  std::ostringstream text;
  text << this->Subject << ": " << key << " is " << value << ", must be " << must;
  throw std::invalid_argument(text.str());
}

void ValueChecks::Refuse(const std::string& key, const std::string& must) const
{
  throw std::invalid_argument(this->Subject + ": " + key + " " + must);
}

std::string ListKey(const char* list, std::size_t n)
{
  return std::string(list) + "[" + std::to_string(n) + "]";
}

std::string ListKey(const char* list, std::size_t n, const char* key)
{
  return ListKey(list, n) + "." + key;
}

} // namespace hasp
