#include "CommandLine.h"

#include "Failure.h"
#include "Session.h"
#include "UseText.h"
#include "Verbs.h"
#include "Version.h"
#include "VtkMessages.h"

#include "Grid/Progress.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <stdexcept>

namespace hasp
{
namespace
{

constexpr const char* Notice = "Research use only, not a medical device.";

std::string VersionText()
{
  return std::string("hasp ") + Version() + " (commit " + Commit() + ")\n" + Notice;
}

void Describe(CLI::App& app)
{
  app.description(std::string("Haptics-assisted surgery planning. ") + Notice);
  app.footer("hasp VERB --help, or hasp help VERB, says more, with examples.\n\n"
             "Exit codes: 0 done; 1 wrong use (options, output place); 2 bad input (missing or "
             "broken file);\n            3 a check failed; 4 cannot draw (no OpenGL).");
  app.set_version_flag("--version", VersionText(), "Version and commit");
  app.get_formatter()->column_width(34);
  app.require_subcommand(1);
}

/// "help render" is "render --help".
std::vector<std::string> Words(int count, char** arguments)
{
  std::vector<std::string> words(arguments + std::min(count, 1), arguments + count);
  if (words.empty() || words.front() != "help")
    return words;
  words.erase(words.begin());
  words.resize(std::min<std::size_t>(words.size(), 1));
  words.push_back("--help");
  return words;
}

int Complain(Session& session, ExitCode code, const std::string& text)
{
  session.progress.Wipe();
  std::cerr << "hasp: " << text << "\n";
  return static_cast<int>(code);
}

/// Nobody may take the missing half of a result for the whole.
int Printed(Session& session, int code)
{
  if (std::cout.flush() || code != static_cast<int>(ExitCode::Ok))
    return code;
  return Complain(session, ExitCode::WrongUse,
    "standard output cannot be written to; the result was not printed whole");
}

int Run(Session& session)
{
  try
  {
    RunSession(session);
    return static_cast<int>(ExitCode::Ok);
  }
  catch (const Failure& failure)
  {
    return Complain(session, failure.code, failure.what());
  }
  catch (const std::bad_alloc&)
  {
    return Complain(session, ExitCode::BadInput, "out of memory; try a smaller volume or picture");
  }
  catch (const std::exception& error)
  {
    return Complain(session, ExitCode::BadInput, SafeText(error));
  }
}

} // namespace

int RunCommandLine(int count, char** arguments)
{
  Session session;
  const std::vector<std::string> words = Words(count, arguments);
  const VtkMessageCapture capture(
    [&session](const std::string& text) { SayWarning(session, text); });
  CLI::App app("", "hasp");
  Describe(app);
  AddVerbs(app, session);
  if (const std::string complaint = UnknownVerb(app, words); !complaint.empty())
    return Complain(session, ExitCode::WrongUse, complaint);
  try
  {
    app.parse(
      std::vector<std::string>(words.rbegin(), words.rend())); // it takes them from the back
  }
  catch (const CLI::Success& help) // --help, --version
  {
    return Printed(session, app.exit(help));
  }
  catch (const CLI::Error& error)
  {
    return Complain(session, ExitCode::WrongUse, UseText(app, words, error));
  }
  return Printed(session, Run(session));
}

} // namespace hasp
