#pragma once
#include "SurfaceScene.h"
#include "VolumeInput.h"

#include <optional>

namespace CLI
{
class App;
}

/// What `hasp render` and `hasp view` let their users choose of what is drawn.
namespace hasp
{

struct SceneChoices
{
  VolumeChoices volume;
  std::optional<double> isoValue;
  std::optional<std::string> mapper;
  double ignoreBelowMm3 = 0.0;
};

/// Adds IN and the options of isosurface, mapper, look, surfaces and camera to a verb. The values
/// in `scene` are the defaults, and are where the options go.
void AddSceneOptions(CLI::App& verb, SceneChoices& choices, SceneOptions& scene);

struct LoadedScene
{
  vtkSmartPointer<vtkDataObject> input; ///< a vtkImageData or a vtkHaspClusteredCells
  std::optional<Passport> passport;     ///< of an image
};

/// Reads IN and sets the scene's isovalue and mapper. Active cells are drawn as such. An
/// interactive scene needs no --isovalue: bone where values are HU, else the middle of the values.
/// Throws Failure: WrongUse for options that do not go together, BadInput.
LoadedScene ReadScene(const SceneChoices& choices, SceneOptions& scene, Session& session);

} // namespace hasp
