#include "Window/PlannerOptions.h"

#include "Version.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

fs::path FromEnvironment(const char* name, const char* below)
{
  if (const char* value = std::getenv(name); value && *value)
    return fs::path(value);
  const char* home = std::getenv("HOME");
  return fs::path(home && *home ? home : ".") / below;
}

/// "1280x800"
QSize ReadSize(const std::string& text)
{
  int width = 0, height = 0;
  char end = 0;
  if (std::sscanf(text.c_str(), "%5dx%5d%c", &width, &height, &end) != 2 || width < 1 || height < 1)
    throw CLI::ConversionError(text, "--size");
  return { width, height };
}

void AddOptions(CLI::App& app, PlannerOptions& options)
{
  app.add_option("INPUT", options.inputs,
    "Scans (files or folders), surfaces, label maps, or a plan, NAME.hasp");
  app.add_option(
    "--plan", options.plan, "A plan: its folder, or its plan.json, which is only read");
  app.add_option(
    "--volume", options.volumes, "Where the plan's scans are: found by what they hold");
  app.add_option("--step", options.step, "The step that is shown")
    ->check(
      CLI::IsMember({ "import", "split", "reduce", "cut", "guide", "plate", "check", "export" }));
  app.add_flag("--make", options.make, "Make all parts that are not in date");
  app.add_option("--export", options.exportTo,
    "A folder for all parts, as hasp run --output writes it: the same bytes");
  app.add_option("--format", options.format, "Of exported parts")
    ->check(CLI::IsMember({ "stl", "3mf", "ply", "obj" }));
  app.add_option("--screenshot", options.screenshot, "A .png of the window, when all is drawn");
  app.add_flag("--exit", options.exit, "End when all that is done; nothing is asked");
  app.add_flag("--sample", options.sample, "Begin with the sample and a tour");
  app.add_flag("--explain", options.explain, "List what the scene uses, and what was left out");
  CLI::Option* study =
    app.add_option("--study", options.study, "Study mode: a folder of trials for hasp evaluate");
  app.add_option("--operator", options.studyOperator, "Who works, a pseudonym")->needs(study);
  app.add_option("--trial", options.trial, "The trial's number, from 1")
    ->needs(study)
    ->check(CLI::Range(1, 9999));
  CLI::Option* measure = app.add_option("--measure", options.measure,
    "Measure the window, write the figures into this file and end: hasp report planner");
  app.add_flag("--quick", options.quick, "Of these figures, in a minute")->needs(measure);
  app
    .add_option_function<std::string>(
      "--size", [&](const std::string& text) { options.size = ReadSize(text); },
      "Of the window, pixels: 1280x800; it is never smaller than what is in it")
    ->type_name("WIDTHxHEIGHT");
  app.add_option("--language", options.language, "Of the window: en, sv; else the system's");
  app.add_option("--device", options.device,
    "A recorded hand in place of a haptic device: it begins anew whenever a tool is taken");
  app.add_option("--layout", options.layout,
    "Keep this file's JSON up to date with what is on the screen: for tests and helps");
  app.add_option("--state", options.state,
    "Where the planner keeps its own files; default: $XDG_STATE_HOME/hasp-planner");
  app.add_option("--plans", options.plans, "Where plans are saved; default: ~/Hasp");
  app.add_flag("!--no-recover", options.recover, "Do not offer what a crash left; it stays");
}
} // namespace

bool ReadPlannerOptions(int argc, const char* const* argv, PlannerOptions& options, int& exitCode)
{
  CLI::App app(
    "Surgery planning: import a CT, split the bone, put it together, cut, and make guides "
    "and plates that fit.\nResearch use only, not a medical device.");
  app.set_version_flag(
    "--version", std::string("hasp-planner ") + Version() + ", commit " + Commit());
  app.footer(
    "Examples: hasp-planner head.mha\n"
    "          hasp-planner --plan case.hasp --volume head.mha --step guide --screenshot "
    "guide.png --exit\n"
    "Keys: ? in the window. Exit codes: 0 done, 1 wrong use, 2 bad input, 3 a part does not "
    "hold, 4 nothing can be drawn.");
  options.state = FromEnvironment("XDG_STATE_HOME", ".local/state") / "hasp-planner";
  options.plans = FromEnvironment("HASP_PLANS", "Hasp");
  AddOptions(app, options);
  try
  {
    app.parse(argc, argv);
    return true;
  }
  catch (const CLI::Success& asked) // --help, --version
  {
    exitCode = app.exit(asked);
  }
  catch (const CLI::ParseError&) // its text may be a patient's name: say none of it
  {
    std::cerr << "hasp-planner: there is a word that is not understood, or a number out of its "
                 "range; hasp-planner --help lists all options\n";
    exitCode = 1;
  }
  return false;
}

} // namespace hasp
