// A ball and a torus in few grey levels: left as they are, with facets, right with blended normals.
// A plane behind and a cone through the right one: depth is written as ever.
#include "PictureScene.h"

#include "vtkConeSource.h"

#include <cmath>

int TestCellBlendedNormals(int argc, char* argv[])
{
  hasp::testing::PictureScene scene;
  const auto g = hasp::testing::CenteredGrid({ 34, 34, 34 });
  for (int n = 0; n < 4; ++n)
  {
    const auto shape = n % 2 == 0 ? hasp::AnalyticSphere({ 0, 0, 0 }, 13)
                                  : hasp::AnalyticTorus({ 0, 0, 0 }, { 0, 1, 0 }, 10, 4);
    std::vector<std::uint8_t> samples;
    for (const float value : hasp::SampleAnalytic<float>(shape, g, 1, 0))
      samples.push_back(static_cast<std::uint8_t>(std::round(128 + 4 * value)));
    const auto mapper =
      scene.Add(hasp::MakeImage(g, samples), 128, { n < 2 ? -17 : 17, 0, n % 2 ? -15 : 15 });
    mapper->SetBlendNormals(n >= 2);
  }
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(17, 0, 15);
  cone->SetHeight(44);
  cone->SetRadius(6);
  cone->SetResolution(60);
  cone->SetDirection(0.3, 0, 1);
  vtkNew<vtkPolyDataMapper> coneMapper;
  coneMapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> coneActor;
  coneActor->SetMapper(coneMapper);
  coneActor->GetProperty()->SetColor(0.3, 0.7, 0.4);
  scene.Renderer->AddActor(coneActor);
  scene.Look({ 20, -150, 40 }, { 0, 0, 0 });
  return hasp::CheckPicture(scene.Window, argc, argv);
}
