#include "Volumes/HeaderText.h"
#include "Files/FileError.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr std::string_view Blanks = " \t\r\n";

} // namespace

std::string Trimmed(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == text.npos
           ? std::string()
           : std::string(text.substr(first, text.find_last_not_of(Blanks) - first + 1));
}

std::string LowerCase(std::string_view text)
{
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::optional<std::vector<double>> FiniteNumbers(std::string_view text, std::size_t count)
{
  std::vector<double> numbers;
  for (std::size_t at = 0; (at = text.find_first_not_of(Blanks, at)) != text.npos;)
  {
    const std::size_t end = std::min(text.find_first_of(Blanks, at), text.size());
    std::string_view word = text.substr(at, end - at);
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') // which from_chars does not take
      word.remove_prefix(1);
    double number = 0.0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    // Too small for a double is 0; too large is no number that can be used.
    const bool tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
    if (error == std::errc::result_out_of_range && tiny)
      number = 0.0;
    else if (error != std::errc())
      return std::nullopt;
    if (rest != word.data() + word.size() || !std::isfinite(number) || numbers.size() == count)
      return std::nullopt;
    numbers.push_back(number);
    at = end;
  }
  if (numbers.size() != count)
    return std::nullopt;
  return numbers;
}

std::string KnownModality(std::string_view text)
{
  for (const char* known : { "CT", "MR", "PT", "NM", "US", "CR", "DX", "XA", "OT" })
    if (text == known)
      return known;
  return {};
}

double SkewDegrees(const glm::dmat3& steps)
{
  double worst = 0.0;
  for (int a = 0; a < 3; ++a)
  {
    const glm::dvec3 one = glm::normalize(steps[a]), other = glm::normalize(steps[(a + 1) % 3]);
    const double degrees = std::abs(glm::degrees(std::asin(glm::dot(one, other))));
    if (!std::isfinite(degrees))
      return std::numeric_limits<double>::quiet_NaN();
    worst = std::max(worst, degrees);
  }
  return worst;
}

void SetIndexSteps(
  const std::filesystem::path& file, const glm::dmat3& steps, GridGeometry& geometry)
{
  for (int a = 0; a < 3; ++a)
  {
    // hypot: neither 1e-200 nor 1e200 is lost on the way
    geometry.spacing[a] = std::hypot(steps[a].x, steps[a].y, steps[a].z);
    geometry.direction[a] = steps[a] / geometry.spacing[a];
  }
  try
  {
    GridGeometry upright = geometry;
    upright.direction = glm::dmat3(1.0);
    upright.Validate(); // sizes, spacing and origin: only then an angle means something
    if (const double skew = SkewDegrees(geometry.direction); !(skew <= SkewLimitDegrees))
      ThrowFileError(file, "its axes are " + Text(skew) +
                             " degrees off right angles; resample it to a right-angled grid in the "
                             "program it comes from");
    geometry.Validate();
  }
  catch (const std::invalid_argument& error)
  {
    ThrowFileError(file, error.what());
  }
}

} // namespace hasp
