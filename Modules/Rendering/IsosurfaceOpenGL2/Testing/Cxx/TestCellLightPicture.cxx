// A ball and a gyroid over a floor, one volume: plain, with ambient occlusion, with a hard shadow,
// with both. A cone stands through the last: depth is written as ever. Sixteen frames, so that the
// light has added up.
#include "PictureScene.h"

#include "vtkConeSource.h"
#include "vtkLight.h"

#include <algorithm>

int TestCellLightPicture(int argc, char* argv[])
{
  hasp::testing::PictureScene scene;
  const auto g = hasp::testing::CenteredGrid({ 50, 50, 44 });
  const auto ball = hasp::AnalyticSphere({ -7, -6, -4 }, 9);
  const auto gyroid = hasp::AnalyticGyroid(11);
  const hasp::AnalyticVolume shape{ "table", [&](const glm::dvec3& p)
    {
      const double table =
        std::min({ -15.5 - p.z, p.z + 19.0, 22.0 - std::abs(p.x), 22.0 - std::abs(p.y) });
      const double block = std::min({ gyroid.value(p), 8.0 - std::abs(p.x - 11),
        8.0 - std::abs(p.y - 8), 12.0 - std::abs(p.z + 4) });
      return std::max({ table, block, ball.value(p) });
    } };
  const auto image = hasp::MakeImage(g, hasp::SampleAnalytic<std::int16_t>(shape, g, 100, 0));
  for (int n = 0; n < 4; ++n)
  {
    const auto mapper = scene.Add(image, 0, { n % 2 ? 25.0 : -25.0, 0, n / 2 ? -19.0 : 19.0 });
    mapper->SetRendererToTrace();
    mapper->SetAmbientOcclusion(n & 1);
    mapper->SetShadows(n & 2);
  }
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(25, 0, -19);
  cone->SetHeight(50);
  cone->SetRadius(6);
  cone->SetResolution(60);
  cone->SetDirection(0.3, 0, 1);
  vtkNew<vtkPolyDataMapper> coneMapper;
  coneMapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> coneActor;
  coneActor->SetMapper(coneMapper);
  coneActor->GetProperty()->SetColor(0.3, 0.7, 0.4);
  scene.Renderer->AddActor(coneActor);
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->SetPosition(-60, -60, 90);
  lamp->SetFocalPoint(0, 0, 0);
  scene.Renderer->AddLight(lamp);
  for (int frame = 0; frame < 16; ++frame)
    scene.Look({ 22, -180, 72 }, { 0, 0, 0 });
  return hasp::CheckPicture(scene.Window, argc, argv);
}
