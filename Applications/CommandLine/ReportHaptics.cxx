#include "ReportHaptics.h"

#include "HapticTrials.h"
#include "LoopTrial.h"
#include "ReportRegistry.h"
#include "Windows.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

namespace hasp
{
namespace
{

/// What is drawn beside the loop: a mesh that turns.
class Rendering
{
public:
  static constexpr const char* Text = "a turning mesh of 180,000 triangles, 800 x 600 pixels";

  Rendering()
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetThetaResolution(300);
    ball->SetPhiResolution(300);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetSize(800, 600);
    this->Window->AddRenderer(this->Renderer);
    RequireOpenGL(this->Window);
  }
  void Draw()
  {
    this->Renderer->GetActiveCamera()->Azimuth(1.0);
    this->Window->Render();
    this->Window->WaitForCompletion();
  }

private:
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

} // namespace

void ReportHaptics(ReportContext& context)
{
  ChooseWindows();
  context.report.machine.gl = OpenGLName();
  context.progress(0.0, "haptics: vectors against plain code");
  TrySimd(context);
  context.progress(0.2, "haptics: shells that follow contact");
  TryDynamicShell(context);
  context.progress(0.4, "haptics: levels");
  TryLevels(context);
  context.progress(0.6, "haptics: whole ticks");
  TrySteps(context);
  context.progress(0.8, "haptics: coarse phase");
  TryCoarsePhase(context);
  context.progress(0.9, "haptics: a device's driver");
  TryDriver(context);
  context.progress(0.0, "haptics: a loop of 1 kHz beside rendering");
  Rendering rendering;
  const double seconds = context.settings.soak ? 600.0 : context.settings.quick ? 2.0 : 30.0;
  TryLoop(
    context, seconds, [&rendering] { rendering.Draw(); }, Rendering::Text);
  AddUnusedHaptics(context);
}

} // namespace hasp
