#include "Surfaces/SurfaceBuilder.h"

#include "Files/Words.h"

#include <stdexcept>

namespace hasp
{
namespace
{

constexpr std::string_view LettersAndDigits =
  "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

/// What follows `key` in the text, up to the first that is no letter or digit; empty without it.
/// "COLORSPACE=" is not "SPACE=".
std::string_view ValueOf(std::string_view text, std::string_view key)
{
  std::size_t at = text.find(key);
  while (at != 0 && at != text.npos && LettersAndDigits.find(text[at - 1]) != text.npos)
    at = text.find(key, at + 1);
  if (at == text.npos)
    return {};
  const std::string_view rest = text.substr(at + key.size());
  return rest.substr(0, rest.find_first_not_of(LettersAndDigits));
}

/// What the text says as PartText writes it.
PartLabel LabelIn(std::string_view text)
{
  PartLabel label;
  label.doesNotHold = text.find("; DOES NOT HOLD") != text.npos;
  label.hash = ValueOf(text, "HASH=");
  if (const std::size_t at = text.find("; PART="); at != text.npos)
  {
    const std::string_view rest = text.substr(at + 7);
    label.name = Trimmed(rest.substr(0, rest.find(';')));
  }
  return label;
}

} // namespace

void SurfaceNotes::TakeLabel(PartLabel said)
{
  this->label.doesNotHold |= said.doesNotHold;
  said.doesNotHold = false;
  try
  {
    ValidatePartLabel(said);
  }
  catch (const std::invalid_argument&)
  {
    return; // somebody else's words
  }
  if (!said.name.empty())
    this->label.name = said.name;
  if (!said.hash.empty())
    this->label.hash = said.hash;
}

void SurfaceNotes::Look(std::string_view text)
{
  if (const std::string_view space = ValueOf(text, "SPACE="); !space.empty())
  {
    this->lps |= IsWord(space, "lps");
    this->ras |= IsWord(space, "ras");
    this->otherSpace |= !IsWord(space, "lps") && !IsWord(space, "ras");
  }
  if (const std::size_t at = text.find("Hasp "); at != text.npos)
    this->TakeLabel(LabelIn(text.substr(at)));
  ToInteger(ValueOf(text, "POINTS="), this->points);
  ToInteger(ValueOf(text, "TRIANGLES="), this->triangles);
}

} // namespace hasp
