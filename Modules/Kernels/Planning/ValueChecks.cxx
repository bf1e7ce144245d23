#include "Planning/ValueChecks.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

namespace
{
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
    if (!(std::abs(point[a]) <= 4000.0))
      this->Refuse(key + "[" + std::to_string(a) + "]", point[a], "in [-4000, 4000] mm");
}

void ValueChecks::Unit(const std::string& key, const glm::dvec3& direction) const
{
  if (const double length = glm::length(direction); !(std::abs(length - 1.0) <= 1e-3))
    this->Refuse(key + "'s length", length, "1 within 0.001");
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
