#include "CommandLine.h"

#include "Failure.h"
#include "Files.h"
#include "Session.h"
#include "Verbs.h"
#include "Version.h"
#include "VtkMessages.h"

#include "Grid/Progress.h"

#include <CLI/CLI.hpp>

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
  app.footer("hasp VERB --help says more, with examples.\n\n"
             "Exit codes: 0 done; 1 wrong use (options, output place); 2 bad input (missing or "
             "broken file);\n            3 a check failed; 4 cannot draw (no OpenGL).");
  app.set_version_flag("--version", VersionText(), "Version and commit");
  app.get_formatter()->column_width(34);
  app.require_subcommand(1);
}

/// CLI11 calls an unknown verb an unexpected argument; say what it is.
std::string UseText(
  const CLI::App& app, const std::vector<std::string>& words, const CLI::Error& error)
{
  if (words.empty() || words.front().starts_with("-"))
    return std::string(error.what()) + "; see hasp --help";
  std::string known;
  for (const CLI::App* verb : app.get_subcommands(nullptr))
  {
    if (verb->get_name() == words.front())
      return std::string(error.what()) + "; see hasp " + words.front() + " --help";
    known += (known.empty() ? "" : ", ") + verb->get_name();
  }
  return "unknown verb '" + BaseName(words.front()) + "'; known are " + known;
}

int Complain(Session& session, ExitCode code, const std::string& text)
{
  session.progress.Wipe();
  std::cerr << "hasp: " << WithoutFolders(text, session.words) << "\n";
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
    return Complain(session, ExitCode::BadInput, error.what());
  }
}

} // namespace

int RunCommandLine(int count, char** arguments)
{
  Session session;
  session.words.assign(arguments + 1, arguments + count);
  CaptureVtkMessages();
  CLI::App app("", "hasp");
  Describe(app);
  AddVerbs(app, session);
  try
  {
    app.parse(count, arguments);
  }
  catch (const CLI::Success& help) // --help, --version
  {
    return Printed(session, app.exit(help));
  }
  catch (const CLI::Error& error)
  {
    return Complain(session, ExitCode::WrongUse, UseText(app, session.words, error));
  }
  return Printed(session, Run(session));
}

} // namespace hasp
