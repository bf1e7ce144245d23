#ifndef PaintScene_h
#define PaintScene_h

// A window, a painter, and a mouse that a test moves.
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspSeedPainter.h"

#include "Planning/SegmentationRecipe.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace hasp::testing
{

/// What is reported as an error meanwhile.
inline std::string ErrorsOf(vtkObject* object, const std::function<void()>& call)
{
  std::string said;
  vtkNew<vtkCallbackCommand> listen;
  listen->SetClientData(&said);
  listen->SetCallback([](vtkObject*, unsigned long, void* to, void* text)
    { *static_cast<std::string*>(to) += static_cast<const char*>(text); });
  const auto tag = object->AddObserver(vtkCommand::ErrorEvent, listen);
  call();
  object->RemoveObserver(tag);
  return said;
}

/// A fine mesh: its facets lie less than R (pi / 200)^2 / 2 below the ball it stands for.
inline vtkSmartPointer<vtkActor> BallActor(double radius, const glm::dvec3& at = glm::dvec3(0.0))
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(200);
  source->SetPhiResolution(200);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(at.x, at.y, at.z);
  return actor;
}

constexpr int Side = 200;          // of the window, pixels
constexpr double Distance = 100.0; // of the eye from the origin, along z

/// Counts the painter's events, in order, as letters: Started, Changed, Ended, cancelled X, Radius.
class Heard
{
public:
  explicit Heard(vtkHaspSeedPainter* of)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void*) {
        static_cast<Heard*>(self)->said += "SCEXR"[event - vtkHaspSeedPainter::StrokeStartedEvent];
      });
    for (unsigned long event = vtkHaspSeedPainter::StrokeStartedEvent;
         event <= vtkHaspSeedPainter::RadiusChangedEvent; ++event)
      of->AddObserver(event, this->Command);
  }
  std::string said;

private:
  vtkNew<vtkCallbackCommand> Command;
};

/// Counts an event of any object, as a style hears it: behind us.
class Count
{
public:
  Count(vtkObject* object, unsigned long event)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { ++static_cast<Count*>(self)->times; });
    object->AddObserver(event, this->Command);
  }
  int times = 0;

private:
  vtkNew<vtkCallbackCommand> Command;
};

struct PaintScene
{
  PaintScene()
  {
    this->window->SetOffScreenRendering(true);
    this->window->SetMultiSamples(0);
    this->window->SetSize(Side, Side);
    this->window->AddRenderer(this->renderer);
    this->interactor->SetRenderWindow(this->window);
    this->interactor->SetInteractorStyle(nullptr); // those that are in the way say so
    vtkCamera* camera = this->renderer->GetActiveCamera();
    camera->SetPosition(0, 0, Distance);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetClippingRange(50, 200);
    this->painter->SetRenderer(this->renderer);
  }
  void Enable()
  {
    this->painter->EnabledOn();
    this->window->Render();
  }

  /// Keys: c, s, a as Ctrl, Shift, Alt.
  void Say(unsigned long event, const glm::ivec2& pixel, const std::string& keys = "",
    const char* symbol = nullptr)
  {
    const auto is = [&](char key) { return keys.find(key) != std::string::npos; };
    this->interactor->SetEventInformation(pixel.x, pixel.y, is('c'), is('s'), 0, 0, symbol);
    this->interactor->SetAltKey(is('a'));
    this->interactor->InvokeEvent(event);
  }
  void Hover(const glm::ivec2& pixel) { this->Say(vtkCommand::MouseMoveEvent, pixel); }
  void Press(const glm::ivec2& pixel) { this->Say(vtkCommand::LeftButtonPressEvent, pixel); }
  void Release(const glm::ivec2& pixel) { this->Say(vtkCommand::LeftButtonReleaseEvent, pixel); }
  /// From the first pixel over the others; each is one event.
  const std::vector<BrushStroke>& Drag(const std::vector<glm::ivec2>& pixels)
  {
    this->Press(pixels.front());
    for (std::size_t n = 1; n < pixels.size(); ++n)
      this->Hover(pixels[n]);
    this->Release(pixels.back());
    return this->painter->GetPieces();
  }
  /// mm of the view's plane at this distance from the eye, a pixel.
  double PixelMm(double depth)
  {
    vtkCamera* camera = this->renderer->GetActiveCamera();
    if (camera->GetParallelProjection())
      return 2.0 * camera->GetParallelScale() / Side;
    const double half = 0.5 * camera->GetViewAngle() * std::numbers::pi / 180.0;
    return 2.0 * depth * std::tan(half) / Side;
  }

  const bool headless = hasp::UseHeadlessWindows(); ///< before the first window
  vtkSmartPointer<vtkRenderWindow> window = vtkSmartPointer<vtkRenderWindow>::New();
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkNew<vtkHaspSeedPainter> painter;
};

} // namespace hasp::testing

#endif
