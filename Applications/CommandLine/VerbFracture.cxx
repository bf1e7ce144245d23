#include "Failure.h"
#include "Files.h"
#include "FractureFolder.h"
#include "Session.h"
#include "VerbWork.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspVolumeView.h"

#include "Grid/Progress.h"
#include "Grid/ScannerFaults.h"
#include "Studies/FractureCases.h"

#include <CLI/CLI.hpp>

#include <array>
#include <iostream>
#include <memory>
#include <variant>

namespace hasp
{
namespace
{

struct FractureOptions
{
  VolumeChoices volume;
  std::string phantom = "mandible", output;
  double fineMm = 0.6, bone = CaseBoneHU;
  int fragments = 3, strokes = 0;
  std::array<double, 3> spacing{ 0.0, 0.0, 0.0 }, blur{ 0.0, 0.0, 0.0 };
  FractureCaseChoices choices;
};

struct IntactBone
{
  GridGeometry geometry;
  std::vector<std::int16_t> samples;
  FractureSettings pieces;
  std::vector<std::uint8_t> named; ///< empty: all bone
};

glm::dvec3 Vector(const std::array<double, 3>& v)
{
  return { v[0], v[1], v[2] };
}

ProgressFunction ShownBy(Session& session)
{
  return [&session](double share)
  {
    session.progress.Share(share);
    return true;
  };
}

IntactBone PhantomBone(const FractureOptions& options, Session& session)
{
  FractureCaseSettings settings;
  settings.spacingMm = options.fineMm;
  settings.seed = options.choices.seed;
  FractureCase broken = options.phantom == "head" ? BrokenHead(settings) : BrokenMandible(settings);
  std::vector<FracturePiece>& pieces = broken.settings.pieces;
  if (std::size_t(options.fragments) > pieces.size() + 1)
    throw Failure(ExitCode::WrongUse, "--fragments is " + std::to_string(options.fragments) +
                                        ", of this phantom 2 to " +
                                        std::to_string(pieces.size() + 1));
  pieces.resize(options.fragments - 1);
  session.progress.Step("making the phantom");
  IntactBone bone{ broken.geometry, {}, broken.settings, {} };
  bone.samples = IntactPhantom(bone.geometry, bone.pieces, ShownBy(session));
  return bone;
}

IntactBone ScannedBone(const FractureOptions& options, Session& session)
{
  const LoadedVolume volume = ReadVolume(options.volume, session);
  SayWarnings(volume.passport, session);
  RequireIsoValue(options.bone, volume.passport);
  IntactBone bone;
  std::visit(
    [&](const auto& view)
    {
      bone.geometry = view.geometry;
      bone.samples.resize(view.geometry.Size());
      for (std::size_t v = 0; v < bone.samples.size(); ++v)
        bone.samples[v] = RoundedSample(double(view.data[v]));
    },
    ViewImage(volume.image));
  bone.named =
    LargestBone(GridView<const std::int16_t>{ bone.samples.data(), bone.geometry }, options.bone);
  bone.pieces =
    ScatteredPieces(bone.geometry, bone.named, options.fragments - 1, options.choices.seed);
  return bone;
}

nlohmann::ordered_json Describe(const MadeFractureCase& made)
{
  auto fragments = nlohmann::ordered_json::array();
  for (const FractureCaseFragment& fragment : made.truth.fragments)
    fragments.push_back({ { "label", fragment.label }, { "name", fragment.name },
      { "voxels", fragment.voxelsFractured }, { "start_mean_mm", fragment.startMeanMm },
      { "start_max_mm", fragment.startMostMm } });
  return { { "fixed", made.truth.fixed }, { "fragments", std::move(fragments) } };
}

void Run(const FractureOptions& options, Session& session)
{
  RequireWritableFolder(options.output);
  FractureCaseChoices choices = options.choices;
  choices.spacingMm = Vector(options.spacing);
  choices.blurMm = Vector(options.blur);
  IntactBone bone =
    options.volume.input.empty() ? PhantomBone(options, session) : ScannedBone(options, session);
  bone.pieces.boneHU = options.bone;
  bone.pieces.crackHU = std::min(bone.pieces.crackHU, options.bone - 1.0);
  const auto start = std::chrono::steady_clock::now();
  session.progress.Step("breaking the bone");
  const MadeFractureCase made = Try(ExitCode::WrongUse, "",
    [&]
    {
      return MakeFractureCase(GridView<const std::int16_t>{ bone.samples.data(), bone.geometry },
        bone.pieces, bone.named, choices, ShownBy(session));
    });
  session.resources.push_back({ "case", 8 * made.truth.geometry.Size(), MillisecondsSince(start),
    "both scans, int16, and their labels, uint16" });
  session.progress.Step(options.strokes > 0 ? "drawing strokes" : "writing the case");
  WriteFractureFolder(made, options.strokes, options.output);
  session.progress.Wipe();
  session.result["output"] = FileLabel(options.output);
  session.result.update(Describe(made));
  if (!session.json)
    for (const FractureCaseFragment& fragment : made.truth.fragments)
      std::cout << Line("label %-3d %9llu voxels  off by %.2f mm, %.2f at most\n",
        int(fragment.label), static_cast<unsigned long long>(fragment.voxelsFractured),
        fragment.startMeanMm, fragment.startMostMm);
}

void AddDamageOptions(CLI::App& verb, FractureOptions& options)
{
  FractureCaseChoices& c = options.choices;
  verb.add_option("--fragments", options.fragments, "Of the bone that breaks, one stays in place")
    ->check(CLI::Range(2, 5))
    ->capture_default_str();
  verb.add_option("--shift", c.shiftMm, "How far each piece's middle goes, mm")
    ->check(Within(0.0, 60.0))
    ->capture_default_str();
  verb.add_option("--turn", c.turnDegrees, "By how much it turns about it, degrees")
    ->check(Within(0.0, 180.0))
    ->capture_default_str();
  verb.add_option("--crack", c.crackMm, "Bone that is lost between two faces, as to a saw, mm")
    ->check(Within(0.0, 10.0))
    ->capture_default_str();
  verb.add_option("--eroded", c.erodedMm, "What faces have lost besides, mm at most")
    ->check(Within(0.0, 10.0))
    ->capture_default_str();
  verb.add_option("--chips", c.lostChips, "Pieces that are lost at edges of fractures")
    ->check(CLI::Range(0, 20))
    ->capture_default_str();
  verb.add_option("--chip-size", c.chipMm, "How large they are, mm")
    ->check(Within(0.1, 15.0))
    ->capture_default_str();
  verb.add_option("--seed", c.seed, "Of moves, chips and noise, and of a scan's fractures")
    ->check(CLI::Range(std::uint64_t(0), std::uint64_t(1'000'000'000)))
    ->capture_default_str();
}

void AddScanOptions(CLI::App& verb, FractureOptions& options)
{
  verb.add_option("--spacing", options.spacing, "x,y,z in mm of the case's voxels; not finer")
    ->delimiter(',')
    ->check(Within(0.05, 50.0));
  verb.add_option("--blur", options.blur, "x,y,z: the scanner's blur besides, mm")
    ->delimiter(',')
    ->check(Within(0.0, 10.0));
  verb.add_option("--noise", options.choices.noiseHU, "Its noise's standard deviation")
    ->check(Within(0.0, 1000.0));
  CLI::Option* coneBeam =
    verb.add_flag("--cbct", options.choices.coneBeam, "Simulated cone beam: values that are no HU");
  verb
    .add_option("--strokes", options.strokes,
      "strokes.json, for hasp segment --seeds: of a simulated user, so many at most")
    ->excludes(coneBeam)
    ->check(CLI::Range(0, 100))
    ->capture_default_str();
}

} // namespace

void AddFractureVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<FractureOptions>();
  CLI::App* verb = app.add_subcommand("fracture", "Break a bone, with known truth, as a case");
  CLI::Option* scan = verb->add_option(
    "--volume", options->volume.input, "The scan, in HU, whose largest bone breaks");
  AddSeriesOptions(*verb, options->volume);
  verb->add_option("--bone", options->bone, "Bone is this and more, HU")
    ->check(Within(60.0, 3000.0))
    ->capture_default_str();
  verb->add_option("--phantom", options->phantom, "Without a scan: head or mandible")
    ->check(CLI::IsMember({ "head", "mandible" }))
    ->excludes(scan)
    ->capture_default_str();
  verb->add_option("--fine", options->fineMm, "The phantom's voxels, before --spacing, mm")
    ->check(Within(0.2, 2.0))
    ->excludes(scan)
    ->capture_default_str();
  AddDamageOptions(*verb, *options);
  AddScanOptions(*verb, *options);
  verb->add_option("--output", options->output, "A folder that is not there yet, or empty")
    ->required();
  AddCommonOptions(*verb, session);
  verb->footer(
    "Writes truth.json, fractured_ct.mha, fractured_labels.mha, intact_ct.mha, intact_labels.mha\n"
    "and plan.hasp, a plan to begin with (Formats.md#fracture-cases).\n"
    "Example: hasp fracture --fragments 3 --shift 3 --turn 5 --eroded 0.3 --output case\n"
    "Exit codes: 0 done, 1 wrong use, 2 bad input.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
