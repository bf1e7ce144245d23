#include "Failure.h"
#include "Files.h"
#include "LabelInput.h"
#include "MirrorGhost.h"
#include "MirrorStep.h"
#include "PartFormats.h"
#include "Session.h"
#include "VerbWork.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspFileNames.h"
#include "vtkHaspOutputFile.h"
#include "vtkHaspVolumeView.h"

#include "Distance/Coverage.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>
#include <glm/geometric.hpp>

#include <iostream>
#include <memory>

namespace hasp
{
namespace
{

struct MirrorOptions
{
  VolumeChoices volume;
  std::string labels, output;
  int label = 1;
  double isovalue = 226.0, ignoreBelowMm3 = 1000.0;
  std::vector<double> plane;
  MirrorGhostSettings settings;
  MirrorStep step;
};

/// One byte a sample: the label's bone, or all large pieces.
std::vector<std::uint8_t> KeptBone(
  const MirrorOptions& options, const LoadedVolume& volume, Session& session)
{
  const AnyGridView grey = ViewImage(volume.image);
  if (options.labels.empty())
    return KeepLargePieces(grey, options.isovalue, options.ignoreBelowMm3);
  const LoadedLabels labels = ReadLabels(options.labels, GeometryOf(grey), session);
  return KeepLabel(ViewImage(labels.image), options.label);
}

nlohmann::ordered_json Describe(const MirrorGhost& ghost, const MirrorGhostSettings& settings)
{
  const auto list = [](const glm::dvec3& v) { return nlohmann::ordered_json{ v.x, v.y, v.z }; };
  return { { "plane", { { "point", list(ghost.plane.point) },
                        { "normal", list(ghost.plane.normal) }, { "found", ghost.found } } },
    { "median_mm", ghost.medianMm }, { "p95_mm", ghost.p95Mm },
    { "matched_mm", settings.matchedMm }, { "matched_share", ghost.matchedShare },
    { "triangles", ghost.mesh.triangles.size() } };
}

void Print(const MirrorGhost& ghost, const MirrorGhostSettings& settings)
{
  const glm::dvec3 &p = ghost.plane.point, &n = ghost.plane.normal;
  std::cout << Line("plane     %s: through (%.2f, %.2f, %.2f) mm, normal (%.4f, %.4f, %.4f)\n",
                 ghost.found ? "found" : "given", p.x, p.y, p.z, n.x, n.y, n.z)
            << Line("residual  median %.2f mm, 95%% within %.2f mm\n", ghost.medianMm, ghost.p95Mm)
            << Line("matched   %.1f %% of the mirrored surface within %g mm of bone\n",
                 100.0 * ghost.matchedShare, settings.matchedMm);
}

MirrorGhostSettings SettingsOf(const MirrorOptions& options)
{
  MirrorGhostSettings settings = options.settings;
  const std::vector<double>& p = options.plane;
  if (p.empty())
    return settings;
  const glm::dvec3 normal(p[3], p[4], p[5]);
  if (!(glm::length(normal) > 1e-6))
    throw Failure(ExitCode::WrongUse, "--plane's normal has no length; give x,y,z,nx,ny,nz");
  settings.plane = MirrorPlane{ { p[0], p[1], p[2] }, glm::normalize(normal) };
  return settings;
}

void Run(const MirrorOptions& options, Session& session)
{
  if (!options.output.empty())
    RequireWritable(options.output, PartEndings());
  RequireMirrorStep(options.step);
  if (!options.step.plan.empty() && !options.labels.empty())
    throw Failure(ExitCode::WrongUse, "--plan keeps a ghost of all of the scan's bone: leave "
                                      "--labels out");
  const MirrorGhostSettings settings = SettingsOf(options);
  VolumeChoices choices = options.volume;
  choices.hash = !options.step.plan.empty();
  const LoadedVolume volume = ReadVolume(choices, session);
  RequireScanInPlan(options.step, volume.passport.hash);
  SayWarnings(volume.passport, session);
  RequireIsoValue(options.isovalue, volume.passport);
  const std::vector<std::uint8_t> keep = KeptBone(options, volume, session);
  session.progress.Step("mirroring");
  const auto start = std::chrono::steady_clock::now();
  const MirrorGhost ghost = Try(ExitCode::BadInput, "",
    [&]
    {
      return MakeMirrorGhost(ViewImage(volume.image), options.isovalue, keep, settings,
        [&session](double share)
        {
          session.progress.Share(share);
          return true;
        });
    });
  session.resources.push_back({ "ghost", ghost.mesh.points.size() * (sizeof(glm::dvec3) + 4),
    MillisecondsSince(start), "the mirrored surface and how far it is from bone" });
  if (!options.output.empty())
  {
    Try(ExitCode::WrongUse, "", [&] { WriteSurface(MakePolyData(ghost.mesh), options.output); });
    session.result["output"] = FileLabel(options.output);
  }
  session.progress.Wipe();
  session.result.update(Describe(ghost, settings));
  if (!session.json)
    Print(ghost, settings);
  KeepMirror(options.step, volume.passport.hash, options.isovalue, ghost.plane, session);
}

} // namespace

void AddMirrorVerb(CLI::App& app, Session& session)
{
  auto options = std::make_shared<MirrorOptions>();
  CLI::App* verb =
    app.add_subcommand("mirror", "Mirror bone at its plane of symmetry, and say how alike it is");
  AddVolumeOptions(*verb, options->volume);
  verb->add_option("--isovalue", options->isovalue, "Bone is this and more")
    ->check(Within(-1e6, 1e6))
    ->capture_default_str();
  verb->add_option("--ignore-below", options->ignoreBelowMm3, "Smaller pieces are left out, mm3")
    ->check(Within(0.0, 1e9))
    ->capture_default_str();
  verb->add_option(
    "--labels", options->labels, "Labels of IN's grid: only bone of the --label is mirrored");
  verb->add_option("--label", options->label, "The bone's value in --labels")
    ->check(CLI::Range(1, 65535))
    ->capture_default_str();
  verb
    ->add_option("--plane", options->plane,
      "x,y,z,nx,ny,nz: a point, mm, and the normal; else "
      "the plane of best symmetry is found")
    ->delimiter(',')
    ->expected(6)
    ->check(Within(-1e6, 1e6));
  verb->add_option("--spacing", options->settings.spacingMm, "Of the surface's grid, mm")
    ->check(Within(0.3, 3.0))
    ->capture_default_str();
  verb->add_option("--matched", options->settings.matchedMm, "What counts as alike, mm")
    ->check(Within(0.01, 100.0))
    ->capture_default_str();
  verb->add_option("--output", options->output, "The mirrored surface: .stl, .3mf, .ply or .obj");
  AddMirrorStepOptions(*verb, options->step);
  AddCommonOptions(*verb, session);
  verb->footer("Example: hasp mirror head.mha --output ghost.stl\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, or bone is not like its image.");
  verb->callback(
    [&session, options] { session.run = [&session, options] { Run(*options, session); }; });
}

} // namespace hasp
