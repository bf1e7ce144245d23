#include "vtkHaspOpenXR.h"

#include "vtkNew.h"
#include "vtkOpenXRCamera.h"
#include "vtkOpenXRRenderWindow.h"
#include "vtkOpenXRRenderWindowInteractor.h"
#include "vtkOpenXRRenderer.h"

namespace hasp
{

std::string WhyNoOpenXR()
{
  return {};
}

OpenXRView MakeOpenXRView()
{
  vtkNew<vtkOpenXRRenderer> renderer;
  vtkNew<vtkOpenXRRenderWindow> window;
  vtkNew<vtkOpenXRRenderWindowInteractor> interactor;
  vtkNew<vtkOpenXRCamera> camera;
  renderer->SetActiveCamera(camera);
  window->AddRenderer(renderer);
  interactor->SetRenderWindow(window);
  return { renderer.Get(), window.Get(), interactor.Get() };
}

} // namespace hasp
