#pragma once
#include <QRect>

class QWidget;

/// Where things are on the screen, for a layout file (LayoutWidgets.h). Internal. Threads: RENDER.
namespace hasp
{

QRect OnScreen(const QWidget& widget, const QRect& rect);
/// The rest of a rectangle that the widget and its parents do not cut off, on the screen; of no
/// size: nothing.
QRect Shown(const QWidget& widget, const QRect& rect);
/// What is seen of the innermost scrolled area that a widget is in; none: empty.
QRect ShownOfArea(const QWidget& widget);
/// Where it takes a click, of the widget's own, if that is not all of it; else empty.
QRect HitOf(const QWidget& widget);

} // namespace hasp
