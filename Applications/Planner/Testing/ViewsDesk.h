#pragma once
#include "View/SceneView.h"
#include "View/SliceView.h"
#include "View/ViewGrid.h"

#include "Grid/GridGeometry.h"
#include "vtkSmartPointer.h"

#include <QImage>

#include <functional>

class vtkImageData;

namespace hasp::testing
{

/// The four views in a window on the screen, and a hand with a mouse. Places are pixels of a view.
class ViewsDesk
{
public:
  explicit ViewsDesk(vtkImageData* image = nullptr, bool hounsfield = true);

  ViewGrid grid;
  SceneView& scene;
  SliceView& axial;
  SliceView& coronal;
  SliceView& sagittal;

  /// Until all that was asked for is drawn.
  void Settle();
  /// Until `what`, as long as a patient user waits. False: it did not come.
  bool Wait(const std::function<bool()>& what, int mostMs = 10'000);

  void Press(QWidget& view, const QPoint& at, Qt::MouseButton button = Qt::LeftButton,
    Qt::KeyboardModifiers keys = {});
  void Move(QWidget& view, const QPoint& to);
  void Release(QWidget& view, const QPoint& at, Qt::MouseButton button = Qt::LeftButton,
    Qt::KeyboardModifiers keys = {});
  /// In ten moves.
  void Drag(QWidget& view, const QPoint& from, const QPoint& to,
    Qt::MouseButton button = Qt::LeftButton, Qt::KeyboardModifiers keys = {});
  void Click(QWidget& view, const QPoint& at);
  void DoubleClick(QWidget& view, const QPoint& at);
  /// A move without a button, with keys held.
  void Hover(QWidget& view, const QPoint& to, Qt::KeyboardModifiers keys);
  void Wheel(QWidget& view, int notches);
  void Key(QWidget& view, Qt::Key key);
};

/// What a view draws, without what is written over it.
QImage Drawn(FrameView& view);
QPoint MiddleOf(const QWidget& view);

/// A grid turned about all axes of the world, of 0.5 x 0.7 mm and slices, around the origin.
/// `mirrored`: its slices are stored the other way round.
GridGeometry TurnedGrid(bool mirrored = false, int slices = 4, double thicknessMm = 50.0);
/// Upright, 1 x 1 x 2 mm, around the origin.
GridGeometry UprightGrid();
/// Of a function of the world; float.
vtkSmartPointer<vtkImageData> ImageOf(
  const GridGeometry& grid, const std::function<double(const glm::dvec3&)>& value);

/// Linear, so that interpolation between samples gives it exactly.
inline double Ramp(const glm::dvec3& place)
{
  return 3.0 * place.x - 2.0 * place.y + 5.0 * place.z + 100.0;
}

} // namespace hasp::testing
