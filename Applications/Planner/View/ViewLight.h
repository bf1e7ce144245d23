#pragma once
#include "Grid/ResourceUse.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace hasp
{

class SceneView;

/// The light of a 3D view: as VTK shades, darkened where bone and parts are close, or traced. While
/// something moves, traced light is what is kept on surfaces; at rest paths make it better, ten
/// frames a second until there are 256 a pixel, and give up at once when something moves.
///
/// Threads: RENDER. Plain light has nothing; the others what vtkHaspLightPass says, and its WORKER.
class ViewLight : public QObject
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
  ~ViewLight() override;

  void SetMode(Mode mode); ///< what is not there stays Plain
  Mode GetMode() const { return this->Chosen; }

  void Prepare(); ///< right before a frame
  bool Finish();  ///< right after one: true asks for one more now
  void ListResources(ResourceList& list) const;

private:
  struct Pass;
  SceneView& Of;
  Mode Chosen = Plain;
  std::unique_ptr<Pass> Made;
  QTimer Better; ///< asks for frames while paths are traced
};

} // namespace hasp
