#include "Tools/ViewMouse.h"

#include "View/SceneView.h"
#include "View/SliceView.h"
#include "View/ViewGrid.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace hasp
{

namespace
{
constexpr double ClickPixels = 3.0; // a hand that clicks moves so far

template <typename Act>
void ForEachView(ViewGrid& views, Act act)
{
  act(static_cast<FrameView&>(views.Scene()));
  for (const SliceAxis axis : SliceAxes)
    act(static_cast<FrameView&>(views.Slice(axis)));
}
} // namespace

void ViewMouse::Watch(ViewGrid& views)
{
  this->Leave();
  this->Views = &views;
  ForEachView(views, [this](FrameView& view) { view.installEventFilter(this); });
}

void ViewMouse::Leave()
{
  if (this->Views) // else they have gone before, and their filters with them
    ForEachView(*this->Views,
      [this](FrameView& view)
      {
        view.removeEventFilter(this);
        view.unsetCursor();
      });
  this->Views = nullptr;
  this->Now = Press::None;
}

bool ViewMouse::eventFilter(QObject* watched, QEvent* event)
{
  auto* view = qobject_cast<FrameView*>(watched);
  if (!view)
    return false;
  const bool twice = event->type() == QEvent::MouseButtonDblClick;
  if (twice || event->type() == QEvent::MouseButtonPress)
    return this->Pressed(*view, *static_cast<QMouseEvent*>(event), twice);
  if (event->type() == QEvent::MouseMove)
    return this->Moved(*view, *static_cast<QMouseEvent*>(event));
  if (event->type() == QEvent::MouseButtonRelease)
    return this->Released(*view, *static_cast<QMouseEvent*>(event));
  if (event->type() == QEvent::KeyPress)
    return this->key && this->key(*static_cast<QKeyEvent*>(event));
  return false;
}

bool ViewMouse::Pressed(FrameView& view, const QMouseEvent& event, bool twice)
{
  if (this->Now == Press::Ours || this->Now == Press::Swallow)
    return true;
  this->Now = Press::None; // with another button it is no click
  if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier)
    return false;
  this->From = event.localPos();
  this->Gone = false;
  view.setFocus(Qt::MouseFocusReason);
  const bool ours = this->press && this->press(view, this->From);
  this->Now = ours ? Press::Ours : twice ? Press::Swallow : Press::Click;
  return ours || twice;
}

/// Whether the pointer has gone anywhere since the press.
bool ViewMouse::HasGone(const QMouseEvent& event)
{
  const QPointF way = event.localPos() - this->From;
  this->Gone = this->Gone || way.manhattanLength() > ClickPixels;
  return this->Gone;
}

bool ViewMouse::Moved(FrameView& view, const QMouseEvent& event)
{
  if (this->Now == Press::None)
  {
    if (event.buttons() == Qt::NoButton)
      this->ShowGrip(view, event.localPos());
    return false;
  }
  const bool gone = this->HasGone(event);
  if (this->Now == Press::Ours && gone)
  {
    view.Moving();
    if (this->drag)
      this->drag(view, event.localPos());
  }
  if (this->Now != Press::Click || !gone)
    return true;           // a hand is not that steady: the view stays
  this->Now = Press::None; // the view's drag
  return false;
}

bool ViewMouse::Released(FrameView& view, const QMouseEvent& event)
{
  if (event.button() != Qt::LeftButton)
    return this->Now == Press::Ours || this->Now == Press::Swallow;
  const Press was = this->Now;
  const bool gone = this->HasGone(event);
  this->Now = Press::None;
  if (was == Press::Ours && gone && this->drag)
    this->drag(view, event.localPos()); // the last move may have been elsewhere
  if (was == Press::Ours && this->release)
    this->release(view, event.localPos());
  if ((was == Press::Click || was == Press::Swallow) && !gone && this->click)
    this->click(view, this->From);
  return was == Press::Ours || was == Press::Swallow;
}

void ViewMouse::ShowGrip(FrameView& view, const QPointF& pixel)
{
  if (this->grips && this->grips(view, pixel))
    view.setCursor(Qt::OpenHandCursor);
  else
    view.setCursor(Qt::CrossCursor);
}

} // namespace hasp
