#pragma once
#include "WindowMethod.h"
#include "vtkHaspRayCachingMapper.h"

#include "vtkActor.h"

namespace hasp
{

/// vtkHaspRayCachingMapper in one of its modes.
class CachingMethod : public WindowMethod
{
public:
  /// mode: of vtkHaspRayCachingMapper::Modes.
  CachingMethod(const IsosurfaceView& view, int mode);
  /// Throws Failure: CannotDraw where this OpenGL has active cells stand in for a raycast.
  void Draw() override;
  void SetIsovalue(double isovalue) override { this->Mapper->SetIsoValue(isovalue); }
  std::string Name() const override;
  ResourceList Resources() const override;

  vtkHaspRayCachingMapper* operator->() const { return this->Mapper; }
  /// Frames until it finds nothing new, at most `most`.
  int Converge(int most);
  /// From one side, unit and towards the light, in the world, with a hard shadow; without it the
  /// eye has a lamp. What lies within `darkeningMm` darkens what it is, `ambient` and `diffuse`.
  void Light(const glm::dvec3& towardsLight, double darkeningMm, double ambient, double diffuse);

private:
  vtkNew<vtkActor> Actor;
  vtkSmartPointer<vtkHaspRayCachingMapper> Mapper;
};

} // namespace hasp
