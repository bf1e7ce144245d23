// Draws a ball without a mesh and without a display, and measures its picture.
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspHeadlessWindows.h"
#include "vtkHaspVolumeView.h"

#include "Grid/AnalyticVolumes.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numbers>

namespace
{

constexpr double RadiusMm = 9.0;

/// 26^3 samples of 1 mm around the origin.
vtkSmartPointer<vtkImageData> Ball()
{
  const hasp::GridGeometry grid{ .dims = glm::ivec3(26), .origin = glm::dvec3(-12.5) };
  const hasp::AnalyticVolume ball = hasp::AnalyticSphere(glm::dvec3(0.0), RadiusMm);
  return hasp::MakeImage(grid, hasp::SampleAnalytic<float>(ball, grid, 1.0, 0.0));
}

int LitPixels(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  const int* size = window->GetSize();
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  int lit = 0;
  for (vtkIdType p = 0; p + 2 < pixels->GetNumberOfValues(); p += 3)
    lit += pixels->GetValue(p) > 0;
  return lit;
}

} // namespace

int main()
{
  hasp::UseHeadlessWindows();
  vtkNew<vtkHaspClusteredCellMapper> mapper;
  mapper->SetInputData(Ball());
  mapper->SetIsoValue(0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->AddRenderer(renderer);
  window->SetSize(200, 200);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->GetActiveCamera()->SetParallelScale(12.5); // 8 pixels a millimetre
  window->Render();

  // A disc. The trilinear surface lies up to h^2 / 4r = 0.03 mm inside the ball: 0.6 % of the area.
  const double share = LitPixels(window) / (std::numbers::pi * std::pow(8.0 * RadiusMm, 2));
  std::cout << "share of the disc that is lit: " << share << "\n";
  return std::abs(share - 1.0) < 0.008 ? EXIT_SUCCESS : EXIT_FAILURE;
}
