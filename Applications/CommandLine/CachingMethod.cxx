#include "CachingMethod.h"

#include "Failure.h"

#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkProperty.h"

namespace hasp
{

CachingMethod::CachingMethod(const IsosurfaceView& view, int mode)
  : WindowMethod(view),
    Mapper(vtkSmartPointer<vtkHaspRayCachingMapper>::New())
{
  this->Mapper->SetInputData(view.image);
  this->Mapper->SetIsoValue(view.isovalue);
  this->Mapper->SetMode(mode);
  this->Actor->SetMapper(this->Mapper);
  this->Renderer->AddActor(this->Actor);
}

void CachingMethod::Draw()
{
  WindowMethod::Draw();
  const int mode = this->Mapper->GetMode();
  const bool raycast =
    mode == vtkHaspRayCachingMapper::Raycast || mode == vtkHaspRayCachingMapper::RaycastSkipping;
  if (const std::string drew = this->Mapper->GetModeChoice();
      raycast && !drew.starts_with("raycast"))
    throw Failure(ExitCode::CannotDraw, "raycasts cannot be measured: " + drew);
}

std::string CachingMethod::Name() const
{
  return "ray caching, " + this->Mapper->GetModeChoice();
}

ResourceList CachingMethod::Resources() const
{
  ResourceList list;
  this->Mapper->ListResources(list);
  return list;
}

int CachingMethod::Converge(int most)
{
  constexpr int enough = 8; // frames without a find
  int frame = 0;
  for (int quiet = 0; frame < most && quiet < enough; ++frame)
  {
    CachingMethod::Draw(); // what derives may draw by converging
    quiet = this->Mapper->IsRefining() ? 0 : quiet + 1;
  }
  return frame;
}

void CachingMethod::Light(
  const glm::dvec3& towardsLight, double darkeningMm, double ambient, double diffuse)
{
  this->Actor->GetProperty()->SetAmbient(ambient);
  this->Actor->GetProperty()->SetDiffuse(diffuse);
  vtkNew<vtkLight> light; // directional
  light->SetLightTypeToSceneLight();
  light->SetPosition(towardsLight.x, towardsLight.y, towardsLight.z);
  light->SetFocalPoint(0, 0, 0);
  this->Renderer->AddLight(light);
  this->Mapper->AmbientOcclusionOn();
  this->Mapper->SetAmbientOcclusionDistance(darkeningMm);
  this->Mapper->ShadowsOn();
}

} // namespace hasp
