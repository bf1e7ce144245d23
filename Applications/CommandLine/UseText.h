#pragma once
#include <string>
#include <vector>

namespace CLI
{
class App;
class Error;
}

namespace hasp
{

/// Complaint about a first word that is neither verb nor option; empty if it is one.
std::string UnknownVerb(const CLI::App& app, const std::vector<std::string>& words);

/// What is wrong with a command line that CLI11 refused, and what to do. Says verbs, options and
/// the places of words, never the words themselves: they may be a patient's name.
std::string UseText(
  const CLI::App& app, const std::vector<std::string>& words, const CLI::Error& error);

/// ", did you mean render?" for a word near one of `known`, else empty.
std::string DidYouMean(const std::string& word, const std::vector<std::string>& known);

} // namespace hasp
