#pragma once
#include "Grid/ResourceUse.h"
#include "ProgressLine.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace CLI
{
class App;
class Validator;
}
class vtkAlgorithm;

namespace hasp
{

/// What all verbs share: the common switches, progress, and what --explain and --json print.
struct Session
{
  Session();

  bool quiet = false;
  bool explain = false;
  bool json = false;
  bool showNames = false; ///< of files; folders are never shown
  ProgressLine progress;
  ResourceList resources;             ///< built and skipped, in the order of making
  nlohmann::ordered_json result = {}; ///< printed as one document by --json
  bool resultStands = false;          ///< print the result although the verb fails: it says why
  /// Hears warnings, of programs with a window: with this and progress.SetWatch nothing of the work
  /// is written to standard output or error. Empty: they are lines on standard error.
  std::function<void(const std::string&)> sayWarning{};
  std::function<void()> run; ///< the verb, once the command line is understood
};

/// Adds --quiet and --show-names to a verb.
void AddTextOptions(CLI::App& verb, Session& session);

/// Adds these, --explain and --json.
void AddCommonOptions(CLI::App& verb, Session& session);

/// Refuses what is no number in [least, most]. CLI::Range lets NaN through.
CLI::Validator Within(double least, double most);

/// A line on stderr, unless the session is quiet; or to who hears them.
void SayWarning(Session& session, const std::string& text);

/// Shows an algorithm's progress under the step that was begun last. The session outlives it.
void ShowProgress(Session& session, vtkAlgorithm* algorithm);

/// Runs the verb, then prints what --explain and --json ask for, also where a check failed. Throws
/// Failure.
void RunSession(Session& session);

} // namespace hasp
