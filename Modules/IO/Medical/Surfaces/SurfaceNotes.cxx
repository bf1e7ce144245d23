#include "Surfaces/SurfaceBuilder.h"

#include "Files/Words.h"

namespace hasp
{
namespace
{

/// What follows `key` in the text, up to the first that is no letter or digit; empty without it.
std::string_view ValueOf(std::string_view text, std::string_view key)
{
  const std::size_t at = text.find(key);
  if (at == text.npos)
    return {};
  const std::string_view rest = text.substr(at + key.size());
  return rest.substr(0, rest.find_first_not_of("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                               "abcdefghijklmnopqrstuvwxyz"));
}

} // namespace

void SurfaceNotes::Look(std::string_view text)
{
  if (const std::string_view space = ValueOf(text, "SPACE="); !space.empty())
  {
    this->lps |= IsWord(space, "lps");
    this->ras |= IsWord(space, "ras");
    this->otherSpace |= !IsWord(space, "lps") && !IsWord(space, "ras");
  }
  ToInteger(ValueOf(text, "POINTS="), this->points);
  ToInteger(ValueOf(text, "TRIANGLES="), this->triangles);
}

} // namespace hasp
