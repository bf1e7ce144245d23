#include "SceneChoices.h"

#include "CellsInput.h"
#include "Failure.h"
#include "LargePieces.h"
#include "SceneChecks.h"
#include "Session.h"
#include "vtkHaspCellFile.h"
#include "vtkHaspClusteredCells.h"
#include "vtkHaspFileNames.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr double BoneHU = 226.0;

std::vector<std::string> AllMappers()
{
  std::vector<std::string> names = SurfaceMappers();
  names.insert(names.end(), VolumeMappers().begin(), VolumeMappers().end());
  return names;
}

void AddIsosurfaceOptions(CLI::App& verb, SceneChoices& choices, SceneOptions& scene)
{
  SurfaceDrawing& drawing = scene.drawing;
  AddVolumeOptions(verb, choices.volume);
  verb.get_option("IN")->description(
    "Volume: a file, or a folder of slices; or active cells, .hcells");
  verb.add_option("--isovalue", choices.isoValue,
    std::string("In the volume's units; bone in CT: 226. Active cells have their own") +
      (drawing.interactive ? ". Default: bone" : ". Default of --mapper composite: bone") +
      " where values are HU, else the middle of the values");
  verb
    .add_option("--ignore-below", choices.ignoreBelowMm3,
      std::string("Leave out connected pieces smaller than this, mm3: specks, head-rests") +
        (drawing.interactive ? "; as they are at the first isovalue" : ""))
    ->check(Within(0.0, 1e9));
  verb
    .add_option("--mapper", choices.mapper,
      "cells: exact, no mesh; raycaching: what rays find, frame by frame, until nothing is new; "
      "raycast: a ray a pixel on the GPU; mesh: Flying Edges; vtk: VTK's own volume mapper. No "
      "surface, by VTK's: mip: the brightest value along each line of sight; composite: "
      "translucent skin and bone, which begins at --isovalue")
    ->check(CLI::IsMember(AllMappers()))
    ->default_str(drawing.mapper);
  verb
    .add_option("--window", choices.window,
      "low,high of --mapper mip: the values drawn as the background, and in full colour. Default: "
      "0 to 2000, what of that occurs, where values are HU, else all values")
    ->delimiter(',');
  verb
    .add_option("--renderer", drawing.renderer,
      "Of active cells; rasterize: OpenGL; trace: rays on the CPU; automatic: where OpenGL is "
      "software, begin with trace and keep the faster one, and below OpenGL 4.3 trace; --explain "
      "says which")
    ->check(CLI::IsMember(CellRendererNames()))
    ->capture_default_str();
  verb.add_flag("--compact", drawing.compact,
    "Active cells of 8 bits a corner: the surface moves by 0.004 voxel RMS");
  verb.add_flag("--blend-normals", drawing.blendNormals,
    "Shade active cells smoothly where they are terraces: masks, labels, few grey levels. By "
    "OpenGL; the surface stays where it is");
  verb
    .add_option("--ambient-occlusion", drawing.ambientOcclusionMm,
      "Darken what stands close to bone or --surface: within so many mm, say 25. Rays on the CPU; "
      "of "
      "active cells; raycaching then draws these")
    ->check(Within(1e-3, 1e6));
  verb.add_flag("--shadows", drawing.shadows,
    std::string("A lamp up to the left of ") +
      (drawing.interactive ? "the first view" : "the viewer") +
      "; surfaces cast its shadow on each other");
}

void AddLightOptions(CLI::App& verb, LightChoices& light)
{
  auto* paths =
    verb
      .add_option("--path-trace", light.pathSamples,
        "Light of an environment by so many paths a pixel, 64 say: all surfaces light and shade "
        "each other. With --shadows the lamp joins it. Of mappers cells and mesh")
      ->check(CLI::Range(1, 1 << 20));
  verb
    .add_option("--environment", light.environment,
      "Radiance picture (.hdr) in latitude and longitude, its centre before the face; without it "
      "daylight")
    ->needs(paths);
  verb.add_option("--bounces", light.bounces, "Surfaces that light may meet on its way; 1: direct")
    ->check(CLI::Range(1, 64))
    ->capture_default_str()
    ->needs(paths);
}

