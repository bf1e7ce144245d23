#include "UseText.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <numeric>

namespace hasp
{
namespace
{

/// Letters to insert, delete or change until one word is the other (Levenshtein).
std::size_t EditDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t corner = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t change = corner + (a[i] == b[j] ? 0 : 1);
      corner = row[j + 1];
      row[j + 1] = std::min({ change, row[j] + 1, row[j + 1] + 1 });
    }
  }
  return row.back();
}

std::vector<std::string> Verbs(const CLI::App& app)
{
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands(nullptr))
    names.push_back(verb->get_name());
  return names;
}

std::vector<std::string> Options(const CLI::App& verb)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  return names;
}

std::string List(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
    list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::string Positions(const CLI::App& verb)
{
  std::string names;
  for (const CLI::Option* option : verb.get_options())
    if (option->get_positional())
      names += " " + option->get_name(true);
  return names.empty() ? "no file without an option's name" : "only" + names;
}

std::string ExtraText(const std::vector<std::string>& extras, const CLI::App& asked,
  const std::vector<std::string>& words)
{
  const std::string extra = extras.empty() ? std::string() : extras.front();
  const auto at = std::find_if(
    words.begin(), words.end(), [&](const std::string& word) { return word.starts_with(extra); });
  const std::string place = extra.empty() || at == words.end()
                              ? "a word"
                              : "word " + std::to_string(at - words.begin() + 1);
  if (extra.starts_with("-"))
    return place + " is no option of " + asked.get_name() +
           DidYouMean(extra.substr(0, extra.find('=')), Options(asked));
  return place + " is one too many: " + asked.get_name() + " takes " + Positions(asked) +
         "; names with blanks need quotes";
}

/// The option that CLI11's text speaks of: it stands before any word of the user's. Of two names
/// there, --head and --head-prediction, the longer.
const CLI::Option* OptionOf(const CLI::App& asked, const std::string& text)
{
  const CLI::Option* found = nullptr;
  std::size_t first = text.npos;
  for (const CLI::Option* option : asked.get_options())
  {
    const auto at = text.find(option->get_name());
    if (at < first ||
        (found && at == first && option->get_name().size() > found->get_name().size()))
    {
      first = at;
      found = option;
    }
  }
  return found;
}

/// "3 numbers in [0 - 1], commas between"; "{mono,left}".
std::string TakenBy(const CLI::Option& option)
{
  const std::string type = option.get_type_name();
  const auto colon = type.find(':');
  const std::string limits = colon == type.npos ? std::string() : type.substr(colon + 1);
  if (limits.starts_with("{"))
    return "one of " + limits;
  const int count = option.get_items_expected_min();
  const bool text = type.find("TEXT") != type.npos, whole = type.find("INT") != type.npos;
  std::string taken = text ? "value" : whole ? "whole number" : "number";
  taken = count > 1 ? std::to_string(count) + " " + taken + "s" : "a " + taken;
  if (!limits.empty())
    taken += " " + limits;
  return count > 1 ? taken + ", commas between" : taken;
}

} // namespace

std::string DidYouMean(const std::string& word, const std::vector<std::string>& known)
{
  const std::string* nearest = nullptr;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1; // farther is no slip
  for (const std::string& name : known)
  {
    const bool begun = word.size() > 3 && name.starts_with(word);
    if (const std::size_t distance = begun ? 1 : EditDistance(word, name); distance < least)
    {
      least = distance;
      nearest = &name;
    }
  }
  return nearest ? "; did you mean " + *nearest + "?" : std::string();
}

std::string UnknownVerb(const CLI::App& app, const std::vector<std::string>& words)
{
  const std::vector<std::string> verbs = Verbs(app);
  if (words.empty() || words.front().starts_with("-") ||
      std::find(verbs.begin(), verbs.end(), words.front()) != verbs.end())
    return {};
  return "unknown verb" + DidYouMean(words.front(), verbs) + "; known are " + List(verbs);
}

std::string UseText(
  const CLI::App& app, const std::vector<std::string>& words, const CLI::Error& error)
{
  if (words.empty())
    return "no verb is given; known are " + List(Verbs(app)) + "; see hasp --help";
  const bool verb = !words.front().starts_with("-");
  const CLI::App& asked = verb ? *app.get_subcommand(words.front()) : app;
  const std::string help =
    verb ? "; see hasp " + words.front() + " --help" : std::string("; see hasp --help");
  const bool lacks = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  const std::vector<std::string> extras = app.remaining(true);
  // What is lacking may be there, misspelt.
  if (dynamic_cast<const CLI::ExtrasError*>(&error) || (lacks && !extras.empty()))
    return ExtraText(extras, asked, words) + help;
  // These speak of options alone.
  if (lacks || dynamic_cast<const CLI::RequiresError*>(&error) ||
      dynamic_cast<const CLI::ExcludesError*>(&error))
    return std::string(error.what()) + help;
  if (const CLI::Option* option = OptionOf(asked, error.what()))
    return option->get_name() + " takes " + TakenBy(*option) + help;
  return "this cannot be understood" + help;
}

} // namespace hasp
