#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkRenderer;

namespace hasp
{

/// Where the viewer stands. World is patient LPS: x to the patient's left, y to the back, z up.
struct CameraOptions
{
  std::string view = "front";                       ///< a name of AnatomicalViews
  std::optional<std::array<double, 3>> direction{}; ///< the way the viewer looks; overrides view
  std::optional<std::array<double, 3>> viewUp{};    ///< overrides the view's up
  double zoom = 1.0;                                ///< > 0; 2 shows half as much
  /// Width through height of what an eye sees, where that is not the window's; > 0.
  std::optional<double> aspect{};
};

struct AnatomicalView
{
  const char* name;
  std::array<double, 3> direction; ///< the way the viewer looks
  std::array<double, 3> up;
};

/// front (the viewer faces the patient), back, left (stands at the patient's left), right, top
/// (looks down, face upwards in the picture), bottom.
const std::vector<AnatomicalView>& AnatomicalViews();

/// Sets the renderer's camera so that everything visible fills the view, then zooms. Throws
/// Failure: WrongUse for a direction of no length, one parallel to the view up, or an unknown view.
void PlaceCamera(vtkRenderer* renderer, const CameraOptions& options);

} // namespace hasp
