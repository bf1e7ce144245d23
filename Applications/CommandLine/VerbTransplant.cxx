#include "Files.h"
#include "MitreGuide.h"
#include "RecipePart.h"
#include "Session.h"
#include "TransplantText.h"
#include "VerbWork.h"
#include "Verbs.h"
#include "Version.h"
#include "VolumeInput.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspGuideFilter.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Planning/GuideRecipeFile.h"
#include "Planning/TransplantRecipeFile.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

namespace hasp
{
namespace
{

struct TransplantOptions
{
  VolumeChoices volume;
  std::string donor, recipe, labels, output;
  int label = 1;
  bool noGuide = false;
};

constexpr const char* GuideFile = "mitre-guide.stl";
constexpr const char* GuideRecipeName = "mitre-guide.json";

struct MadeGuide
{
  GuideRecipe recipe;
  vtkSmartPointer<vtkPolyData> surface;
};

MadeTransplant Make(const TransplantOptions& options, const TransplantRecipe& recipe,
  vtkImageData* recipient, vtkImageData* donor, Session& session)
{
  BoneImage jaw{ ViewImage(recipient), {}, options.label };
  vtkSmartPointer<vtkImageData> labels;
  if (!options.labels.empty())
  {
    labels = ReadOther(options.labels, session);
    jaw.labels = ViewImage(labels);
  }
  session.progress.Step("cutting the jaw and the donor");
  const auto progress = [&session](double share)
  {
    session.progress.Share(share);
    return true;
  };
  const auto start = std::chrono::steady_clock::now();
  MadeTransplant made = Try(ExitCode::BadInput, "",
    [&] {
      return MakeTransplant(jaw, { ViewImage(donor), {}, 1 }, recipe, progress);
    });
  const double spent = MillisecondsSince(start);
  std::size_t bytes = 0;
  for (const PlacedSegment& segment : made.segments)
    bytes += 2 * (segment.mesh.points.size() * sizeof(glm::dvec3) +
                   segment.mesh.triangles.size() * sizeof(glm::uvec3));
  session.resources.push_back({ "segments", bytes, spent, "cut from the donor" });
  return made;
}

std::optional<MadeGuide> MakeGuide(const TransplantOptions& options, const TransplantRecipe& recipe,
  vtkImageData* donor, MadeTransplant& made, Session& session)
{
  if (options.noGuide)
  {
    session.resources.push_back({ "mitre guide", 0, 0.0, "--no-guide" });
    return std::nullopt;
  }
  const MitreGuide guide = Try(ExitCode::BadInput, "",
    [&] {
      return MakeMitreGuideRecipe(made.plan, ViewImage(donor), recipe.donorIsovalue, recipe.guide);
    });
  made.warnings.insert(made.warnings.end(), guide.warnings.begin(), guide.warnings.end());
  vtkNew<vtkHaspGuideFilter> filter;
  filter->SetRecipe(guide.recipe);
  filter->SetInputData(donor);
  return MadeGuide{ guide.recipe, RunPartFilter(filter, "mitre guide", session) };
}

/// All files, or none.
void Write(const TransplantOptions& options, const MadeTransplant& made,
  const std::optional<MadeGuide>& guide, const nlohmann::ordered_json& measures, Session& session)
{
  const auto write = [&, hash = HashOfFile(options.recipe)](const std::string& pendingName)
  {
    const std::filesystem::path folder = std::filesystem::u8path(pendingName);
    std::filesystem::create_directory(folder);
    const auto mesh = [&](const TriangleMesh& surface, const std::string& name, PartLabel label)
    {
      label.hash = hash;
      WriteSurface(MakePolyData(surface), (folder / name).string(), label);
    };
    for (std::size_t n = 0; n < made.segments.size(); ++n)
    {
      const PartLabel label{ .name = "segment " + std::to_string(n + 1), .hash = {} };
      mesh(made.segments[n].mesh, SegmentFile(n), label);
      mesh(made.onDonor[n], DonorSegmentFile(n), label);
    }
    for (const BoneFragment& fragment : made.recipient.fragments)
      if (IsStump(fragment))
        mesh(fragment.mesh, StumpFile(fragment),
          { .name = "fragment " + std::to_string(fragment.number), .hash = {} });
    if (guide)
    {
      const std::string recipe = (folder / GuideRecipeName).string();
      WriteBytes(FormatGuideRecipe(guide->recipe), recipe);
      WriteSurface(guide->surface, (folder / GuideFile).string(),
        { .name = "guide", .hash = HashOfFile(recipe) });
    }
    WriteBytes(measures.dump(2) + "\n", (folder / "measures.json").string());
  };
  session.progress.Step("writing the transplant");
  Try(ExitCode::WrongUse, "",
    [&] { WriteInspected(options.output, write, [](const std::string&) {}); });
}

nlohmann::ordered_json Describe(const MadeTransplant& made, const std::optional<MadeGuide>& guide)
{
  nlohmann::ordered_json json = DescribeTransplant(made);
  if (guide)
    json["guide"] = { { "file", GuideFile }, { "recipe", GuideRecipeName },
      { "slots", guide->recipe.slots.size() }, { "pins", guide->recipe.holes.size() } };
  json["program"] = std::string("hasp ") + Version() + ", commit " + Commit();
  json["intended_use"] = "research use only, not a medical device";
  return json;
}

void Run(const TransplantOptions& options, Session& session)
{
  RequireWritableFolder(options.output);
  const TransplantRecipe recipe = ReadRecipeFile(options.recipe, ReadTransplantRecipe);
  const LoadedVolume recipient = ReadVolume(options.volume, session);
  SayWarnings(recipient.passport, session);
  const vtkSmartPointer<vtkImageData> donor =
    options.donor.empty() ? recipient.image : ReadOther(options.donor, session);
  MadeTransplant made = Make(options, recipe, recipient.image, donor, session);
  const std::optional<MadeGuide> guide = MakeGuide(options, recipe, donor, made, session);
  const nlohmann::ordered_json measures = Describe(made, guide);
  Write(options, made, guide, measures, session);
  session.progress.Wipe();
  for (const std::string& warning : made.warnings)
    SayWarning(session, warning);
  if (!session.json)
  {
    PrintTransplant(made);
    if (guide)
      std::cout << Line("mitre guide  %zu slots, %zu pins\n", guide->recipe.slots.size(),
        guide->recipe.holes.size());
  }
  session.result["output"] = FileLabel(options.output);
  session.result.update(measures);
}

} // namespace

void AddTransplantVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<TransplantOptions>();
  CLI::App* verb =
    app.add_subcommand("transplant", "Fill a defect of the jaw with segments of a fibula");
  AddVolumeOptions(*verb, options->volume);
  verb->add_option("--donor", options->donor, "The donor's scan, if it is another one");
  verb->add_option("--recipe", options->recipe, "The .json file that says what to make")
    ->required();
  verb->add_option("--output", options->output, "A folder that is not there yet, or empty")
    ->required();
  verb->add_option(
    "--labels", options->labels, "Labels of IN's grid: its bone is what has the --label, too");
  verb->add_option("--label", options->label, "The bone's value in --labels")
    ->check(CLI::Range(1, 65535))
    ->capture_default_str();
  verb->add_flag("--no-guide", options->noGuide, "Leave the mitre guide out");
  AddCommonOptions(*verb, session);
  verb->footer("Example: hasp transplant head.mha --donor leg.mha --recipe plan.json --output set\n"
               "Writes segment-N.stl in the defect, donor-segment-N.stl on the donor, the jaw's\n"
               "fragment-N.stl, mitre-guide.stl and .json (for hasp certify) and measures.json.\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
