#include "ViewsDesk.h"

#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QWheelEvent>
#include <QWindow>
#include <QtTest>

#include <cmath>
#include <stdexcept>
#include <vector>

#include <glm/geometric.hpp>

namespace hasp::testing
{

namespace
{

QWindow* WindowOf(const QWidget& view)
{
  return view.window()->windowHandle();
}

QPoint InWindow(const QWidget& view, const QPoint& at)
{
  return view.mapTo(view.window(), at);
}

} // namespace

ViewsDesk::ViewsDesk(vtkImageData* image, bool hounsfield)
  : scene(this->grid.Scene()),
    axial(this->grid.Slice(SliceAxis::Axial)),
    coronal(this->grid.Slice(SliceAxis::Coronal)),
    sagittal(this->grid.Slice(SliceAxis::Sagittal))
{
  this->grid.resize(606, 486);
  if (image)
    this->grid.SetImage(image, hounsfield);
  this->grid.show();
  QApplication::setActiveWindow(&this->grid); // there is no window manager
  if (!QTest::qWaitForWindowExposed(&this->grid))
    throw std::runtime_error("the window did not open");
  this->Settle();
}

void ViewsDesk::Settle()
{
  const auto frames = [this]
  {
    return this->scene.Frames() + this->axial.Frames() + this->coronal.Frames() +
           this->sagittal.Frames();
  };
  // Two rounds of the event loop without a frame: timers of a frame are 8 ms at most.
  for (unsigned long long before = frames() - 1; frames() != before;)
  {
    before = frames();
    QTest::qWait(40);
  }
}

bool ViewsDesk::Wait(const std::function<bool()>& what, int mostMs)
{
  return QTest::qWaitFor(what, mostMs);
}

void ViewsDesk::Press(
  QWidget& view, const QPoint& at, Qt::MouseButton button, Qt::KeyboardModifiers keys)
{
  QTest::mousePress(WindowOf(view), button, keys, InWindow(view, at));
}

void ViewsDesk::Move(QWidget& view, const QPoint& to)
{
  QTest::mouseMove(WindowOf(view), InWindow(view, to));
}

void ViewsDesk::Release(
  QWidget& view, const QPoint& at, Qt::MouseButton button, Qt::KeyboardModifiers keys)
{
  QTest::mouseRelease(WindowOf(view), button, keys, InWindow(view, at));
}

void ViewsDesk::Drag(QWidget& view, const QPoint& from, const QPoint& to, Qt::MouseButton button,
  Qt::KeyboardModifiers keys)
{
  this->Press(view, from, button, keys);
  for (int step = 1; step <= 10; ++step)
    this->Move(view, from + (to - from) * step / 10);
  this->Release(view, to, button, keys);
}

void ViewsDesk::Click(QWidget& view, const QPoint& at)
{
  QTest::mouseClick(WindowOf(view), Qt::LeftButton, {}, InWindow(view, at));
}

void ViewsDesk::DoubleClick(QWidget& view, const QPoint& at)
{
  QTest::mouseDClick(WindowOf(view), Qt::LeftButton, {}, InWindow(view, at));
}

void ViewsDesk::Hover(QWidget& view, const QPoint& to, Qt::KeyboardModifiers keys)
{
  QMouseEvent event(QEvent::MouseMove, to, Qt::NoButton, Qt::NoButton, keys);
  QApplication::sendEvent(&view, &event);
}

void ViewsDesk::Wheel(QWidget& view, int notches)
{
  const QPoint at = MiddleOf(view);
  const int direction = notches < 0 ? -1 : 1;
  for (int notch = 0; notch < std::abs(notches); ++notch)
  {
    QWheelEvent event(at, view.mapToGlobal(at), QPoint(), QPoint(0, 120 * direction), Qt::NoButton,
      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
  }
}

void ViewsDesk::Key(QWidget& view, Qt::Key key)
{
  QTest::keyClick(&view, key);
}

QImage Drawn(FrameView& view)
{
  view.DrawNow();
  return view.grabFramebuffer();
}

QPoint MiddleOf(const QWidget& view)
{
  return { view.width() / 2, view.height() / 2 };
}

GridGeometry TurnedGrid(bool mirrored, int slices, double thicknessMm)
{
  GridGeometry grid;
  grid.dims = { 61, 51, slices };
  grid.spacing = { 0.5, 0.7, thicknessMm };
  const glm::dvec3 x = glm::normalize(glm::dvec3(0.8, 0.5, -0.2));
  const glm::dvec3 y = glm::normalize(glm::cross(glm::dvec3(0.1, 0.2, 1.0), x));
  const glm::dvec3 z = glm::cross(x, y);
  grid.direction = glm::dmat3(x, y, mirrored ? -z : z);
  grid.origin = -(grid.IndexToWorldMatrix() * (0.5 * glm::dvec3(grid.dims - 1)));
  grid.Validate();
  return grid;
}

GridGeometry UprightGrid()
{
  GridGeometry grid;
  grid.dims = { 81, 101, 41 };
  grid.spacing = { 1.0, 1.0, 2.0 };
  grid.origin = { -40.0, -50.0, -40.0 };
  return grid;
}

vtkSmartPointer<vtkImageData> ImageOf(
  const GridGeometry& grid, const std::function<double(const glm::dvec3&)>& value)
{
  std::vector<float> samples;
  samples.reserve(grid.Size());
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i)
        samples.push_back(static_cast<float>(value(grid.IndexToWorld({ i, j, k }))));
  return MakeImage(grid, samples);
}

} // namespace hasp::testing
