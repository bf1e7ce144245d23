// Draws a ball without a display and says how much of the picture it fills.
#include "vtkHaspHeadlessWindows.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>
#include <iostream>

int main()
{
  hasp::UseHeadlessWindows();
  vtkNew<vtkSphereSource> ball;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(100, 100);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, 99, 99, 1, pixels);
  int lit = 0;
  for (vtkIdType p = 0; p + 2 < pixels->GetNumberOfValues(); p += 3)
    lit += pixels->GetValue(p) > 0;
  std::cout << "lit pixels: " << lit << "\n";
  return lit > 1000 && lit < 9000 ? EXIT_SUCCESS : EXIT_FAILURE;
}
