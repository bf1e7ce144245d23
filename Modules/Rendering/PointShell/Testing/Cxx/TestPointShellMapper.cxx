// Three pointshells: a ball's static one, its levels coloured; discs of a torus, rotated and scaled
// unevenly, cut by a clipping plane; and a vtkPolyData with normals. An opaque cone stands through
// the ball and a plate behind all.
#include "DiscScene.h"
#include "Haptics/PointShell.h"
#include "HaspRenderTest.h"

#include "vtkConeSource.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

namespace
{

std::shared_ptr<std::vector<hasp::ShellDisc>> TorusDiscs(double large, double small)
{
  auto discs = std::make_shared<std::vector<hasp::ShellDisc>>();
  constexpr int around = 120, across = 40;
  for (int a = 0; a < around; ++a)
    for (int b = 0; b < across; ++b)
    {
      const double pi = std::numbers::pi, u = 2 * pi * a / around,
                   v = 2 * pi * (b + 0.5 * (a % 2)) / across;
      const glm::dvec3 out(std::cos(u), std::sin(u), 0),
        normal = std::cos(v) * out + glm::dvec3(0, 0, std::sin(v));
      const double area =
        (2 * pi * small / across) * (2 * pi * (large + small * std::cos(v)) / around);
      discs->push_back({ large * out + small * normal, static_cast<float>(area), normal, 0 });
    }
  return discs;
}

void AddMesh(vtkRenderer* renderer, vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.3, 0.7, 0.4);
  renderer->AddActor(actor);
}

} // namespace

int TestPointShellMapper(int argc, char* argv[])
{
  hasp::testing::DiscScene scene;
  scene.Window->SetSize(480, 240);
  scene.Renderer->SetBackground(0.1, 0.15, 0.2);

  std::vector<hasp::SurfacePoint> points;
  const auto discs = hasp::testing::SphereDiscs(1024, 12);
  for (const hasp::ShellDisc& disc : *discs)
    points.push_back({ disc.center, disc.normal });
  const double area = 4 * std::numbers::pi * 12 * 12;
  scene.Mapper->SetPointShell(
    hasp::PointShell::OfPoints(points, area, glm::dvec3(0.0), { 1024, 64, 1 }));
  scene.Mapper->ColorByLevelOn();
  scene.Actor->SetPosition(-30, 0, 0);

  vtkNew<vtkHaspPointShellMapper> torus;
  torus->SetDiscs(TorusDiscs(10, 4));
  vtkNew<vtkPlane> cut;
  cut->SetNormal(-1, 0.3, 0);
  cut->SetOrigin(6, 0, 0);
  torus->AddClippingPlane(cut);
  vtkNew<vtkActor> torusActor;
  torusActor->SetMapper(torus);
  torusActor->RotateX(-50);
  torusActor->SetScale(1, 1, 0.6);
  torusActor->GetProperty()->SetColor(0.9, 0.85, 0.7);
  torusActor->GetProperty()->SetSpecular(0.4);
  torusActor->GetProperty()->SetSpecularPower(30);
  scene.Renderer->AddActor(torusActor);

  vtkNew<vtkSphereSource> ball;
  ball->SetThetaResolution(40);
  ball->SetPhiResolution(30);
  ball->SetRadius(11);
  vtkNew<vtkHaspPointShellMapper> mesh;
  mesh->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> meshActor;
  meshActor->SetMapper(mesh);
  meshActor->SetPosition(30, 0, 0);
  meshActor->GetProperty()->SetColor(0.5, 0.6, 0.9);
  meshActor->GetProperty()->SetOpacity(0.6);
  scene.Renderer->AddActor(meshActor);

  vtkNew<vtkConeSource> cone;
  cone->SetCenter(-30, 0, 0);
  cone->SetHeight(40);
  cone->SetRadius(6);
  cone->SetResolution(60);
  cone->SetDirection(0.5, 1, 0.6);
  AddMesh(scene.Renderer, cone);
  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(15, -20, -8);
  plate->SetPoint1(30, -20, -8);
  plate->SetPoint2(15, 20, -8);
  AddMesh(scene.Renderer, plate);

  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(10, 20, 110);
  scene.Renderer->ResetCameraClippingRange();
  scene.Window->Render();
  if (!scene.Errors.empty())
    return 1;
  return hasp::CheckPicture(scene.Window, argc, argv);
}
