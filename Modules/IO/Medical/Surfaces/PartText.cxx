#include "Surfaces/PartText.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr std::string_view Maker = "Hasp " HASP_VERSION " SPACE=LPS; UNIT=mm";
constexpr std::string_view Red = "; DOES NOT HOLD";
static_assert(Maker.size() + Red.size() <= 80);

constexpr std::array<std::string_view, 12> Known = { "guide", "plate", "implant", "transplant",
  "mitre-guide", "bone", "fragment", "group", "crumb", "segment", "reduction", "part" };

} // namespace

bool IsPartName(std::string_view name)
{
  const std::string_view word = name.substr(0, name.find(' '));
  const std::string_view number = name.substr(std::min(word.size() + 1, name.size()));
  return std::find(Known.begin(), Known.end(), word) != Known.end() && number.size() <= 6 &&
         number.find_first_not_of("0123456789") == number.npos && !name.ends_with(' ');
}

void ValidatePartLabel(const PartLabel& label)
{
  if (!label.name.empty() && !IsPartName(label.name))
    throw std::invalid_argument("the part's name is none that files may hold: a word such as "
                                "\"fragment\", with or without a number");
  const bool digits = label.hash.find_first_not_of("0123456789abcdef") == label.hash.npos;
  if (!label.hash.empty() && !(digits && label.hash.size() >= 16 && label.hash.size() <= 64))
    throw std::invalid_argument("the part's hash has " + std::to_string(label.hash.size()) +
                                " characters, must be 16 to 64 of 0-9 and a-f");
}

std::string PartText(const PartLabel& label)
{
  return std::string(Maker) + (label.doesNotHold ? std::string(Red) : "") +
         (label.hash.empty() ? "" : "; HASH=" + label.hash) +
         (label.name.empty() ? "" : "; PART=" + label.name);
}

std::string PartText(const PartLabel& label, std::size_t most)
{
  PartLabel fits = label;
  fits.hash.resize(std::min<std::size_t>(fits.hash.size(), 16));
  if (PartText(fits).size() > most)
    fits.name.clear();
  if (PartText(fits).size() > most)
    fits.hash.clear();
  return PartText(fits);
}

} // namespace hasp
