#pragma once
#include "View/ViewGrid.h"

#include <QObject>
#include <QPointF>
#include <QPointer>

#include <functional>

class QKeyEvent;
class QMouseEvent;

namespace hasp
{

class FrameView;

/// The left button in the planner's views, for a tool that clicks and drags: before VTK and the
/// views hear of it. A press that a tool takes is its drag; any other is the view's, and where the
/// button comes up again without the pointer having gone anywhere, it was a click. With Shift, Ctrl
/// or Alt all is the view's. A double click is two clicks.
///
/// Threads: RENDER. Cost: a filter on four widgets while it watches.
class ViewMouse : public QObject
{
  Q_OBJECT
public:
  using Place = std::function<void(FrameView& view, const QPointF& pixel)>; ///< of the widget

  explicit ViewMouse(QObject* parent = nullptr) : QObject(parent) {}
  ~ViewMouse() override { this->Leave(); }

  void Watch(ViewGrid& views);
  void Leave();

  /// True: the drag that begins there is the tool's.
  std::function<bool(FrameView& view, const QPointF& pixel)> press;
  Place drag;    ///< of the tool's drag
  Place release; ///< its end; the last drag was there
  Place click;
  /// True: it is the tool's. Of a view that has the keyboard.
  std::function<bool(const QKeyEvent& key)> key;
  /// Whether the pointer is over something that can be dragged: it becomes a hand.
  std::function<bool(FrameView& view, const QPointF& pixel)> grips;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  enum class Press
  {
    None,
    Ours,   ///< the tool's drag
    Click,  ///< the view's so far, or a click
    Swallow ///< the second one of a double click: the view must not hear of it
  };
  bool Pressed(FrameView& view, const QMouseEvent& event, bool twice);
  bool HasGone(const QMouseEvent& event);
  bool Moved(FrameView& view, const QMouseEvent& event);
  bool Released(FrameView& view, const QMouseEvent& event);
  void ShowGrip(FrameView& view, const QPointF& pixel);

  QPointer<ViewGrid> Views;
  Press Now = Press::None;
  QPointF From;
  bool Gone = false; ///< from there
};

} // namespace hasp
