// A ball broken into four labels, each with a colour: one stays, one is turned and carried off, one
// is translucent, one is carried through a cone. A clipping plane cuts all.
#include "PictureScene.h"

#include "vtkConeSource.h"
#include "vtkPlane.h"
#include "vtkTransform.h"

int TestCellLabelPoses(int argc, char* argv[])
{
  hasp::testing::PictureScene scene;
  const auto g = hasp::testing::CenteredGrid({ 56, 56, 56 });
  const auto image = hasp::MakeImage(
    g, hasp::SampleAnalytic<std::int16_t>(hasp::AnalyticSphere({ 0, 0, 0 }, 22), g, 100, 0));
  hasp::testing::AddPointArray<vtkUnsignedCharArray>(
    image, "label", [](const glm::dvec3& p) { return 1 + (p.x > 0.3 * p.y) + 2 * (p.z > 0); });
  const auto mapper = scene.Add(image, 0);
  mapper->SetLabelArrayName("label");
  mapper->SetLabelColor(1, 0.8, 0.3, 0.25);
  mapper->SetLabelColor(2, 0.3, 0.6, 0.9, 0.45);
  mapper->SetLabelColor(3, 0.4, 0.8, 0.4);
  mapper->SetLabelColor(4, 0.95, 0.8, 0.3);
  vtkNew<vtkTransform> pose;
  pose->Translate(-26, -6, 12);
  pose->RotateY(-50);
  mapper->SetLabelPose(3, pose);
  pose->Identity();
  pose->Translate(30, 0, 14);
  pose->RotateWXYZ(70, 1, 0.5, 0);
  mapper->SetLabelPose(4, pose);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0, -16, 0);
  plane->SetNormal(0, 1, 0);
  mapper->AddClippingPlane(plane);

  vtkNew<vtkConeSource> cone;
  cone->SetCenter(42, 0, 22);
  cone->SetHeight(50);
  cone->SetRadius(7);
  cone->SetResolution(60);
  vtkNew<vtkPolyDataMapper> coneMapper;
  coneMapper->SetInputConnection(cone->GetOutputPort());
  vtkNew<vtkActor> coneActor;
  coneActor->SetMapper(coneMapper);
  scene.Renderer->AddActor(coneActor);
  scene.Look({ 25, -190, 70 }, { 2, 0, 8 });
  return hasp::CheckPicture(scene.Window, argc, argv);
}
