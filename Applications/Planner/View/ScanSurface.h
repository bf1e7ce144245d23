#pragma once
#include "View/SceneActor.h"

#include <map>
#include <memory>

namespace hasp
{

class ScanActor;

/// The isosurface of the plan's volume that is shown. While the isovalue moves rays find it, frame
/// by frame, or all active cells draw it where that is cheaper (vtkHaspRayCachingMapper); at rest
/// active cells do, and nothing is kept of the rays. Nothing is there while it is not visible, or
/// the brightest values are shown.
///
/// Threads: RENDER. Cells of a rested isovalue: O(active blocks), 0.1 to 0.3 s for 512^3 samples.
class ScanSurface : public SceneLayer
{
public:
  explicit ScanSurface(SceneContext& of);
  ~ScanSurface() override;

  ///@{
  /// Of the volume that is shown. Until it is said: that of its first fragment; else 226 of
  /// Hounsfield units, and of other values ProposeThreshold's, found once.
  double Isovalue() const;
  void SetIsovalue(double value, bool moving);
  ///@}
  ///@{
  /// One that the plan has not: its first; 0: none.
  PlanId Volume() const;
  void SetVolume(PlanId volume) { this->Asked = volume; }
  ///@}
  vtkImageData* Image() const; ///< nullptr: not in memory
  void Forget();               ///< another plan

  bool Sync() override;
  vtkProp3D* PropOf(PlanId object) const override;
  void Pick(const SceneRay& ray, std::optional<SceneHit>& nearest) const override;
  void AddBounds(vtkBoundingBox& box) const override;
  bool IsRefining() const override;
  void ListResources(ResourceList& list) const override;

private:
  PlanId Asked = 0;
  bool Moving = false;
  mutable std::map<PlanId, double> Isovalues; ///< said, or found
  std::unique_ptr<ScanActor> Shown;
};

} // namespace hasp
