#include "PassportText.h"
#include "Session.h"
#include "Verbs.h"
#include "VolumeInput.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace hasp
{
namespace
{

struct InfoOptions
{
  std::string input;
  int series = 0;
};

void Run(const InfoOptions& options, Session& session)
{
  const LoadedVolume volume = ReadVolume(options.input, options.series, session);
  session.progress.Wipe();
  if (session.json)
    session.result["passport"] = PassportJson(volume.passport);
  else
    std::cout << PassportText(volume.passport);
}

} // namespace

void AddInfoVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<InfoOptions>();
  CLI::App* verb = app.add_subcommand("info", "Check a volume and print its passport");
  verb->add_option("IN", options->input, "Volume: a file, or a folder of slices")->required();
  verb->add_option(
    "--series", options->series, "Which DICOM series, from 1, where there are several");
  AddCommonOptions(*verb, session);
  verb->footer(
    "The passport holds size, place, orientation, values and warnings, and nothing of the "
    "patient.\nExamples:\n"
    "  hasp info head.mha\n"
    "  hasp info slices/ --series 2 --json\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
