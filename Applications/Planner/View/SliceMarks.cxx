#include "View/SliceMarks.h"

#include "View/ViewMarks.h"

#include <QPainter>

namespace hasp
{

namespace
{

constexpr double FrameWidth = 2.0; // pixels
constexpr double KeyboardFrameWidth = 4.0;
constexpr double Margin = 7.0;
constexpr double CrossGap = 7.0; // so that what is under the crosshair is seen

void PaintCross(QPainter& painter, const SliceMarks& marks)
{
  const QPointF at = *marks.cross, x(CrossGap, 0.0), y(0.0, CrossGap);
  PaintLine(painter, QPointF(marks.area.left(), at.y()), at - x, marks.across);
  PaintLine(painter, at + x, QPointF(marks.area.right(), at.y()), marks.across);
  PaintLine(painter, QPointF(at.x(), marks.area.top()), at - y, marks.down);
  PaintLine(painter, at + y, QPointF(at.x(), marks.area.bottom()), marks.down);
}

void PaintLetters(QPainter& painter, const SliceMarks& marks, const QRectF& inner)
{
  const QFont before = painter.font();
  QFont bold = before;
  bold.setBold(true);
  painter.setFont(bold);
  PaintText(painter, inner, Qt::AlignLeft | Qt::AlignVCenter, marks.left);
  PaintText(painter, inner, Qt::AlignRight | Qt::AlignVCenter, marks.right);
  PaintText(painter, inner, Qt::AlignHCenter | Qt::AlignTop, marks.top);
  PaintText(painter, inner, Qt::AlignHCenter | Qt::AlignBottom, marks.bottom);
  painter.setFont(before);
}

} // namespace

void PaintSliceMarks(QPainter& painter, const SliceMarks& marks)
{
  const QRectF inner = marks.area.adjusted(Margin, Margin, -Margin, -Margin);
  if (marks.cross)
    PaintCross(painter, marks);
  PaintRuler(painter, marks.area, marks.mmPerPixel);
  PaintLetters(painter, marks, inner);
  PaintText(painter, inner, Qt::AlignLeft | Qt::AlignTop, marks.place, marks.frame.lighter(120));
  PaintText(painter, inner, Qt::AlignRight | Qt::AlignTop, marks.windowLevel);
  PaintText(painter, inner, Qt::AlignLeft | Qt::AlignBottom, marks.grey);
  PaintFrame(painter, marks.area, marks.frame, marks.keyboard ? KeyboardFrameWidth : FrameWidth);
}

} // namespace hasp
