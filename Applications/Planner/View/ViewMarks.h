#pragma once
#include <QColor>
#include <QString>
#include <QWidget>

#include <functional>

class QPainter;

namespace hasp
{

/// What lies over a view: letters, rulers, the crosshair. Painted by Qt and not by VTK: sharp while
/// the view draws fewer pixels, in the window's own font, in no depth that a pick asks, and without
/// a frame of the view where only the marks have changed. The mouse passes through.
/// Threads: RENDER.
class ViewMarks : public QWidget
{
  Q_OBJECT
public:
  using Paint = std::function<void(QPainter&)>;
  ViewMarks(QWidget& view, Paint paint);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  Paint Marks;
};

///@{
/// For any painter; pixels.
/// White, or of a colour, with a dark edge: to be read on bone and on air. `flags` as of
/// QPainter::drawText.
void PaintText(QPainter& painter, const QRectF& where, int flags, const QString& text,
  const QColor& colour = Qt::white);
/// A line with the same edge.
void PaintLine(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour);
/// Along the border of `area`, within it; width in pixels.
void PaintFrame(QPainter& painter, const QRectF& area, const QColor& colour, double width);
/// A scale bar along the lower edge of `area`, at its right, a third of it at most, with its length
/// in mm. Nothing where mmPerPixel is not > 0.
void PaintRuler(QPainter& painter, const QRectF& area, double mmPerPixel);
///@}
/// As the user's language writes numbers, without marks between thousands; format and precision as
/// of QLocale::toString.
QString NumberText(double value, char format, int precision);
/// The longest of 1, 2, 5, 10, 20, 50 … mm (and their parts by ten) that fits so many pixels.
double RulerLength(double mmPerPixel, double mostPixels);

} // namespace hasp
