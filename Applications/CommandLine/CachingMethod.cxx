#include "CachingMethod.h"

#include "vtkActor.h"
#include "vtkImageData.h"

namespace hasp
{

CachingMethod::CachingMethod(const IsosurfaceView& view, int mode)
  : WindowMethod(view),
    Mapper(vtkSmartPointer<vtkHaspRayCachingMapper>::New())
{
  this->Mapper->SetInputData(view.image);
  this->Mapper->SetIsoValue(view.isovalue);
  this->Mapper->SetMode(mode);
  vtkNew<vtkActor> actor;
  actor->SetMapper(this->Mapper);
  this->Renderer->AddActor(actor);
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
    this->Draw();
    quiet = this->Mapper->IsRefining() ? 0 : quiet + 1;
  }
  return frame;
}

} // namespace hasp
