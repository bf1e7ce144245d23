#include "Failure.h"
#include "Files.h"
#include "KeptParts.h"
#include "PartFormats.h"
#include "PartReport.h"
#include "PlanInput.h"
#include "RunCertificate.h"
#include "RunFaults.h"
#include "RunImages.h"
#include "RunLabels.h"
#include "RunParts.h"
#include "Session.h"
#include "VerbWork.h"
#include "Verbs.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"

#include "Grid/ThreadLimit.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <set>

namespace hasp
{
namespace
{

namespace fs = std::filesystem;

struct RunOptions
{
  std::string plan, output, html, format = "stl";
  std::vector<std::string> volumes;
  bool rebuild = false, force = false;
  int threads = 0;
};

/// A run under way.
class PlanRun
{
public:
  PlanRun(const RunOptions& options, Session& session)
    : Options(options),
      Shared(session),
      Document(OpenPlan(options.plan)),
      Now(Document.history.Current()),
      Pages{ options.html,
        options.force ? "It was forced: the part is kept although it does not hold, and its file "
                        "says so."
                      : "The part was not kept." }
  {
  }

  void Run()
  {
    this->TakeFromPlan();
    const auto write = [this](const std::string& pendingName)
    {
      const fs::path folder = fs::u8path(pendingName);
      fs::create_directory(folder);
      this->Images =
        ReadScans(this->Now, this->NeededImages(), this->Options.volumes, this->Shared);
      AddLabelMaps({ this->Document, this->Options.plan, folder, this->Options.rebuild },
        this->Parts, this->Images, this->Faults, this->Shared);
      this->MakeMissing(folder);
      this->FindFaults();
      this->KeepGood();
      this->Faults.Refuse(this->Parts.size(), IsPlanFolder(this->Options.plan));
      WriteRun(this->Now, this->Parts, this->Options.format, folder, this->Shared);
    };
    Try(ExitCode::WrongUse, "",
      [&] { WriteInspected(this->Options.output, write, [](const std::string&) {}); });
    SayLabelMaps(this->Shared);
    this->SayParts();
  }

private:
  /// Parts that are in date; what else there is to make has no bytes yet.
  void TakeFromPlan()
  {
    const KeptParts kept{ this->Document, PlanFolder(this->Options.plan), this->Options.rebuild,
      !this->Options.html.empty() };
    for (const PlanId object : PartObjects(this->Now))
      this->Parts.push_back(TakePart(kept, object, this->Shared));
    if (this->Parts.empty())
      throw Failure(ExitCode::BadInput, "the plan: nothing is made of it: it has no fragment, "
                                        "guide or other object that parts are made of");
  }

  std::set<PlanId> NeededImages() const
  {
    std::set<PlanId> needed;
    for (const PartFile& part : this->Parts)
      if (part.made)
        for (const PlanId image : ImagesOf(this->Now, part.object))
          needed.insert(image);
    return needed;
  }

  /// What cannot be made is no reason not to make the others.
  void MakeMissing(const fs::path& folder)
  {
    if (!this->Pages.folder.empty())
      fs::create_directory(this->Pages.folder);
    PlanRebuild rebuild(this->Now, this->Images.images);
    for (PartFile& part : this->Parts)
      if (part.made && !this->Faults.Has(part.object)) // for want of a label map
        try
        {
          part = MakePart(rebuild, this->Now, part.object, folder, this->Pages, this->Shared);
        }
        catch (const Cancelled&)
        {
          throw;
        }
        catch (const Failure& failure)
        {
          this->Faults.Add(this->Now, part.object, failure.code, failure.what());
        }
        catch (const std::exception& error) // such as memory, or the disk
        {
          this->Faults.Add(this->Now, part.object, ExitCode::BadInput, SafeText(error));
        }
  }

