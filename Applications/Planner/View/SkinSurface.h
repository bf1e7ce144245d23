#pragma once
#include "View/SceneLayer.h"

#include <map>
#include <memory>

namespace hasp
{

class CellProp;
class ScanSurface;

/// The skin of the volume that is shown: the isosurface between air and soft tissue, translucent
/// over bone (VTK's order-independent translucency, as ghosts), by active cells. Picks and tools go
/// through it. Nothing is there while it is off.
///
/// Threads: RENDER. Cells of a value, at its first frame: O(active blocks), 0.1 to 0.3 s for 512^3
/// samples.
class SkinSurface : public SceneLayer
{
public:
  /// The scan says which volume is shown, and outlives this.
  SkinSurface(SceneContext& of, const ScanSurface& scan);
  ~SkinSurface() override;

  ///@{
  /// As the user has it, of whichever plan. Sync makes or releases it.
  void SetShown(bool shown) { this->On = shown; }
  bool IsShown() const { return this->On; }
  ///@}
  ///@{
  /// Of the volume that is shown, in its values; it takes effect by Sync. Until it is said: -300 of
  /// Hounsfield units; of other values midway between the least of them and the soft tissue that
  /// ProposeThreshold finds, or of all where it finds none.
  double Value() const;
  void SetValue(double value);
  ///@}
  void Forget() { this->Values.clear(); } ///< another plan

  bool Sync() override;
  void AddBounds(vtkBoundingBox& box) const override;
  void ListResources(ResourceList& list) const override;

private:
  const ScanSurface& Scan;
  bool On = false;
  mutable std::map<PlanId, double> Values; ///< said, or found
  std::unique_ptr<CellProp> Shown;
};

} // namespace hasp
