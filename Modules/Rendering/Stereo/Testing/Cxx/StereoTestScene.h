#pragma once
#include "StereoWindow.h"
#include "vtkHaspStereoWindows.h"

#include "vtkHaspHeadlessWindows.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

/// What the tests of stereo windows share: balls in front of a camera, windows, pictures.
namespace stereotest
{

using Bytes = std::vector<std::uint8_t>;

inline vtkSmartPointer<vtkActor> MakeBall(
  const glm::dvec3& center, double radius, const glm::dvec3& color = glm::dvec3(1.0))
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(center.x, center.y, center.z);
  ball->SetRadius(radius);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.x, color.y, color.z);
  return actor.Get();
}

inline vtkSmartPointer<vtkRenderWindow> MakeWindow(glm::ivec2 size)
{
  hasp::UseHeadlessWindows();
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(size.x, size.y);
  return window;
}

/// RGB of all of a window, as it is seen.
inline Bytes Picture(vtkRenderWindow* window, bool right = false)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  const int* size = window->GetSize();
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels, right);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

/// Lit balls of several colours around the focal point of a camera, none the mirror of another.
class BallsScene
{
public:
  BallsScene()
  {
    hasp::UseHeadlessWindows();
    this->Renderer->AddActor(MakeBall({ 0, 0, 0 }, 30, { 0.9, 0.5, 0.3 }));
    this->Renderer->AddActor(MakeBall({ 60, 80, 45 }, 25, { 0.3, 0.8, 0.4 }));
    this->Renderer->AddActor(MakeBall({ -70, -90, -30 }, 20, { 0.3, 0.5, 1.0 }));
    this->Renderer->AddActor(MakeBall({ 90, -30, -70 }, 15, { 1.0, 1.0, 0.3 }));
    this->Renderer->SetBackground(0.1, 0.1, 0.15);
    this->Renderer->SetBackground2(0.5, 0.5, 0.6);
    this->Renderer->GradientBackgroundOn();
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(40, -500, 60);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(0, 0, 1);
    this->Windows->SetRenderer(this->Renderer);
    this->Windows->SetEyeAngle(6.0);
    vtkNew<vtkCallbackCommand> count;
    count->SetClientData(&this->Errors);
    count->SetCallback(
      [](vtkObject*, unsigned long, void* errors, void*) { ++*static_cast<int*>(errors); });
    this->Windows->AddObserver("ErrorEvent", count);
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkHaspStereoWindows> Windows;
  int Errors = 0;
};

} // namespace stereotest