  void FindFaults()
  {
    for (const PartFile& part : this->Parts)
    {
      if (this->Faults.Has(part.object))
        continue;
      for (const std::string& fault : FaultsOf(this->Now, part))
        if (this->Options.force)
          SayWarning(this->Shared, fault + "; it is kept, and its file says so (--force)");
        else
          this->Faults.Add(this->Now, part.object, ExitCode::FailedCheck, fault);
      for (const std::string& warning :
        WarningsOf(ReadPartReport(part.report), CalledObject(this->Now, part.object)))
        SayWarning(this->Shared, warning);
    }
  }

  /// Whatever the others are.
  void KeepGood()
  {
    std::vector<PartFile> good;
    for (const PartFile& part : this->Parts)
      if (part.made && !this->Faults.Has(part.object))
        good.push_back(part);
    if (IsPlanFolder(this->Options.plan))
      try
      {
        KeepInPlan(this->Options.plan, good);
      }
      catch (const Failure& failure) // what is wrong with the parts is told, too
      {
        this->Faults.Add(failure);
      }
  }

  void SayParts()
  {
    nlohmann::ordered_json& list = this->Shared.result["parts"] = nlohmann::ordered_json::array();
    for (const PartFile& part : this->Parts)
    {
      const PartReport report = ReadPartReport(part.report);
      const std::string called = CalledObject(this->Now, part.object);
      list.push_back({ { "object", part.object }, { "made", part.made },
        { "file", fs::path(NameOfPart(this->Now, part.object))
                    .replace_extension(this->Options.format)
                    .string() },
        { "volume_mm3", report.volumeMm3 }, { "verdict", report.verdict } });
      if (!this->Shared.json)
        std::cout << called << (part.made ? "  made, " : "  in date, ")
                  << Line("%.1f mm3, ", report.volumeMm3) << VerdictOf(report) << "\n";
    }
    this->Shared.result["output"] = FileLabel(this->Options.output);
  }

  const RunOptions& Options;
  Session& Shared;
  PlanDocument Document;
  const Plan& Now;
  std::vector<PartFile> Parts;
  RunImages Images;
  PartPages Pages;
  RunFaults Faults;
};

void Run(const RunOptions& options, Session& session)
{
  RequireWritableFolder(options.output);
  if (IsPlanFolder(options.plan))
    RequireWritable((fs::path(options.plan) / "plan.json").string(), { ".json" });
  if (options.format == "3mf")
    RequireThreeMf();
  if (!options.html.empty())
  {
    RequireWritableFolder(options.html, "--html's folder");
    RequireDifferent(options.html, options.output, "--html and --output");
  }
  WithThreadLimit(options.threads, [&] { PlanRun(options, session).Run(); });
}

} // namespace

void AddRunVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<RunOptions>();
  CLI::App* verb = app.add_subcommand("run", "Make all parts of a plan anew");
  verb->add_option("PLAN", options->plan, "Its folder, NAME.hasp; plan.json alone is only read")
    ->required();
  verb->add_option(
    "--volume", options->volumes, "The scans, found by what they hold: files or folders");
  verb->add_option("--output", options->output, "A folder that is not there yet, or empty")
    ->required();
  AddFormatOption(*verb, options->format);
  verb->add_flag("--rebuild", options->rebuild, "Make parts and label maps that are in date, too");
  verb->add_flag("--force", options->force, "Keep parts that do not hold; their files say so");
  verb->add_option("--html", options->html,
    "A folder, likewise, for the certificates with pictures, KIND-ID.html, whether parts hold or "
    "not");
  verb
    ->add_option(
      "--threads", options->threads, "At most so many; the bytes are the same; 0: one a core")
    ->check(CLI::Range(0, 1024));
  AddCommonOptions(*verb, session);
  verb->footer(
    "Example: hasp run case.hasp --volume head.mha --output parts\n"
    "Writes KIND-ID.stl (or as --format says; the plan keeps the .stl, which is certified),\n"
    "KIND-ID-planned.stl of fragments that are moved, transplant-ID-segment-N.stl and, on the\n"
    "donor, -donor-segment-N.stl, KIND-ID.json, the recipes of certified parts, and run.json.\n"
    "What is in date is not made again; with --html what is certified is. If a part cannot be\n"
    "made or does not hold, no folder is written, but the plan keeps the others.\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 a part does not hold.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
