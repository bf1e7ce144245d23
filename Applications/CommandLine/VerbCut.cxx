#include "CutFiles.h"
#include "Failure.h"
#include "Files.h"
#include "FragmentCutter.h"
#include "PartFormats.h"
#include "RecipePart.h"
#include "Session.h"
#include "VerbWork.h"
#include "Verbs.h"
#include "Version.h"
#include "VolumeInput.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Planning/CutRecipeFile.h"

#include "vtkImageData.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

namespace hasp
{
namespace
{

struct CutOptions
{
  VolumeChoices volume;
  std::string cuts, labels, output, format = "stl";
  int label = 1;
  bool labelImage = false;
};

CutBone Cut(
  const CutOptions& options, const CutRecipe& recipe, vtkImageData* volume, Session& session)
{
  BoneImage bone{ ViewImage(volume), {}, options.label };
  vtkSmartPointer<vtkImageData> labels;
  if (!options.labels.empty())
  {
    labels = ReadOther(options.labels, session);
    bone.labels = ViewImage(labels);
  }
  session.progress.Step("cutting");
  const auto progress = [&session](double share)
  {
    session.progress.Share(share);
    return true;
  };
  const auto start = std::chrono::steady_clock::now();
  CutBone cut = Try(ExitCode::BadInput, "", [&] { return CutFragments(bone, recipe, progress); });
  const double spent = MillisecondsSince(start);
  std::size_t bytes = 0;
  for (const BoneFragment& fragment : cut.fragments)
    bytes += fragment.mesh.points.size() * sizeof(glm::dvec3) +
             fragment.mesh.triangles.size() * sizeof(glm::uvec3);
  session.resources.push_back({ "fragments", bytes, spent, "cut from the volume" });
  return cut;
}

nlohmann::ordered_json Describe(
  const CutBone& cut, const CutRecipe& recipe, const std::string& format)
{
  using Json = nlohmann::ordered_json;
  Json json{ { "bone_mm3", cut.boneMm3 }, { "unaccounted_share", cut.UnaccountedShare() },
    { "isovalue", recipe.isovalue }, { "spacing_mm", CutSpacing(recipe) },
    { "fragments", Json::array() }, { "cuts", Json::array() } };
  for (const BoneFragment& fragment : cut.fragments)
    json["fragments"].push_back({ { "number", fragment.number },
      { "file", NameOfFile(fragment, format) }, { "volume_mm3", fragment.volumeMm3 },
      { "center_mm", { fragment.center.x, fragment.center.y, fragment.center.z } },
      { "crumb", fragment.crumb }, { "resected", fragment.resected },
      { "triangles", fragment.mesh.triangles.size() } });
  for (const CutMeasure& measure : cut.cuts)
    json["cuts"].push_back({ { "area_mm2", measure.areaMm2 }, { "kerf_mm3", measure.kerfMm3 },
      { "left_mm2", measure.leftMm2 }, { "parted", measure.parted },
      { "front_mm3", measure.frontMm3 }, { "back_mm3", measure.backMm3 },
      { "front", measure.front }, { "back", measure.back } });
  json["program"] = std::string("hasp ") + Version() + ", commit " + Commit();
  json["intended_use"] = "research use only, not a medical device";
  return json;
}

void Print(const CutBone& cut)
{
  for (const BoneFragment& f : cut.fragments)
    std::cout << Line("%-9s %2d  %10.1f mm3 around (%.1f, %.1f, %.1f)%s\n",
      f.crumb ? "crumb" : "fragment", f.number, f.volumeMm3, f.center.x, f.center.y, f.center.z,
      f.resected ? ", resected" : "");
  for (std::size_t n = 0; n < cut.cuts.size(); ++n)
  {
    const CutMeasure& m = cut.cuts[n];
    std::cout << Line("cuts[%zu]  %10.1f mm2, takes %.1f mm3", n, m.areaMm2, m.kerfMm3);
    if (m.parted)
      std::cout << Line("; in front of it %.1f mm3, behind it %.1f mm3", m.frontMm3, m.backMm3);
    else
      std::cout << "; DOES NOT PART the bone: still one piece";
    if (m.leftMm2 > 0.0)
      std::cout << Line("; leaves %.1f mm2 that it reaches", m.leftMm2);
    std::cout << "\n";
  }
  std::cout << Line("bone      %10.1f mm3, %.4f %% of it not accounted for\n", cut.boneMm3,
    100.0 * cut.UnaccountedShare());
}

/// All files, or none.
void Write(const CutOptions& options, const CutBone& cut, const nlohmann::ordered_json& measures,
  vtkImageData* volume, Session& session)
{
  const auto write = [&](const std::string& pendingName)
  {
    const std::filesystem::path folder = std::filesystem::u8path(pendingName);
    std::filesystem::create_directory(folder);
    WriteFragments(folder, cut, options.format, HashOfFile(options.cuts));
    if (options.labelImage)
    {
      const GridGeometry grid = ImageGeometry(volume);
      std::vector<Segment> segments;
      for (const BoneFragment& fragment : cut.fragments)
      {
        const double turn = 0.381966 * fragment.number; // the golden angle: neighbours differ
        const auto shade = [&](double offset)
        { return 0.55 + 0.4 * std::cos(6.283185 * (turn + offset)); };
        segments.push_back({ fragment.number,
          (fragment.crumb ? "crumb " : "fragment ") + std::to_string(fragment.number),
          { shade(0.0), shade(1.0 / 3.0), shade(2.0 / 3.0) }, true });
      }
      const auto start = std::chrono::steady_clock::now();
      const std::vector<std::uint16_t> numbers = LabelFragments(cut.fragments, grid);
      session.resources.push_back({ "label image", numbers.size() * sizeof(numbers[0]),
        MillisecondsSince(start), "--label-image; written, then released" });
      WriteSegmentation(
        MakeImage(grid, numbers), segments, (folder / "fragments.seg.nrrd").string());
    }
    WriteBytes(measures.dump(2) + "\n", (folder / "measures.json").string());
  };
  session.progress.Step("writing the fragments");
  Try(ExitCode::WrongUse, "",
    [&] { WriteInspected(options.output, write, [](const std::string&) {}); });
}

void Run(const CutOptions& options, Session& session)
{
  RequireWritableFolder(options.output);
  if (options.format == "3mf")
    RequireThreeMf();
  const CutRecipe recipe = ReadRecipeFile(options.cuts, ReadCutRecipe);
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  const CutBone cut = Cut(options, recipe, volume.image, session);
  for (std::size_t n = 0; n < cut.cuts.size(); ++n)
    if (!cut.cuts[n].parted)
      SayWarning(session, "cuts[" + std::to_string(n) +
                            "] does not part the bone: what is on both of its sides is one piece, "
                            "resected or not; make its blade wider or deeper, or move it");
  const nlohmann::ordered_json measures = Describe(cut, recipe, options.format);
  if (!options.labelImage)
    session.resources.push_back({ "label image", 0, 0.0, "no --label-image was asked for" });
  Write(options, cut, measures, volume.image, session);
  session.progress.Wipe();
  if (!session.json)
    Print(cut);
  session.result["output"] = FileLabel(options.output);
  session.result.update(measures);
}

} // namespace

void AddCutVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<CutOptions>();
  CLI::App* verb = app.add_subcommand("cut", "Cut the bone of a CT into fragments");
  AddVolumeOptions(*verb, options->volume);
  verb->add_option("--cuts", options->cuts, "The .json file that says where")->required();
  verb->add_option("--output", options->output, "A folder that is not there yet, or empty")
    ->required();
  verb->add_option(
    "--labels", options->labels, "Labels of the same grid: bone is what has the --label, too");
  verb->add_option("--label", options->label, "The bone's value in --labels")
    ->check(CLI::Range(1, 65535))
    ->capture_default_str();
  AddFormatOption(*verb, options->format);
  verb->add_flag("--label-image", options->labelImage,
    "Write fragments.seg.nrrd, too: the fragment of each voxel");
  AddCommonOptions(*verb, session);
  verb->footer(
    "Example: hasp cut head.mha --cuts cuts.json --output fragments --label-image\n"
    "Writes fragment-N.stl, the largest first, crumb-N.stl and measures.json; as 3mf besides\n"
    "fragments.3mf, all that are kept as named objects of one file.\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
