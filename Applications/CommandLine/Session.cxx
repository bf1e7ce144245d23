#include "Session.h"

#include "Explain.h"
#include "Failure.h"
#include "vtkHaspFileNames.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <iostream>

namespace hasp
{

namespace
{

std::string Text(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

/// What --explain and --json ask for.
void PrintResult(Session& session)
{
  session.progress.Wipe();
  if (session.explain && !session.json)
    std::cout << ExplainTable(session.resources);
  if (!session.json)
    return;
  if (session.explain)
    session.result["resources"] = ExplainJson(session.resources);
  // Names in files need not be UTF-8; what is not is replaced, so that the document always parses.
  std::cout << session.result.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
            << "\n";
}

} // namespace

Session::Session() : progress(std::cerr) {}

void AddTextOptions(CLI::App& verb, Session& session)
{
  verb.add_flag("--quiet", session.quiet, "No progress and no warnings; errors are still said");
  verb.add_flag("--show-names", session.showNames,
    "Say files' names in texts and results; they may hold a patient's");
}

void AddCommonOptions(CLI::App& verb, Session& session)
{
  AddTextOptions(verb, session);
  verb.add_flag("--explain", session.explain,
    "List what was built and what was skipped, with bytes and milliseconds");
  verb.add_flag("--json", session.json, "Print results (and --explain) as one JSON document");
}

CLI::Validator Within(double least, double most)
{
  const std::string range =
    "in [" + Text(least) + " - " + Text(most) + "]"; // as CLI::Range says it
  return { [least, most, range](std::string& given)
    {
      double value = 0.0;
      const bool number = CLI::detail::lexical_cast(given, value);
      return number && value >= least && value <= most ? std::string() : given + " is not " + range;
    },
    range };
}

void SayWarning(Session& session, const std::string& text)
{
  if (session.sayWarning)
    return session.sayWarning(text);
  session.progress.Wipe();
  if (!session.quiet)
    std::cerr << "hasp: warning: " << text << std::endl;
}

void ShowProgress(Session& session, vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&session.progress);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* progress, void*)
    {
      static_cast<ProgressLine*>(progress)->Share(
        static_cast<vtkAlgorithm*>(caller)->GetProgress());
    });
  algorithm->AddObserver(vtkCommand::ProgressEvent, command);
}

void RunSession(Session& session)
{
  ShowFileNames(session.showNames);
  session.progress.SetStyle(session.quiet ? ProgressLine::Style::Quiet : StyleOfStderr());
  try
  {
    session.run();
  }
  catch (const Failure& failure)
  {
    if (failure.code == ExitCode::FailedCheck || session.resultStands) // the result says why
      PrintResult(session);
    throw;
  }
  PrintResult(session);
}

} // namespace hasp
