#pragma once
#include "View/SceneLayer.h"

#include "vtkSmartPointer.h"

class vtkVolume;

namespace hasp
{

class ScanSurface;

/// The brightest value along each line of sight through the volume that is shown, in white
/// (MakeBrightest, UsualLook). What is opaque ends the lines, so the scan's own isosurface is not
/// shown with it (SceneContext::brightest); translucent things lie behind it. It is not picked.
/// Nothing is there while it is off.
///
/// Threads: RENDER. The samples once more on the GPU; where OpenGL is software, 0.8 s a frame of
/// 800 x 800 pixels.
class BrightestVolume : public SceneLayer
{
public:
  /// The scan says which volume is shown, and outlives this.
  BrightestVolume(SceneContext& of, const ScanSurface& scan) : SceneLayer(of), Scan(scan) {}
  ~BrightestVolume() override;

  bool Sync() override;
  void AddBounds(vtkBoundingBox& box) const override;
  void ListResources(ResourceList& list) const override;

private:
  void Make(vtkImageData* image, PlanId volume);
  void Release();

  const ScanSurface& Scan;
  vtkSmartPointer<vtkVolume> Shown;
  vtkSmartPointer<vtkImageData> Image; ///< that is shown, or cannot be
  std::string Refusal;                 ///< why it cannot be
};

} // namespace hasp
