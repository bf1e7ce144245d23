#pragma once
#include "HeadChoices.h"
#include "StereoChoices.h"

#include <QTimer>
#include <QWidget>

#include <memory>

class QVTKOpenGLNativeWidget;

namespace hasp
{

class SceneView;
class StereoView;

/// The 3D view's scene for two eyes, in a window of its own: on a second screen, or full screen
/// (F11; Esc and 3 close it). It draws when the 3D view does, and when a tracked head has moved;
/// mouse and keys stay with the 3D view. Quad-buffered and dual windows are `hasp view`'s: Qt's
/// widgets have neither.
///
/// Threads: RENDER. Cost: two eyes a frame and the textures of vtkHaspStereoWindows while it is
/// open; a timer while a head is tracked; nothing when it is closed.
class StereoWindowWidget : public QWidget
{
  Q_OBJECT
public:
  /// Throws Failure for choices that do not go together, and for a tracker that cannot be opened.
  StereoWindowWidget(
    SceneView& scene, const StereoChoices& choices, const HeadChoices& head, QWidget* parent);
  ~StereoWindowWidget() override;

  void Draw();
  StereoView& Eyes() { return *this->View; }

Q_SIGNALS:
  void Closed();
  void Warned(const QString& text); ///< of the head's tracker; of a picture that stays

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override; ///< a head that is the mouse
  void closeEvent(QCloseEvent* event) override;

private:
  QVTKOpenGLNativeWidget* Shown;
  std::unique_ptr<StereoView> View;
  QTimer Head;
  bool Stays = false; ///< the picture could not be drawn anew, and that has been said
};

} // namespace hasp
