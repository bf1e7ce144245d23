#pragma once
#include "Grid/ResourceUse.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

class vtkRenderer;

namespace hasp
{

struct SurfaceDrawing;

/// Light of paths that a scene asks for.
struct LightChoices
{
  std::optional<int> pathSamples; ///< of a pixel; nothing: no paths
  int bounces = 3;
  std::string environment; ///< .hdr file; empty: daylight
  bool eyesApart = false;  ///< two eyes are drawn in turn, or by two renderers: nothing is shared
};

/// Do all surfaces of a scene share one light: paths, or the mappers' own light where there are
/// several surfaces, which shade each other?
bool SharesLight(const LightChoices& light, const SurfaceDrawing& drawing, std::size_t surfaces);

/// One light for all that a renderer shows (vtkHaspLightPass), in builds that have it. RENDER
/// thread.
class SceneLight
{
public:
  /// Sets the renderer's pass; the renderer must outlive this. Throws Failure: BadInput for a file
  /// that is no environment, CannotDraw in a build without Embree.
  SceneLight(vtkRenderer* renderer, const LightChoices& light, const SurfaceDrawing& drawing);
  /// Frees what the pass holds on the GPU if the renderer is still in a window, which then is
  /// current.
  ~SceneLight();
  SceneLight(const SceneLight&) = delete;
  SceneLight& operator=(const SceneLight&) = delete;

  /// Will paths of the same view be better? They are traced on a thread of their own.
  bool Refining() const;
  /// Does a frame end only when a path traced picture has all its samples? At first if the drawing
  /// is not interactive.
  void SetWaitForSamples(bool wait);
  /// Share of a path traced picture's samples, while its frame is drawn.
  void SetProgress(std::function<void(double share)> progress);
  void ListResources(ResourceList& list) const;

private:
  struct Parts;
  std::unique_ptr<Parts> Self;
};

} // namespace hasp
