#pragma once
#include "Grid/ResourceUse.h"

#include <memory>

namespace hasp
{

class SceneView;

/// The light of a 3D view: as VTK shades, darkened where bone and parts are close, or traced. While
/// something moves, traced light is what is kept on surfaces; at rest paths make it better, ten
/// frames a second until there are 256 a pixel, and give up at once when something moves. Complete
/// frames (FrameView::DrawNow) have all of them, and openness of the 64 frames that refine it.
///
/// Threads: RENDER. Plain light has nothing; the others what vtkHaspLightPass says, and its WORKER.
class ViewLight
{
public:
  enum Mode
  {
    Plain,
    AmbientOcclusion,
    Traced
  };
  /// Is there light but plain in this build?
  static bool IsThere();

  /// The view outlives this.
  explicit ViewLight(SceneView& view);
  ~ViewLight();
  ViewLight(const ViewLight&) = delete;
  ViewLight& operator=(const ViewLight&) = delete;

  /// What is not there stays Plain. That lets go of all that the others have, at once.
  void SetMode(Mode mode);
  Mode GetMode() const { return this->Chosen; }

  void Prepare(); ///< right before a frame
  bool Finish();  ///< right after one: true asks for one more now
  void ListResources(ResourceList& list) const;

private:
  struct Pass;
  bool Complete(); ///< as Finish, of a frame that is to be complete
  SceneView& Of;
  Mode Chosen = Plain;
  std::unique_ptr<Pass> Made;
};

} // namespace hasp
