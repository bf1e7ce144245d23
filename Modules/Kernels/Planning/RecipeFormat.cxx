#include "Planning/RecipeFormat.h"

#include <stdexcept>

namespace hasp
{

namespace
{
/// What files of ours are, and what takes them.
struct FileKind
{
  const char *begin, *noun, *verb;
};
constexpr FileKind Kinds[] = { { "hasp-guide-recipe-", "a guide recipe", "hasp guide" },
  { "hasp-plate-recipe-", "a plate recipe", "hasp plate" },
  { "hasp-implant-recipe-", "an implant recipe", "hasp implant" },
  { "hasp-cut-recipe-", "a cut recipe", "hasp cut --cuts" },
  { "hasp-transplant-recipe-", "a transplant recipe", "hasp transplant" },
  { "hasp-segmentation-", "a segmentation recipe", "hasp segment --recipe" },
  { "hasp-seeds-", "seeds", "hasp segment --seeds" },
  { "hasp-plan-", "a plan", "hasp plan or hasp run" } };
} // namespace

void CheckFormat(
  const Json& json, const std::string& subject, std::initializer_list<const char*> formats)
{
  if (!json.is_object())
    return; // StrictJson says it
  if (!json.contains("format") || !json["format"].is_string())
    throw std::invalid_argument(
      subject + ": format " + (json.contains("format") ? "must be text" : "is missing"));
  const std::string format = json["format"].get<std::string>();
  std::string wanted;
  for (const char* one : formats)
  {
    if (format == one)
      return;
    wanted += (wanted.empty() ? "'" : " or '") + std::string(one) + "'";
  }
  const std::string who = subject + ": format is of another ";
  for (const FileKind& kind : Kinds)
    if (format.starts_with(kind.begin))
      throw std::invalid_argument(std::string(*formats.begin()).starts_with(kind.begin)
                                    ? who + "version, must be " + wanted
                                    : who + "kind: the file is " + kind.noun + ", which " +
                                        kind.verb + " takes; here it must be " + wanted);
  throw std::invalid_argument(who + "kind, must be " + wanted);
}

} // namespace hasp
