#pragma once
#include "vtkNew.h"
#include "vtkSliderWidget.h"
#include "vtkTextActor.h"

#include <string>

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace hasp
{

class StereoView;
class SurfaceScene;
struct ViewSettings;

/// What lies over a scene in a window: the isovalue's slider and a text. RENDER thread; interactor
/// and renderer must outlive it.
class ViewOverlay
{
public:
  ViewOverlay(
    vtkRenderer* renderer, vtkRenderWindowInteractor* interactor, const ViewSettings& settings);
  ~ViewOverlay();

  vtkSliderWidget* Slider() const; ///< null where the isovalue cannot be changed
  double SliderValue() const;
  void SetSliderValue(double value);
  /// So that it is hit where the window has it: a frame may have drawn it for a part of the window.
  void PlaceSlider();
  void SetText(const std::string& text);
  /// "isovalue 226 HU", or what is shown if it cannot be changed.
  std::string IsoValueText(double value) const;

private:
  vtkRenderer* Renderer;
  vtkNew<vtkSliderWidget> Widget;
  vtkNew<vtkTextActor> Line;
  std::string Unit, Shown;
  bool Changeable;
};

/// Where the scene's surface is in a pixel of the window: "picked 1.00, 2.00, 3.00 mm (LPS)". eyes:
/// draw the window, unless null.
std::string PickText(const SurfaceScene& scene, int x, int y, const StereoView* eyes);

} // namespace hasp
