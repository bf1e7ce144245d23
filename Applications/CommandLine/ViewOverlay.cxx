#include "ViewOverlay.h"

#include "StereoView.h"
#include "SurfaceScene.h"
#include "ViewWindow.h"

#include "vtkProperty2D.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkTextProperty.h"

#include <cstdio>

namespace hasp
{
namespace
{

constexpr int TextPixels = 15;

/// What can be read on that background.
std::array<double, 3> InkOn(const double* background)
{
  const double luma = 0.3 * background[0] + 0.6 * background[1] + 0.1 * background[2];
  return luma > 0.5 ? std::array{ 0.0, 0.0, 0.0 } : std::array{ 1.0, 1.0, 1.0 };
}

void Write(vtkTextProperty* text, const std::array<double, 3>& ink)
{
  text->SetColor(ink[0], ink[1], ink[2]);
  text->SetFontSize(TextPixels);
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
}

void Place(vtkSliderRepresentation2D* slider, const std::array<double, 3>& ink)
{
  slider->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedViewport();
  slider->GetPoint1Coordinate()->SetValue(0.1, 0.08);
  slider->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedViewport();
  slider->GetPoint2Coordinate()->SetValue(0.9, 0.08);
  slider->SetSliderLength(0.02);
  slider->SetSliderWidth(0.03);
  slider->SetTubeWidth(0.006);
  slider->SetEndCapLength(0.004);
  slider->SetEndCapWidth(0.02);
  slider->SetTitleHeight(0.022);
  slider->SetLabelHeight(0.022);
  slider->GetTubeProperty()->SetColor(0.5, 0.5, 0.5);
  slider->GetCapProperty()->SetColor(0.5, 0.5, 0.5);
  slider->GetSliderProperty()->SetColor(ink.data());
  slider->GetSelectedProperty()->SetColor(0.90, 0.62, 0.0);
  Write(slider->GetTitleProperty(), ink);
  Write(slider->GetLabelProperty(), ink);
}

} // namespace

ViewOverlay::ViewOverlay(
  vtkRenderer* renderer, vtkRenderWindowInteractor* interactor, const ViewSettings& settings)
  : Renderer(renderer),
    Unit(settings.unit.empty() ? "" : " " + settings.unit),
    Shown(settings.shown),
    Changeable(settings.range.has_value() && settings.overlay)
{
  const auto ink = InkOn(renderer->GetBackground());
  Write(this->Line->GetTextProperty(), ink);
  this->Line->GetTextProperty()->SetVerticalJustificationToTop();
  this->Line->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Line->GetPositionCoordinate()->SetValue(0.01, 0.99);
  if (settings.overlay)
    renderer->AddActor2D(this->Line);
  if (!this->Changeable)
    return;
  vtkNew<vtkSliderRepresentation2D> slider;
  Place(slider, ink);
  const auto& [least, most] = *settings.range;
  slider->SetMinimumValue(least);
  slider->SetMaximumValue(most);
  slider->SetValue(settings.isoValue);
  slider->SetLabelFormat(most - least >= 100.0 ? "%.0f" : "%.4g");
  slider->SetTitleText(("isovalue" + (this->Unit.empty() ? "" : "," + this->Unit)).c_str());
  this->Widget->SetInteractor(interactor);
  this->Widget->SetCurrentRenderer(renderer);
  this->Widget->SetRepresentation(slider);
  this->Widget->KeyPressActivationOff(); // VTK's key i would hide it
  this->Widget->SetAnimationModeToJump();
  this->Widget->EnabledOn();
}

ViewOverlay::~ViewOverlay()
{
  if (this->Changeable)
    this->Widget->EnabledOff();
  this->Renderer->RemoveActor2D(this->Line);
}

vtkSliderWidget* ViewOverlay::Slider() const
{
  return this->Changeable ? this->Widget.Get() : nullptr;
}

double ViewOverlay::SliderValue() const
{
  return static_cast<vtkSliderRepresentation*>(this->Widget->GetRepresentation())->GetValue();
}

void ViewOverlay::SetSliderValue(double value)
{
  if (this->Changeable)
    static_cast<vtkSliderRepresentation*>(this->Widget->GetRepresentation())->SetValue(value);
}

void ViewOverlay::PlaceSlider()
{
  if (!this->Changeable)
    return;
  this->Widget->GetRepresentation()->Modified();
  this->Widget->GetRepresentation()->BuildRepresentation();
}

void ViewOverlay::SetText(const std::string& text)
{
  this->Line->SetInput(text.c_str());
}

std::string ViewOverlay::IsoValueText(double value) const
{
  if (!this->Changeable)
    return this->Shown;
  char text[60];
  std::snprintf(text, sizeof text, "isovalue %.6g", value);
  return text + this->Unit;
}

std::string PickText(const SurfaceScene& scene, int x, int y, const StereoView* eyes)
{
  const auto ray = eyes ? eyes->RayOf(x, y) : scene.RayOf(x, y);
  const auto point = ray ? scene.Pick(ray->first, ray->second) : std::nullopt;
  if (!point && !scene.CanPick())
    return "not known: " + scene.DrewBy() + " gives no points; --mapper mesh does";
  if (!point)
    return "no surface there";
  char text[100];
  std::snprintf(
    text, sizeof text, "picked %.2f, %.2f, %.2f mm (LPS)", (*point)[0], (*point)[1], (*point)[2]);
  return text;
}

} // namespace hasp
