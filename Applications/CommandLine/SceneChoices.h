#pragma once
#include "SurfaceScene.h"
#include "VolumeInput.h"

#include <array>
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
  std::optional<std::array<double, 2>> window; ///< of mapper mip: low, high
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

/// Reads IN and sets the scene's isovalue, mapper and look. Active cells are drawn as such. An
/// interactive scene and one of skin and bone need no --isovalue: bone where values are HU, else
/// the middle of the values. The brightest values have none.
/// Throws Failure: WrongUse for options that do not go together, BadInput.
LoadedScene ReadScene(const SceneChoices& choices, SceneOptions& scene, Session& session);

} // namespace hasp
