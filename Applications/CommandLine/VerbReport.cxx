#include "Failure.h"
#include "Files.h"
#include "ReportHtml.h"
#include "ReportJson.h"
#include "ReportRegistry.h"
#include "ReportTerms.h"
#include "ReportText.h"
#include "Session.h"
#include "UseText.h"
#include "Verbs.h"
#include "Version.h"

#include <CLI/CLI.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <set>

namespace hasp
{
namespace
{

struct ReportOptions
{
  std::vector<std::string> names;
  ReportSettings settings;
  std::string json;
  std::string html;
};

std::string KnownReports()
{
  std::string known;
  for (const ReportEntry& entry : ReportRegistry())
    known += std::string(entry.name) + ", ";
  return known + "all";
}

std::vector<const ReportEntry*> Chosen(const std::vector<std::string>& names)
{
  const auto named = [&](const std::string& name)
  { return std::find(names.begin(), names.end(), name) != names.end(); };
  std::vector<const ReportEntry*> chosen;
  std::set<std::string> known{ "all" };
  for (const ReportEntry& entry : ReportRegistry())
  {
    known.insert(entry.name);
    if (named("all") || named(entry.name)) // once, however often it is named
      chosen.push_back(&entry);
  }
  for (const std::string& name : names)
    if (!known.contains(name))
      throw Failure(ExitCode::WrongUse, "unknown report" +
                                          DidYouMean(name, { known.begin(), known.end() }) +
                                          "; known are " + KnownReports());
  return chosen;
}

/// Of the process, so far: in `all`, also of the reports before. What each resource holds is said
/// by its owner.
ReportRow PeakMemory(const std::string& report)
{
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  ReportRow row;
  row.id = report + ".memory.peak";
  row.value = double(use.ru_maxrss) / (1024.0 * 1024.0);
  row.unit = "GiB resident at most";
  row.better = Better::Lower;
  row.rival = "all methods of this report together";
  return row;
}

Report RunReport(const ReportEntry& entry, const ReportSettings& settings, Session& session)
{
  Report report;
  report.name = entry.name;
  report.version = Version();
  report.commit = Commit();
  report.machine = ThisMachine();
  report.seed = settings.seed;
  report.quick = settings.quick;
  report.terms = TermsOf(report.name);
  session.progress.Step("report " + report.name);
  ReportContext context{ report, settings,
    [&session](double share, const std::string& step)
    {
      if (!step.empty())
        session.progress.Step(step);
      session.progress.Share(share);
    } };
  entry.run(context);
  report.rows.push_back(PeakMemory(report.name));
  return report;
}

/// Text and page come out even if the figures do not hold: one must see them to mend them. JSON,
/// which programs trust, does not.
void Deliver(const ReportOptions& options, const std::vector<Report>& reports)
{
  for (const Report& report : reports)
    std::cout << ReportText(report);
  const std::vector<std::string> faults = ReportFaults(reports);
  if (!options.html.empty())
    WriteFile(options.html, ReportHtml(reports));
  if (!options.json.empty() && faults.empty())
    WriteFile(options.json, ReportJson(reports));
  if (faults.empty())
    return;
  throw FailedCheck("the report does not hold", faults);
}

void Run(const ReportOptions& options, Session& session)
{
  const auto chosen = Chosen(options.names);
  if (!options.json.empty())
    RequireWritable(options.json, { ".json" });
  if (!options.html.empty())
    RequireWritable(options.html, { ".html" });
  std::vector<Report> reports;
  for (const ReportEntry* entry : chosen)
    reports.push_back(RunReport(*entry, options.settings, session));
  session.progress.Wipe();
  Deliver(options, reports);
}

} // namespace

void AddReportVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<ReportOptions>();
  CLI::App* verb =
    app.add_subcommand("report", "Measure error against run time, stability, and what is unused");
  std::string names = "Reports: all";
  for (const ReportEntry& entry : ReportRegistry())
    names += std::string("\n") + entry.name + ": " + entry.summary;
  verb->add_option("NAME", options->names, names)->required();
  verb->add_flag("--quick", options->settings.quick, "Minutes at most; rows are marked quick");
  verb
    ->add_flag_function(
      "--soak{10000}",
      [options](std::int64_t frames)
      {
        options->settings.soak = true;
        options->settings.soakFrames = int(frames);
      },
      "Also what takes long: 2048^3 samples, a hundred million rays (hours), haptic loops beside "
      "rendering (20 minutes), a day of haptic ticks, and a walk of so many frames with a line of "
      "progress each 2 % (raycaching: 10000 frames take about half an hour)")
    ->check(CLI::Range(20, 10'000'000));
  verb->add_option("--seed", options->settings.seed, "Of every random case")->capture_default_str();
  options->settings.volume = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
  verb
    ->add_option("--volume", options->settings.volume,
      "A CT to measure on too, bone at 226: its rows end in @volume, those of the demo's, which "
      "Utilities/Scripts/cranium prints, in @cranium")
    ->capture_default_str();
  verb->add_option("--json", options->json, "Write the figures to this .json file");
  verb->add_option("--html", options->html, "Write tables and charts to this .html file");
  AddTextOptions(*verb, session);
  verb->footer("Example: hasp report stereo --quick --html stereo.html\n"
               "Exit code 3: a time without its error, a method without a rival, an id twice.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
