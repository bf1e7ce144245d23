// What Qt tells a view before, and in place of, what VTK hears.
#include "View/FrameView.h"

#include "View/ViewMarks.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <utility>

namespace hasp
{

void FrameView::SeePress()
{
  this->PressSeen = true;
}

/// Before VTK hears of it. Who asks for the depth under a press finds a frame of its pixels, and of
/// what is there by now.
void FrameView::MouseComes(const QMouseEvent& event)
{
  this->At = event.pos();
  const bool press =
    event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonDblClick;
  if (press && !this->IsHeld())
  {
    this->Moving();
    if (this->IsStale() || this->Coming.isActive())
      this->Frame();
  }
  if (event.type() != QEvent::MouseButtonRelease)
    this->Held = event.buttons();
  if (event.type() == QEvent::MouseMove && this->IsHeld())
    this->Moving();
}

bool FrameView::Tell(QEvent* event)
{
  if (!this->SecondPress)
    return QVTKOpenGLNativeWidget::event(event);
  const auto* mouse = static_cast<QMouseEvent*>(event);
  QMouseEvent press(QEvent::MouseButtonPress, mouse->localPos(), mouse->windowPos(),
    mouse->screenPos(), mouse->button(), mouse->buttons(), mouse->modifiers(), mouse->source());
  const bool done = QVTKOpenGLNativeWidget::event(&press);
  event->setAccepted(press.isAccepted());
  return done;
}

bool FrameView::event(QEvent* event)
{
  const QEvent::Type type = event->type();
  const bool release = type == QEvent::MouseButtonRelease;
  this->SecondPress = type == QEvent::MouseButtonDblClick;
  if (this->SecondPress || release || type == QEvent::MouseButtonPress || type == QEvent::MouseMove)
    this->MouseComes(*static_cast<QMouseEvent*>(event));
  else if (type == QEvent::Wheel)
    this->Moving();
  else if (type == QEvent::Resize)
    this->Marks->resize(this->size());
  else if (type == QEvent::FocusIn || type == QEvent::FocusOut)
    this->MarksChanged(); // whose keyboard it is

  this->PressSeen = false;
  const bool done = this->Tell(event);
  if (release)
  {
    this->Held = static_cast<QMouseEvent*>(event)->buttons();
    this->Moving();
  }
  if (std::exchange(this->SecondPress, false) && this->PressSeen)
    Q_EMIT this->DoubleClicked();
  return done;
}

void FrameView::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_M && event->modifiers() == Qt::NoModifier)
    Q_EMIT this->DoubleClicked();
  else
    QVTKOpenGLNativeWidget::keyPressEvent(event); // the window's
}

} // namespace hasp
