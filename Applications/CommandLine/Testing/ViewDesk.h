#pragma once
#include "Session.h"
#include "SurfaceScene.h"
#include "ViewWindow.h"
#include "vtkHaspHeadlessWindows.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace hasp::testing
{

constexpr int Size = 200, Samples = 33; // pixels; along each axis

/// 100 - distance to the origin: the isosurface of v is the sphere of radius 100 - v. Rotated.
inline vtkSmartPointer<vtkImageData> Ball()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Samples, Samples, Samples);
  image->SetSpacing(2, 2, 3);
  const double c = std::cos(0.5), s = std::sin(0.5);
  image->SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, 1);
  double middle[3];
  image->TransformContinuousIndexToPhysicalPoint(
    0.5 * (Samples - 1), 0.5 * (Samples - 1), 0.5 * (Samples - 1), middle);
  image->SetOrigin(-middle[0], -middle[1], -middle[2]);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType n = 0; n < image->GetNumberOfPoints(); ++n)
  {
    const double* p = image->GetPoint(n);
    image->GetPointData()->GetScalars()->SetTuple1(
      n, 100.0 - std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
  }
  return image;
}

/// A window without a screen, and an interactor whose timers the test fires.
struct Desk
{
  bool headless = UseHeadlessWindows(); // before the window
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  std::set<int> timers; ///< that were created and have not been fired: one-shot, all of them
  int created = 0;
  int lastMs = 0; ///< of the timer created last
  Session session;
  SceneOptions options;
  std::unique_ptr<SurfaceScene> scene;
  std::unique_ptr<ViewWindow> view;

  explicit Desk(
    const std::string& mapper = "raycaching", double isoValue = 80.0, LightChoices light = {})
  {
    this->session.quiet = true;
    this->options.isoValue = isoValue;
    this->options.drawing.mapper = mapper;
    this->options.drawing.interactive = true;
    this->options.light = std::move(light);
    this->window->SetSize(Size, Size);
    this->window->AddRenderer(this->renderer);
    this->interactor->SetRenderWindow(this->window);
    this->interactor->AddObserver(vtkCommand::CreateTimerEvent, this, &Desk::Create);
    this->scene =
      std::make_unique<SurfaceScene>(this->renderer, Ball(), this->options, this->session);
    ViewSettings settings;
    settings.range = { 40.0, 100.0 };
    settings.isoValue = isoValue;
    settings.unit = "HU";
    this->view =
      std::make_unique<ViewWindow>(*this->scene, this->window, this->interactor, settings);
    this->interactor->Initialize();
    this->window->Render();
  }
  void Create()
  {
    const int id = this->interactor->GetTimerEventId();
    this->interactor->SetTimerEventPlatformId(id);
    this->timers.insert(id);
    this->lastMs = this->interactor->GetTimerEventDuration();
    ++this->created;
  }
  void Fire(int id)
  {
    ASSERT_TRUE(this->interactor->IsOneShotTimer(id));
    this->interactor->InvokeEvent(vtkCommand::TimerEvent, &id);
  }
  /// Fires what runs until nothing does; how many.
  int Settle()
  {
    int fired = 0;
    for (; !this->timers.empty() && fired < 500; ++fired)
    {
      const int id = *this->timers.begin();
      this->timers.erase(this->timers.begin());
      this->Fire(id);
    }
    return fired;
  }
  void Press(const std::string& key)
  {
    this->interactor->SetKeySym(key.c_str());
    this->interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    this->interactor->InvokeEvent(vtkCommand::CharEvent);
  }
  void Mouse(int x, int y, unsigned long event)
  {
    this->interactor->SetEventInformation(x, y, 0, 0, 0);
    this->interactor->InvokeEvent(event);
  }
  /// Half the width of the ball in the window's middle row, in mm; 0 if there is none.
  double Radius() const
  {
    vtkSmartPointer<vtkImageData> picture = this->view->DrawComplete();
    int left = Size, right = -1;
    for (int x = 0; x < Size; ++x)
      if (const auto* p = static_cast<unsigned char*>(picture->GetScalarPointer(x, Size / 2, 0));
          p[0] > 45) // the background has 26
      {
        left = std::min(left, x);
        right = std::max(right, x + 1);
      }
    vtkCamera* camera = this->renderer->GetActiveCamera();
    const double half = std::tan(camera->GetViewAngle() * M_PI / 360.0);
    const double tangent = half * (right - left) / Size; // of the cone around the ball
    return right < 0 ? 0.0 : camera->GetDistance() * tangent / std::sqrt(1.0 + tangent * tangent);
  }
};

} // namespace hasp::testing
