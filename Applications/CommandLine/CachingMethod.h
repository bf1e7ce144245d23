#pragma once
#include "WindowMethod.h"
#include "vtkHaspRayCachingMapper.h"

namespace hasp
{

/// vtkHaspRayCachingMapper in one of its modes.
class CachingMethod : public WindowMethod
{
public:
  /// mode: of vtkHaspRayCachingMapper::Modes.
  CachingMethod(const IsosurfaceView& view, int mode);
  void SetIsovalue(double isovalue) override { this->Mapper->SetIsoValue(isovalue); }
  std::string Name() const override;
  ResourceList Resources() const override;

  vtkHaspRayCachingMapper* operator->() const { return this->Mapper; }
  /// Frames until it finds nothing new, at most `most`.
  int Converge(int most);

private:
  vtkSmartPointer<vtkHaspRayCachingMapper> Mapper;
};

} // namespace hasp
