#pragma once
#include "Grid/ResourceUse.h"
#include "ProgressLine.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

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
  ProgressLine progress;
  std::vector<std::string> words;     ///< of the command line: texts never show their folders
  ResourceList resources;             ///< built and skipped, in the order of making
  nlohmann::ordered_json result = {}; ///< printed as one document by --json
  std::function<void()> run;          ///< the verb, once the command line is understood
};

/// Adds --quiet, --explain and --json to a verb.
void AddCommonOptions(CLI::App& verb, Session& session);

/// Refuses what is no number in [least, most]. CLI::Range lets NaN through.
CLI::Validator Within(double least, double most);

/// Shows an algorithm's progress under the step that was begun last. The session outlives it.
void ShowProgress(Session& session, vtkAlgorithm* algorithm);

/// Runs the verb, then prints what --explain and --json ask for, also where a check failed. Throws
/// Failure.
void RunSession(Session& session);

} // namespace hasp
