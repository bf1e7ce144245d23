#include "Failure.h"
#include "Files.h"
#include "PartFormats.h"
#include "PlanInput.h"
#include "RunImages.h"
#include "RunParts.h"
#include "Session.h"
#include "Verbs.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"

#include "Grid/ThreadLimit.h"

#include <CLI/CLI.hpp>

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
  std::string plan, output, format = "stl";
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
      Now(Document.history.Current())
  {
  }

  void Run()
  {
    this->TakeFromPlan();
    const auto write = [this](const std::string& pendingName)
    {
      const fs::path folder = fs::u8path(pendingName);
      fs::create_directory(folder);
      this->Images = ReadRunImages(this->Now, this->NeededImages(), this->Options.volumes,
        PlanFolder(this->Options.plan), folder, this->Shared);
      this->MakeMissing(folder);
      this->RefuseRed();
      const std::string run = RunInFormat(WriteParts(this->Now, this->Parts, folder, this->Shared),
        this->Options.format, folder, this->Shared);
      WriteBytes(run, (folder / "run.json").string());
      this->Keep(); // last: the folder is put in place if this is done
    };
    TryPlan(ExitCode::WrongUse,
      [&] { WriteInspected(this->Options.output, write, [](const std::string&) {}); });
    this->SayParts();
  }

private:
  /// Parts that are in date; what else there is to make has no bytes yet.
  void TakeFromPlan()
  {
    const std::string folder = PlanFolder(this->Options.plan);
    for (const PlanId object : PartObjects(this->Now))
    {
      PartFile file{ object, PartInputs(this->Now, object), {}, {}, true };
      const DerivedPart* part = PartInDate(this->Now, this->Document.parts, object);
      if (part && !part->report.empty() && !this->Options.rebuild)
        try
        {
          file.stl = ReadBlob(folder, part->bytes);
          file.report = ReadBlob(folder, part->report);
          file.made = false;
        }
        catch (const std::exception& error)
        {
          SayWarning(
            this->Shared, CalledObject(this->Now, object) + " is made anew: " + SafeText(error));
        }
      if (!file.made)
        this->Shared.resources.push_back(
          { CalledObject(this->Now, object), 0, 0.0, "in date: it was not made again" });
      this->Parts.push_back(std::move(file));
    }
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

  void MakeMissing(const fs::path& folder)
  {
    PlanRebuild rebuild(this->Now, this->Images.images);
    for (PartFile& part : this->Parts)
      if (part.made)
        part = MakePart(rebuild, this->Now, part.object, folder, this->Shared);
  }

  void RefuseRed()
  {
    std::vector<std::string> faults;
    for (const PartFile& part : this->Parts)
      for (const std::string& fault : FaultsOf(this->Now, part))
        faults.push_back(fault);
    if (faults.empty())
      return;
    if (!this->Options.force)
      throw FailedCheck("parts do not hold, nothing was kept (--force keeps them)", faults);
    for (const std::string& fault : faults)
      SayWarning(this->Shared, fault + "; it is kept, and its file says so (--force)");
  }

  void Keep()
  {
    if (!IsPlanFolder(this->Options.plan))
      return;
    for (const PartFile& part : this->Parts)
      if (part.made)
        KeepPart(this->Document.parts,
          { part.object, PartFormat::Stl, part.inputs, WriteBlob(this->Options.plan, part.stl),
            WriteBlob(this->Options.plan, part.report) });
    StorePlan(this->Options.plan, this->Document);
  }

  void SayParts()
  {
    nlohmann::ordered_json& list = this->Shared.result["parts"] = nlohmann::ordered_json::array();
    for (const PartFile& part : this->Parts)
    {
      const auto report = nlohmann::ordered_json::parse(part.report);
      list.push_back({ { "object", part.object }, { "made", part.made },
        { "file", fs::path(NameOfPart(this->Now, part.object))
                    .replace_extension(this->Options.format)
                    .string() },
        { "volume_mm3", report.at("volume_mm3") }, { "verdict", report.at("verdict") } });
      if (!this->Shared.json)
        std::cout << CalledObject(this->Now, part.object)
                  << (part.made ? "  made, " : "  in date, ") << report.at("volume_mm3").dump()
                  << " mm3, " << report.at("verdict").get<std::string>() << "\n";
    }
    this->Shared.result["output"] = FileLabel(this->Options.output);
  }

  const RunOptions& Options;
  Session& Shared;
  PlanDocument Document;
  const Plan& Now;
  std::vector<PartFile> Parts;
  RunImages Images;
};

void Run(const RunOptions& options, Session& session)
{
  RequireWritableFolder(options.output);
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
  verb->add_flag("--rebuild", options->rebuild, "Make parts that are in date, too");
  verb->add_flag("--force", options->force, "Keep parts that do not hold; their files say so");
  verb
    ->add_option(
      "--threads", options->threads, "At most so many; the bytes are the same; 0: one a core")
    ->check(CLI::Range(0, 1024));
  AddCommonOptions(*verb, session);
  verb->footer(
    "Example: hasp run case.hasp --volume head.mha --output parts\n"
    "Writes KIND-ID.stl (or as --format says; the plan keeps the .stl, which is what is "
    "certified),\n"
    "fragments that are moved as KIND-ID-planned.stl, too, transplants as\n"
    "transplant-ID-segment-N.stl and, on the donor, -donor-segment-N.stl, too, and run.json.\n"
    "The plan keeps what was made, and what is in date is not made again.\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input, 3 a part does not hold.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