void AddLookOptions(CLI::App& verb, SceneOptions& scene)
{
  verb
    .add_option("--surface", scene.surfaces,
      ".stl, .3mf, .ply, .obj or .vtp file drawn with it; repeatable")
    ->expected(1)
    ->allow_extra_args(false) // IN may follow
    ->take_all();
  verb
    .add_option("--resolution", scene.resolution,
      scene.drawing.interactive
        ? "Pixels of one eye, width,height; where two eyes lie side by side or one above "
          "the other the window is twice as wide or high"
        : "Pixels of one eye, width,height")
    ->delimiter(',')
    ->check(CLI::Range(1, 16384))
    ->capture_default_str();
  verb
    .add_option(
      "--color", scene.color, "r,g,b of the isosurface, of bone, or of the brightest value; 0 to 1")
    ->delimiter(',')
    ->check(Within(0.0, 1.0));
  verb.add_option("--background", scene.background, "r,g,b, 0 to 1")
    ->delimiter(',')
    ->check(Within(0.0, 1.0));
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

/// How the values are shown where no surface is.
VolumeLook LookOf(const SceneChoices& choices, const Passport& passport)
{
  VolumeLook look = UsualLook(passport);
  if (choices.window)
    look.window = *choices.window;
  char range[100];
  std::snprintf(range, sizeof range, "the volume's values run from %.6g to %.6g", passport.minimum,
    passport.maximum);
  if (look.window[0] >= look.window[1])
    throw Failure(ExitCode::BadInput,
      std::string("all values are the same, there is nothing to see: ") + range);
  if (look.window[0] >= passport.maximum || look.window[1] <= passport.minimum)
    throw Failure(ExitCode::WrongUse,
      std::string("--window shows nothing: ") + range + "; choose one that holds some of them");
  return look;
}

/// From a .hcells file: the volume need not be there.
LoadedScene ReadCellScene(const SceneChoices& choices, SceneOptions& scene, Session& session)
{
  const VolumeChoices& volume = choices.volume;
  if (choices.isoValue || choices.ignoreBelowMm3 > 0.0 || volume.series != 0 || volume.resample ||
      choices.mapper.value_or("cells") != "cells" || scene.drawing.compact)
    throw Failure(ExitCode::WrongUse,
      "--isovalue, --ignore-below, --series, --resample, --compact and other mappers than cells "
      "are for volumes; leave them out for active cells");
  vtkNew<vtkHaspClusteredCells> cells;
  cells->SetCells(ReadCells(volume.input, session));
  if (cells->GetNumberOfCells() == 0)
    throw Failure(ExitCode::BadInput,
      FileLabel(volume.input) + ": its isovalue has no surface, there is nothing to draw");
  return { cells.Get(), std::nullopt };
}

bool IsSurfaceMapper(const std::string& mapper)
{
  const auto& names = SurfaceMappers();
  return std::find(names.begin(), names.end(), mapper) != names.end();
}

double UsualIsoValue(const Passport& passport)
{
  if (passport.hounsfield && passport.minimum < BoneHU && BoneHU <= passport.maximum)
    return BoneHU;
  return 0.5 * (passport.minimum + passport.maximum);
}

} // namespace

void AddSceneOptions(CLI::App& verb, SceneChoices& choices, SceneOptions& scene)
{
  AddIsosurfaceOptions(verb, choices, scene);
  AddLightOptions(verb, scene.light);
  AddLookOptions(verb, scene);
  AddCameraOptions(verb, scene.camera);
}

LoadedScene ReadScene(const SceneChoices& choices, SceneOptions& scene, Session& session)
{
  const bool cells = IsCellFileName(choices.volume.input);
  scene.drawing.mapper = choices.mapper.value_or(cells ? "cells" : scene.drawing.mapper);
  RequireFittingOptions(choices, scene);
  if (cells)
    return ReadCellScene(choices, scene, session);
  RefuseCells(choices.volume.input, "volume"); // before their lack of an isovalue is a fault
  if (!choices.isoValue && !scene.drawing.interactive && IsSurfaceMapper(scene.drawing.mapper))
    throw Failure(ExitCode::WrongUse, "--isovalue is required; bone in CT: 226");
  LoadedVolume volume = ReadVolume(choices.volume, session);
  SayWarnings(volume.passport, session);
  if (scene.drawing.mapper == "mip")
    scene.drawing.look = LookOf(choices, volume.passport);
  else
  {
    scene.drawing.look = UsualLook(volume.passport);
    scene.isoValue = choices.isoValue.value_or(UsualIsoValue(volume.passport));
    RequireIsoValue(scene.isoValue, volume.passport);
  }
  if (choices.ignoreBelowMm3 > 0.0)
    volume.image =
      WithoutSmallPieces(volume.image, scene.isoValue, choices.ignoreBelowMm3, session);
  else
    session.resources.push_back(
      { "volume without small pieces", 0, 0.0, "no --ignore-below was given" });
  return { volume.image, std::move(volume.passport) };
}

} // namespace hasp
