#pragma once
#include "Grid/Progress.h"
#include "View/QtRenderWindow.h"

#include "vtkNew.h"

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <array>
#include <exception>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

class QPainter;
class vtkRenderer;

namespace hasp
{

class ViewMarks;

/// A VTK view in the window that draws when it is asked to and never otherwise: as many Draw as you
/// like become one frame. What VTK's interactors, widgets and painters ask for by their Render
/// comes the same way. A view that is hidden draws once it is seen.
///
/// While something moves (a drag, a wheel, a tool in hand) it draws fewer pixels, so that frames
/// keep coming: from all down to half of them along each axis, by how long the last frame took; 300
/// ms after the last motion it draws all again. Within a drag the number of pixels stays: it is
/// chosen before anybody sees the press, so that places in pixels of one drag can be compared.
/// Places of interactors are in pixels of the render window as it is then.
///
/// Threads: RENDER. Cost: at rest nothing is drawn and no timer runs.
class FrameView : public QVTKOpenGLNativeWidget
{
  Q_OBJECT
public:
  explicit FrameView(QWidget* parent = nullptr);
  ~FrameView() override;

  vtkRenderer* Renderer() const { return this->Scene; }
  /// A frame soon, 120 a second at most. Safe anywhere on RENDER, also within a frame.
  void Draw();
  /// A frame after that time, unless one comes before.
  void DrawIn(int ms) { this->Later.start(ms); }
  /// A frame now, complete: of all pixels, refined, as at rest whatever moves. Nothing while the
  /// view is not seen. Where light is traced this takes seconds to minutes; `progress`, which draws
  /// nothing, is told of that and may end it: Cancelled, and the view goes on as ever.
  void DrawNow(const ProgressFunction& progress = {});
  /// The same as a picture, with marks and letters; null while the view is not seen.
  QImage Picture(const ProgressFunction& progress = {});
  /// Something moves: frames may have fewer pixels until 300 ms after the last call.
  void Moving();
  bool IsMoving() const { return this->Settling.isActive(); }
  /// A frame is to come.
  bool IsWaiting() const
  {
    return this->Coming.isActive() || this->Later.isActive() || this->Settling.isActive();
  }

  /// Called before each frame, and after it: true asks for one more (a mapper that refines).
  std::function<void()> before;
  std::function<bool()> after;
  ///@{
  /// For these two, and what is drawn between them: is it a frame of DrawNow, and the share of it
  /// that is there; false, also where it is none: nobody waits for the rest.
  bool IsCompleting() const { return this->Awaited != nullptr; }
  bool Report(double share);
  ///@}

  /// Frames drawn since it was made; milliseconds of the last one but DrawNow's; pixels along an
  /// axis, of all, in [0.5, 1].
  unsigned long long Frames() const { return this->Drawn; }
  double LastMs() const { return this->Took; }
  double Share() const { return this->Scale; }
  /// At least so many frames a second are aimed at while something moves; default 20. 0: always all
  /// pixels.
  double framesAimed = 20.0;

  /// Where a place of the world (mm) is seen, in pixels of the widget from its upper left; nothing
  /// behind the viewer.
  std::optional<QPointF> PixelOf(const glm::dvec3& world) const;
  /// Of the widget's pixels, in the plane of the camera's focal point.
  double MmPerPixel() const;

Q_SIGNALS:
  void Shown(); ///< after each frame
  /// The left button, not where a tool or widget has taken it; or the key m.
  void DoubleClicked();

protected:
  bool event(QEvent* event) override;
  void paintGL() override;
  void keyPressEvent(QKeyEvent* event) override;

  virtual void Prepare() {}                          ///< right before a frame, after `before`
  virtual void PaintMarks(QPainter&) {}              ///< over the picture, pixels of the widget
  void MarksChanged();                               ///< PaintMarks again, without a frame
  const QPoint& Pointer() const { return this->At; } ///< of the mouse, at the last event
  bool IsHeld() const { return this->Held != Qt::NoButton; }
  /// The press that is just being told is the second one of a double click. To VTK it is a press as
  /// any other: tools would lose it, for VTK 9.1 has an event of its own for those.
  bool IsSecondPress() const { return this->SecondPress; }

private:
  void Frame();         ///< if it can be seen
  void DrawFrame();     ///< in any case
  bool IsStale() const; ///< the last frame is of another size, or was asked for while hidden
  double NextShare() const;
  void Rescale(double scale);
  void Settle();
  void MouseComes(const QMouseEvent& event);
  bool Tell(QEvent* event); ///< VTK, and Qt
  void SeePress();

  vtkNew<QtRenderWindow> Target;
  vtkNew<vtkRenderer> Scene;
  ViewMarks* Marks;
  std::vector<unsigned long> Observers; ///< of the interactor
  QTimer Coming, Later, Settling;
  const ProgressFunction* Awaited = nullptr; ///< DrawNow's
  std::exception_ptr GivenUp;                ///< what it said
  QElapsedTimer SinceFrame;
  unsigned long long Drawn = 0;
  double Took = 0.0, Scale = 1.0;
  std::array<int, 2> DrawnSize{};
  Qt::MouseButtons Held;
  QPoint At;
  bool Drawing = false, Missed = false;
  bool Waited = false;    ///< with settling, for a frame, since the last motion
  bool PressSeen = false; ///< nobody has taken the press that is just being told
  bool SecondPress = false;
};

} // namespace hasp
