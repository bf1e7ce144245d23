#pragma once
#include "View/FrameView.h"
#include "View/SliceAxis.h"
#include "View/SliceContours.h"
#include "View/SliceImage.h"
#include "View/SliceStyle.h"

#include <glm/vec3.hpp>

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace hasp
{

class SliceIsoline;

/// A slice of the scan in a plane of the patient, as radiologists see it (SliceAxis.h), through the
/// place of the crosshair.
///
///   wheel, left/right, b/f   the next slice: a step of the scan's spacing along the plane's normal
///   left drag                window (to the right: wider) and level (up: higher); without motion
///   it
///                            sets the crosshair
///   Shift + move             the crosshair, in all views
///   right drag, up/down      zooms (up: closer), about the place of the press, or the crosshair
///   middle, Shift+left       moves
///   Shift + arrows           window and level, as a drag that way
///   r                        all of the slice          v   the slice in the 3D view, and away
///   m, double click          asks for all of the space, or gives it back
///
/// Tools may have the mouse instead: observe interactor() and abort what you take. What the views
/// share (place, window, zoom) is asked for by signals and set by ViewGrid in all of them.
///
/// Threads: RENDER. World mm, patient LPS. Cost: an overlay that is not set is not made.
class SliceView : public FrameView
{
  Q_OBJECT
public:
  explicit SliceView(SliceAxis axis, QWidget* parent = nullptr);
  ~SliceView() override;

  /// nullptr: nothing. All of the slice is in sight then. `hounsfield`: grey values are shown as
  /// HU.
  void SetImage(vtkImageData* image, bool hounsfield);
  void SetPlace(const glm::dvec3& place); ///< of the crosshair; the slice goes through it
  void SetWindowLevel(double window, double level);
  void SetCrosshairVisible(bool visible);
  /// 1: all of the slice is in sight. `fixed` stays at its pixel. Within [0.05, 200].
  void SetZoom(double zoom, const glm::dvec3& fixed);
  void ResetView();

  ///@{
  /// Overlays. Labels: unsigned short, in the world like the scan, usually on its grid; colours and
  /// opacity in [0, 1]; labels without a colour, and 0, are not shown; nullptr: none. Images,
  /// surfaces and matrices are followed as they change: Draw after that.
  void SetLabels(
    vtkImageData* labels, const std::map<int, glm::dvec3>& colours, double opacity = 0.45);
  void SetContours(const std::vector<SliceContour>& contours);
  void SetIsovalueLine(const std::optional<double>& value);
  ///@}

  SliceAxis Axis() const { return this->Which; }
  /// For vtkHaspSeedPainter::SetSlice.
  vtkImageSlice* Prop() const { return this->Grey.Prop(); }
  /// What the middle of a pixel of the widget shows, in the plane of the slice.
  glm::dvec3 PlaceAt(const QPoint& pixel) const;
  double StepMm() const { return this->Step; } ///< to the next slice
  double Zoom() const { return this->Closer; }
  /// At the crosshair; nothing without an image.
  std::optional<double> GreyValue() const;
  QString PlaceText() const; ///< "S 12.3 mm"
  QString GreyText() const;  ///< "312 HU"

  bool IsShownInScene() const { return this->InScene; }
  void SetShownInScene(bool shown);

Q_SIGNALS:
  void PlaceAsked(const glm::dvec3& place);
  void WindowLevelAsked(double window, double level);
  void ZoomAsked(double zoom, const glm::dvec3& fixed);
  void ResetAsked();
  void ShownInSceneChanged(bool shown);

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void Prepare() override;
  void PaintMarks(QPainter& painter) override;

private:
  enum class Drag
  {
    None,
    Undecided, ///< the left button is down and has not moved: a click, so far
    WindowLevel,
    Move,
    Zoom
  };
  void PlaceCamera();
  void OnMouse(const SliceMouse& mouse);
  void BeginDrag(const SliceMouse& mouse);
  void ContinueDrag();
  void StepBy(int steps);
  void DragWindowLevel(const QPoint& moved); ///< pixels
  void DragZoom(int up, const glm::dvec3& fixed);
  bool AnswerShifted(int key);

  SliceAxis Which;
  const SliceFrame& Shape;
  vtkSmartPointer<vtkImageData> Shown;
  bool Hounsfield = false;
  double Step = 1.0, GreyRange = 1.0;
  glm::dvec3 At{ 0.0 }, Middle{ 0.0 }; ///< crosshair; what the view's middle shows
  double Closer = 1.0;
  double Window = 1000.0, Level = 400.0;
  bool CrossVisible = true, InScene = false;

  SliceImage Grey{ SliceImage::Kind::Grey };
  std::unique_ptr<SliceImage> Labels;
  std::unique_ptr<SliceContours> Contours;
  std::unique_ptr<SliceIsoline> Isoline;
  std::optional<double> Isovalue;

  Drag Now = Drag::None;
  QPoint DragFrom, DragAt;
  glm::dvec3 Fixed{ 0.0 }, BeforeClick{ 0.0 };
};

} // namespace hasp
