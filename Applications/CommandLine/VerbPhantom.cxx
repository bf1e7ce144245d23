#include "BrokenPhantom.h"
#include "Failure.h"
#include "Files.h"
#include "PhantomFile.h"
#include "Session.h"
#include "VerbWork.h"
#include "Verbs.h"
#include "vtkHaspFileNames.h"

#include <CLI/CLI.hpp>

#include <array>
#include <chrono>
#include <map>
#include <memory>
#include <stdexcept>

namespace hasp
{
namespace
{

struct PhantomOptions
{
  std::string output;
  std::array<double, 3> spacing{ 1.0, 1.0, 1.0 };
  std::array<int, 3> size{ 0, 0, 0 };
  std::string anatomy = "head";
  std::string flip;
  std::array<double, 3> blur{ 0.0, 0.0, 0.0 };
  bool intact = false;
  BrokenPhantomChoices broken;
  PhantomSettings settings;
};

PhantomSettings SettingsOf(const PhantomOptions& options)
{
  static const std::map<std::string, PhantomAnatomy> Anatomies{ { "head", PhantomAnatomy::Head },
    { "fibula", PhantomAnatomy::Fibula }, { "both", PhantomAnatomy::HeadAndFibula } };
  PhantomSettings settings = options.settings;
  settings.anatomy = Anatomies.at(options.anatomy);
  settings.defect = !options.intact;
  settings.blurMm = { options.blur[0], options.blur[1], options.blur[2] };
  return settings;
}

/// The same places, stored the other way round along the axes named by "i", "j", "k".
GridGeometry Flipped(GridGeometry grid, const std::string& axes)
{
  for (int a = 0; a < 3; ++a)
    if (axes.find("ijk"[a]) != std::string::npos)
    {
      grid.origin += (grid.dims[a] - 1) * grid.spacing[a] * grid.direction[a];
      grid.direction[a] = -grid.direction[a];
    }
  return grid;
}

GridGeometry GridOf(const PhantomOptions& options, const PhantomSettings& settings)
{
  const auto& size = options.size;
  const auto& spacing = options.spacing;
  const GridGeometry grid =
    size[0] > 0 ? PhantomGridOfSize({ size[0], size[1], size[2] }, settings)
                : PhantomGrid(glm::dvec3(spacing[0], spacing[1], spacing[2]), settings);
  return Flipped(grid, options.flip);
}

void RunBroken(const PhantomOptions& options, Session& session)
{
  const auto& spacing = options.spacing;
  if (spacing[0] != spacing[1] || spacing[0] != spacing[2])
    throw Failure(ExitCode::WrongUse, "--broken is of cubic voxels: one --spacing three times");
  BrokenPhantomChoices broken = options.broken;
  broken.output = options.output;
  broken.spacingMm = spacing[0];
  broken.seed = options.settings.seed;
  broken.coneBeam = options.settings.coneBeam.on;
  if (!broken.truth.empty())
  {
    RequireWritable(broken.truth, { ".nrrd", ".mha", ".nii", ".nii.gz", ".vti" });
    RequireDifferent(broken.truth, broken.output, "--truth and --output");
  }
  Try(ExitCode::WrongUse, "", [&] { WriteBrokenPhantom(broken, session); });
}

void Run(const PhantomOptions& options, Session& session)
{
  RequireWritable(options.output, { ".mha", ".nrrd", ".nii", ".nii.gz", ".vti" });
  if (!options.broken.which.empty())
    return RunBroken(options, session);
  try
  {
    const PhantomSettings settings = SettingsOf(options);
    const GridGeometry grid = GridOf(options, settings);
    const auto start = std::chrono::steady_clock::now();
    const std::size_t bytes = WritePhantomFile(grid, settings, options.output, session.progress);
    const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - start;
    session.resources.push_back({ "samples", bytes, spent.count(), "phantom, int16, at a time" });
    session.result["output"] = FileLabel(options.output);
    if (session.json)
      session.result.update(DescribePhantom(grid, settings));
  }
  catch (const std::exception& error)
  {
    throw Failure(ExitCode::WrongUse, SafeText(error));
  }
}

void AddGridOptions(CLI::App& verb, PhantomOptions& options)
{
  CLI::Option* spacing =
    verb.add_option("--spacing", options.spacing, "x,y,z in mm; one value each, may differ")
      ->delimiter(',')
      ->check(Within(0.05, 50.0))
      ->capture_default_str();
  verb.add_option("--size", options.size, "Samples along x,y,z in place of --spacing")
    ->delimiter(',')
    ->check(CLI::Range(2, 2048))
    ->excludes(spacing);
  verb
    .add_option("--flip", options.flip,
      "Store the axes named (of ijk) the other way round; everything stays at its place")
    ->check(CLI::IsMember({ "i", "j", "k", "ij", "ik", "jk", "ijk" }));
}

/// It has a scanner of its own: of others' options it takes spacing, seed and --cbct.
void AddFractureOptions(CLI::App& verb, PhantomOptions& options)
{
  CLI::Option* broken = verb
                          .add_option("--broken", options.broken.which,
                            "With fractures: head (six pieces) or mandible (five)")
                          ->check(CLI::IsMember({ "head", "mandible" }));
  verb
    .add_option("--truth", options.broken.truth,
      "Write which fragment each voxel is of, too: a .seg.nrrd file")
    ->needs(broken);
  verb.add_flag("--moved", options.broken.moved, "Its pieces are shifted and turned a little")
    ->needs(broken);
  for (const char* other : { "--anatomy", "--intact", "--size", "--flip", "--blur",
         "--slice-thickness", "--noise", "--grain", "--metal", "--field-radius" })
    broken->excludes(verb.get_option(other));
}

void AddScannerOptions(CLI::App& verb, PhantomOptions& options)
{
  PhantomSettings& s = options.settings;
  verb
    .add_option(
      "--blur", options.blur, "The scanner's point spread: standard deviations along x,y,z in mm")
    ->delimiter(',')
    ->check(Within(0.0, 10.0));
  verb.add_option("--slice-thickness", s.sliceMm, "In mm: each sample is a mean over it along z")
    ->check(Within(0.0, 20.0));
  verb.add_option("--noise", s.noiseHU, "Standard deviation of added noise, HU")
    ->check(Within(0.0, 1000.0))
    ->capture_default_str();
  verb.add_flag("--grain", s.grain, "Noise of neighbours in a slice is correlated");
  verb.add_option("--seed", s.seed, "Of noise and streaks")->capture_default_str();
  verb.add_flag("--metal", s.metal.on,
    "Metal crowns on a left and a right molar, with streaks and a dark band");
  verb.add_flag(
    "--cbct", s.coneBeam.on, "As a cone-beam scanner shows it: cupped grey values that are not HU");
  verb
    .add_option("--field-radius", s.fieldRadiusMm,
      "In mm: nothing is seen outside this upright cylinder; 0 = no limit")
    ->check(Within(0.0, 1000.0));
}

} // namespace

void AddPhantomVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<PhantomOptions>();
  CLI::App* verb =
    app.add_subcommand("phantom", "Write a CT of a head or a fibula with known truth");
  verb
    ->add_option("--output", options->output,
      "The .mha, .nrrd, .nii, .nii.gz or .vti file; its folder must exist")
    ->required();
  verb
    ->add_option("--anatomy", options->anatomy,
      "head (skull, lower jaw, teeth), fibula, or both in one volume")
    ->check(CLI::IsMember({ "head", "fibula", "both" }))
    ->capture_default_str();
  verb->add_flag("--intact", options->intact, "Without the hole in the right frontal bone");
  AddGridOptions(*verb, *options);
  AddScannerOptions(*verb, *options);
  AddFractureOptions(*verb, *options);
  AddCommonOptions(*verb, session);
  verb->footer(
    "Compact bone is 1000 HU, spongy bone 300 to 500, teeth 1700 and 2800, soft tissue 40, "
    "air -1000;\nevery surface is known in closed form. --json prints the volumes of the "
    "bones and landmarks.\nExample: hasp phantom --spacing 1,1,1.5 --output head.mha\n"
    "Exit codes: 0 done, 1 wrong use.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
