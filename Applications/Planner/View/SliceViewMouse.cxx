// What a user does in a slice view, and what is written over it.
#include "View/SliceMarks.h"
#include "View/SliceView.h"
#include "View/ViewMarks.h"

#include "vtkImageData.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace hasp
{

namespace
{

constexpr int ClickPixels = 3;          // a hand that clicks moves so far
constexpr double RangePerPixel = 0.002; // of the image's grey values, as 3D Slicer
constexpr int KeyPixels = 10;           // a key is a drag of so many
constexpr double ZoomPerPixel = 0.01;   // of the logarithm

} // namespace

glm::dvec3 SliceView::PlaceAt(const QPoint& pixel) const
{
  const double mm = this->MmPerPixel();
  const double right = (pixel.x() + 0.5 - 0.5 * this->width()) * mm;
  const double up = (0.5 * this->height() - pixel.y() - 0.5) * mm;
  glm::dvec3 place = this->Middle + right * this->Shape.right + up * this->Shape.up;
  place[this->Shape.normalAxis] = this->At[this->Shape.normalAxis];
  return place;
}

void SliceView::StepBy(int steps)
{
  if (this->Shown)
    Q_EMIT this->PlaceAsked(this->At + steps * this->Step * this->Shape.next);
}

void SliceView::OnMouse(const SliceMouse& mouse)
{
  if (!this->Shown)
    return;
  switch (mouse.what)
  {
    case SliceMouse::What::Forward:
      return this->StepBy(1);
    case SliceMouse::What::Backward:
      return this->StepBy(-1);
    case SliceMouse::What::Press:
      return this->BeginDrag(mouse);
    case SliceMouse::What::Release:
      if (this->Now == Drag::Undecided)
      {
        this->BeforeClick = this->At;
        Q_EMIT this->PlaceAsked(this->PlaceAt(this->DragFrom));
      }
      this->Now = Drag::None;
      return;
    case SliceMouse::What::Move:
      if (this->Now != Drag::None)
        this->ContinueDrag();
      else if (mouse.shift && !this->IsHeld())
        Q_EMIT this->PlaceAsked(this->PlaceAt(this->Pointer()));
  }
}

void SliceView::BeginDrag(const SliceMouse& mouse)
{
  this->DragFrom = this->DragAt = this->Pointer();
  this->Now = Drag::None;
  if (this->IsSecondPress())
  {
    // The first click of the two was none.
    if (mouse.button == SliceMouse::Button::Left)
      Q_EMIT this->PlaceAsked(this->BeforeClick);
    return;
  }
  this->BeforeClick = this->At;
  this->Fixed = this->PlaceAt(this->DragFrom);
  if (mouse.button == SliceMouse::Button::Right)
    this->Now = Drag::Zoom;
  else if (mouse.button == SliceMouse::Button::Middle || mouse.shift)
    this->Now = Drag::Move;
  else
    this->Now = Drag::Undecided;
}

void SliceView::ContinueDrag()
{
  if (this->Now == Drag::Undecided)
  {
    if ((this->Pointer() - this->DragFrom).manhattanLength() <= ClickPixels)
      return;
    this->Now = Drag::WindowLevel;
  }
  const QPoint moved = this->Pointer() - this->DragAt;
  this->DragAt = this->Pointer();
  switch (this->Now)
  {
    case Drag::WindowLevel:
      return this->DragWindowLevel(moved);
    case Drag::Move:
      this->Middle -= this->MmPerPixel() *
                      (double(moved.x()) * this->Shape.right - double(moved.y()) * this->Shape.up);
      this->PlaceCamera();
      this->Draw();
      return;
    default:
      this->DragZoom(-moved.y(), this->Fixed);
  }
}

void SliceView::DragWindowLevel(const QPoint& moved)
{
  const double grey = RangePerPixel * this->GreyRange;
  Q_EMIT this->WindowLevelAsked(
    std::max(grey, this->Window + grey * moved.x()), this->Level - grey * moved.y());
}

void SliceView::DragZoom(int up, const glm::dvec3& fixed)
{
  Q_EMIT this->ZoomAsked(this->Closer * std::exp(ZoomPerPixel * up), fixed);
}

void SliceView::SetShownInScene(bool shown)
{
  if (shown == this->InScene)
    return;
  this->InScene = shown;
  Q_EMIT this->ShownInSceneChanged(shown);
}

/// Window and level. False: it is another key.
bool SliceView::AnswerShifted(int key)
{
  switch (key)
  {
    case Qt::Key_Left:
      this->DragWindowLevel({ -KeyPixels, 0 });
      return true;
    case Qt::Key_Right:
      this->DragWindowLevel({ KeyPixels, 0 });
      return true;
    case Qt::Key_Up:
      this->DragWindowLevel({ 0, -KeyPixels });
      return true;
    case Qt::Key_Down:
      this->DragWindowLevel({ 0, KeyPixels });
      return true;
    default:
      return false;
  }
}

void SliceView::keyPressEvent(QKeyEvent* event)
{
  const Qt::KeyboardModifiers held =
    event->modifiers() & ~Qt::KeyboardModifiers(Qt::KeypadModifier);
  if (held == Qt::ShiftModifier && this->AnswerShifted(event->key()))
    return;
  if (held != Qt::NoModifier)
    return FrameView::keyPressEvent(event);
  switch (event->key())
  {
    case Qt::Key_Left:
    case Qt::Key_B:
      return this->StepBy(-1);
    case Qt::Key_Right:
    case Qt::Key_F:
      return this->StepBy(1);
    case Qt::Key_Up:
      return this->DragZoom(KeyPixels, this->At);
    case Qt::Key_Down:
      return this->DragZoom(-KeyPixels, this->At);
    case Qt::Key_R:
      Q_EMIT this->ResetAsked();
      return;
    case Qt::Key_V:
      return this->SetShownInScene(!this->InScene);
    default:
      FrameView::keyPressEvent(event);
  }
}

void SliceView::PaintMarks(QPainter& painter)
{
  SliceMarks marks;
  marks.area = this->rect();
  marks.frame = this->Shape.colour;
  marks.keyboard = this->hasFocus();
  marks.left = SideLetter(-this->Shape.right);
  marks.right = SideLetter(this->Shape.right);
  marks.top = SideLetter(this->Shape.up);
  marks.bottom = SideLetter(-this->Shape.up);
  if (this->Shown)
  {
    marks.place = this->PlaceText();
    marks.grey = this->GreyText();
    marks.windowLevel = tr("W %1 L %2", "window and level")
                          .arg(NumberText(this->Window, 'g', 4), NumberText(this->Level, 'g', 4));
    marks.mmPerPixel = this->MmPerPixel();
    if (this->CrossVisible)
      marks.cross = this->PixelOf(this->At);
    // A line across is where a plane with this normal is seen from its edge.
    for (const SliceAxis axis : SliceAxes)
    {
      const SliceFrame& other = FrameOf(axis);
      if (glm::dot(other.next, this->Shape.up) != 0.0)
        marks.across = other.colour;
      else if (glm::dot(other.next, this->Shape.right) != 0.0)
        marks.down = other.colour;
    }
  }
  PaintSliceMarks(painter, marks);
}

} // namespace hasp
