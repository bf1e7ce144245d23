#include "View/ViewMarks.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>

#include <cmath>

namespace hasp
{

namespace
{

const QColor Edge(0, 0, 0, 200);
constexpr double Margin = 8.0;
constexpr double Tick = 5.0;

} // namespace

ViewMarks::ViewMarks(QWidget& view, Paint paint) : QWidget(&view), Marks(std::move(paint))
{
  this->setAttribute(Qt::WA_TransparentForMouseEvents);
  this->setAttribute(Qt::WA_NoSystemBackground);
  this->setFocusPolicy(Qt::NoFocus);
  this->resize(view.size());
}

void ViewMarks::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  this->Marks(painter);
}

void PaintText(
  QPainter& painter, const QRectF& where, int flags, const QString& text, const QColor& colour)
{
  painter.setPen(Edge);
  for (const QPointF& offset : { QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1) })
    painter.drawText(where.translated(offset), flags, text);
  painter.setPen(colour);
  painter.drawText(where, flags, text);
}

void PaintLine(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour)
{
  painter.setPen(QPen(QColor(0, 0, 0, 110), 3.0));
  painter.drawLine(from, to);
  painter.setPen(QPen(colour, 1.0));
  painter.drawLine(from, to);
}

void PaintFrame(QPainter& painter, const QRectF& area, const QColor& colour, double width)
{
  painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.setBrush(Qt::NoBrush);
  const double half = 0.5 * width;
  painter.drawRect(area.adjusted(half, half, -half, -half));
}

QString NumberText(double value, char format, int precision)
{
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(value, format, precision);
}

double RulerLength(double mmPerPixel, double mostPixels)
{
  const double most = mmPerPixel * mostPixels;
  const double ten = std::pow(10.0, std::floor(std::log10(most)));
  return most >= 5.0 * ten ? 5.0 * ten : most >= 2.0 * ten ? 2.0 * ten : ten;
}

void PaintRuler(QPainter& painter, const QRectF& area, double mmPerPixel)
{
  const double mostPixels = area.width() / 3.0;
  if (!(mmPerPixel > 0.0 && mostPixels >= 1.0))
    return;
  const double mm = RulerLength(mmPerPixel, mostPixels);
  const QPointF right = area.bottomRight() - QPointF(Margin + 0.5, Margin + 0.5);
  const QPointF left = right - QPointF(mm / mmPerPixel, 0.0), tick(0.0, Tick);
  PaintLine(painter, left, right, Qt::white);
  PaintLine(painter, left - tick, left, Qt::white);
  PaintLine(painter, right - tick, right, Qt::white);
  const double height = painter.fontMetrics().height();
  const QRectF text(area.left(), right.y() - Tick - height, right.x() - area.left(), height);
  PaintText(painter, text, Qt::AlignRight | Qt::AlignBottom,
    QCoreApplication::translate("Ruler", "%1 mm").arg(NumberText(mm, 'g', 4)));
}

} // namespace hasp
