#include "SceneChecks.h"

#include "Failure.h"

#include <cmath>

namespace hasp
{
namespace
{

/// Light takes traced rays; what else is said of active cells is for what draws them.
void RequireFittingDrawing(const SurfaceDrawing& drawing, const LightChoices& light)
{
  if (drawing.Lit() && !light.pathSamples && drawing.renderer == "rasterize")
    throw Failure(ExitCode::WrongUse,
      "--ambient-occlusion and --shadows take traced rays; leave out --renderer rasterize");
  if (drawing.blendNormals && (drawing.Lit() || drawing.renderer == "trace"))
    throw Failure(ExitCode::WrongUse, "--blend-normals is drawn by OpenGL; leave out --renderer "
                                      "trace, --ambient-occlusion and --shadows");
  if (drawing.mapper == "cells")
    return;
  if (drawing.compact || drawing.blendNormals)
    throw Failure(
      ExitCode::WrongUse, "--compact and --blend-normals are for --mapper cells; leave them out");
  const bool lit = drawing.Lit() && !light.pathSamples;
  if (drawing.mapper != "raycaching" && (drawing.renderer != "automatic" || lit))
    throw Failure(ExitCode::WrongUse, "--renderer, --ambient-occlusion and --shadows are for "
                                      "--mapper cells and raycaching; leave them out");
}

/// Paths see active cells and triangles.
void RequireFittingLight(const SceneOptions& scene)
{
  const SurfaceDrawing& drawing = scene.drawing;
  if (!scene.light.pathSamples)
    return;
  if (drawing.mapper != "cells" && drawing.mapper != "mesh")
    throw Failure(ExitCode::WrongUse, "--path-trace is for --mapper cells and mesh, not " +
                                        drawing.mapper + "; leave one of them out");
  if (scene.light.eyesApart && drawing.interactive)
    throw Failure(ExitCode::WrongUse, "--path-trace goes on from frame to frame of one eye; leave "
                                      "out --stereo, or take hasp render, which waits for both");
  if (drawing.blendNormals)
    throw Failure(
      ExitCode::WrongUse, "--path-trace meets the cells themselves; leave out --blend-normals");
  if (drawing.ambientOcclusionMm)
    throw Failure(
      ExitCode::WrongUse, "--path-trace darkens by itself; leave out --ambient-occlusion");
}

/// What is said of values is for the mappers that use it.
void RequireFittingValues(const SceneChoices& choices, const std::string& mapper)
{
  if (choices.window && mapper != "mip")
    throw Failure(ExitCode::WrongUse, "--window is for --mapper mip; leave it out");
  if (mapper == "mip" && (choices.isoValue || choices.ignoreBelowMm3 > 0.0))
    throw Failure(ExitCode::WrongUse,
      "--isovalue and --ignore-below are for surfaces, and --mapper mip shows the brightest "
      "values; leave them out, --window says what is dark and what bright");
  if (!choices.window)
    return;
  const auto [low, high] = *choices.window;
  if (!std::isfinite(low) || !std::isfinite(high) || low >= high)
    throw Failure(ExitCode::WrongUse, "--window takes low,high, and low must be below high");
}

} // namespace

void ChooseMapperForLight(SceneOptions& scene, bool chosen)
{
  if (chosen)
    return;
  if (scene.light.pathSamples || (scene.drawing.Lit() && !scene.surfaces.empty()))
    scene.drawing.mapper = "cells";
}

void RequireFittingOptions(const SceneChoices& choices, const SceneOptions& scene)
{
  RequireFittingDrawing(scene.drawing, scene.light);
  RequireFittingLight(scene);
  RequireFittingValues(choices, scene.drawing.mapper);
}

} // namespace hasp
