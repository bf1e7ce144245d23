#include "CellsInput.h"
#include "Failure.h"
#include "Files.h"
#include "LargePieces.h"
#include "RenderScene.h"
#include "Session.h"
#include "SurfaceActors.h"
#include "Verbs.h"
#include "VolumeInput.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspFileNames.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>

namespace hasp
{
namespace
{

struct Choices
{
  VolumeChoices volume;
  std::string output;
  std::optional<double> isoValue;
  double ignoreBelowMm3 = 0.0;
  std::string stereo = "mono";
  RenderOptions render;
};

void Draw(
  vtkDataObject* volume, const RenderOptions& render, const std::string& output, Session& session)
{
  RenderScene scene(volume, render, session);
  WriteFile(output, scene.DrawPng());
  session.result["output"] = FileLabel(output);
}

/// From a .hcells file: the volume need not be there.
void RunOnCells(const Choices& choices, Session& session)
{
  const VolumeChoices& volume = choices.volume;
  if (choices.isoValue || choices.ignoreBelowMm3 > 0.0 || volume.series != 0 || volume.resample ||
      choices.render.mapper != SurfaceMappers().front() || choices.render.cells.compact)
    throw Failure(ExitCode::WrongUse,
      "--isovalue, --ignore-below, --series, --resample, --compact and other mappers than cells "
      "are for volumes; leave them out for active cells");
  vtkNew<vtkHaspClusteredCells> cells;
  cells->SetCells(ReadCells(volume.input, session));
  if (cells->GetNumberOfCells() == 0)
    throw Failure(ExitCode::BadInput,
      FileLabel(volume.input) + ": its isovalue has no surface, there is nothing to draw");
  Draw(cells, choices.render, choices.output, session);
}

void Run(Choices choices, Session& session)
{
  RequireWritable(choices.output, { ".png" });
  if (choices.render.cells.Lit() && choices.render.cells.renderer == "rasterize")
    throw Failure(ExitCode::WrongUse,
      "--ambient-occlusion and --shadows take traced rays; leave out --renderer rasterize");
  if (IsCellFileName(choices.volume.input))
    return RunOnCells(choices, session);
  RefuseCells(choices.volume.input, "volume"); // before their lack of an isovalue is a fault
  if (!choices.isoValue)
    throw Failure(ExitCode::WrongUse, "--isovalue is required; bone in CT: 226");
  if (choices.render.mapper != "cells" &&
      (choices.render.cells.renderer != "automatic" || choices.render.cells.compact ||
        choices.render.cells.Lit()))
    throw Failure(ExitCode::WrongUse,
      "--renderer, --compact, --ambient-occlusion and --shadows are for --mapper cells; leave them "
      "out");
  choices.render.isoValue = *choices.isoValue;
  const LoadedVolume volume = ReadVolume(choices.volume, session);
  SayWarnings(volume.passport, session);
  RequireIsoValue(choices.render.isoValue, volume.passport);
  vtkSmartPointer<vtkImageData> image = volume.image;
  if (choices.ignoreBelowMm3 > 0.0)
    image = WithoutSmallPieces(image, choices.render.isoValue, choices.ignoreBelowMm3, session);
  else
    session.resources.push_back(
      { "volume without small pieces", 0, 0.0, "no --ignore-below was given" });
  Draw(image, choices.render, choices.output, session);
}

void AddCameraOptions(CLI::App& verb, CameraOptions& camera)
{
  std::vector<std::string> views;
  for (const AnatomicalView& view : AnatomicalViews())
    views.push_back(view.name);
  auto* view = verb.add_option("--view", camera.view, "Where the viewer stands, of the patient")
                 ->check(CLI::IsMember(views))
                 ->capture_default_str();
  verb.add_option("--camera-direction", camera.direction, "x,y,z the viewer looks along, in LPS")
    ->delimiter(',')
    ->excludes(view);
  verb.add_option("--view-up", camera.viewUp, "x,y,z that points up in the picture, in LPS")
    ->delimiter(',');
  verb.add_option("--zoom", camera.zoom, "2 shows half as much")
    ->check(Within(0.01, 100.0))
    ->capture_default_str();
}

void AddLookOptions(CLI::App& verb, Choices& choices)
{
  RenderOptions& render = choices.render;
  verb.add_option("--resolution", render.resolution, "Pixels of one eye, width,height")
    ->delimiter(',')
    ->check(CLI::Range(1, 16384))
    ->capture_default_str();
  verb.add_option("--color", render.color, "r,g,b of the isosurface, 0 to 1")
    ->delimiter(',')
    ->check(Within(0.0, 1.0));
  verb.add_option("--background", render.background, "r,g,b, 0 to 1")
    ->delimiter(',')
    ->check(Within(0.0, 1.0));
  verb
    .add_option("--stereo", choices.stereo,
      "mono, side-by-side, top-bottom, left, right or anaglyph; two eyes make the picture twice "
      "as wide or high")
    ->check(CLI::IsMember({ "mono", "side-by-side", "top-bottom", "left", "right", "anaglyph" }))
    ->capture_default_str();
  verb.add_option("--eye-angle", render.eyeAngle, "Degrees between the eyes, seen from the middle")
    ->check(Within(0.0, 90.0))
    ->capture_default_str();
}

} // namespace

void AddRenderVerb(CLI::App& app, Session& session)
{
  auto choices = std::make_shared<Choices>();
  CLI::App* verb = app.add_subcommand(
    "render", "Draw an isosurface of a volume, or active cells, into a PNG file");
  AddVolumeOptions(*verb, choices->volume);
  verb->get_option("IN")->description(
    "Volume: a file, or a folder of slices; or active cells, .hcells");
  verb->add_option("--isovalue", choices->isoValue,
    "In the volume's units; bone in CT: 226. Active cells have their own");
  verb->add_option("--output", choices->output, "The .png file; its folder must exist")->required();
  verb
    ->add_option("--ignore-below", choices->ignoreBelowMm3,
      "Leave out connected pieces smaller than this, mm3: specks, head-rests")
    ->check(Within(0.0, 1e9));
  choices->render.mapper = SurfaceMappers().front();
  verb
    ->add_option("--mapper", choices->render.mapper,
      "cells: exact, no mesh; raycaching: what rays find, frame by frame, until nothing is new; "
      "raycast: a ray a pixel on the GPU; mesh: Flying Edges")
    ->check(CLI::IsMember(SurfaceMappers()))
    ->capture_default_str();
  verb
    ->add_option("--renderer", choices->render.cells.renderer,
      "Of active cells; rasterize: OpenGL; trace: rays on the CPU; automatic: where OpenGL is "
      "software, begin with trace and keep the faster one; --explain says which")
    ->check(CLI::IsMember(CellRendererNames()))
    ->capture_default_str();
  verb->add_flag("--compact", choices->render.cells.compact,
    "Active cells of 8 bits a corner: the surface moves by 0.004 voxel RMS");
  verb
    ->add_option("--ambient-occlusion", choices->render.cells.ambientOcclusionMm,
      "Darken what stands close to other bone: within so many mm, say 25. Rays on the CPU; of "
      "active cells")
    ->check(Within(1e-3, 1e6));
  verb->add_flag("--shadows", choices->render.cells.shadows,
    "A lamp up to the left of the viewer; active cells cast its shadow on each other");
  verb
    ->add_option("--surface", choices->render.surfaces,
      ".stl, .ply, .obj or .vtp file drawn with it; repeatable")
    ->expected(1)
    ->allow_extra_args(false) // IN may follow
    ->take_all();
  AddLookOptions(*verb, *choices);
  AddCameraOptions(*verb, choices->render.camera);
  AddCommonOptions(*verb, session);
  verb->footer("Examples:\n"
               "  hasp render head.mha --isovalue 226 --output head.png\n"
               "  hasp render head.mha --isovalue 226 --view right --surface guide.stl \\\n"
               "       --stereo side-by-side --resolution 960,1080 --output pair.png\n"
               "  hasp render head.mha --isovalue 226 --output head.png --explain\n"
               "  hasp render head.hcells --output head.png\n"
               "Exit codes: 0 done, 1 wrong use, 2 bad input, 4 cannot draw.");
  verb->callback(
    [&session, choices]
    {
      choices->render.stereo = StereoLayoutFromName(choices->stereo);
      session.run = [&session, choices] { Run(*choices, session); };
    });
}

} // namespace hasp
