#pragma once
#include "View/FrameView.h"

#include <optional>

#include <glm/vec3.hpp>

namespace hasp
{

/// The 3D view: a trackball, light for bone, and over the picture a cube that says how one looks at
/// the patient, the crosshair, and in parallel projection a ruler.
///
///   left drag          turns          Shift+left, middle   moves
///   right drag, wheel  zooms          Ctrl+left            rolls
///   arrows             turn           PageUp, PageDown     zoom
///   r                  all in sight   f                    turns about what is under the pointer
///   w, s               wireframe, surface of VTK's own meshes
///   5                  parallel projection and back
///   m, double click    asks for all of the space, or gives it back
///
/// VTK's other keys do nothing here and go to the window: e and q close nothing.
///
/// Threads: RENDER. Frames and their number of pixels: FrameView.
class SceneView : public FrameView
{
  Q_OBJECT
public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  /// All that is visible in sight, seen from where it is seen now.
  void ResetView();
  ///@{
  /// What is at the focal point keeps its size.
  void SetParallel(bool parallel);
  bool IsParallel() const;
  ///@}
  /// A place of the world, mm, marked through all that hides it; nothing: no mark. No frame.
  void SetCrosshair(const std::optional<glm::dvec3>& place);

Q_SIGNALS:
  void ParallelChanged(bool parallel);

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void Prepare() override;
  void PaintMarks(QPainter& painter) override;

private:
  void SetWireframe(bool wireframe);
  void TurnAboutPointer();
  void Turn(double azimuth, double elevation); ///< degrees
  void Zoom(double closer);
  void PaintCrosshair(QPainter& painter) const;

  std::optional<glm::dvec3> Cross;
};

} // namespace hasp
