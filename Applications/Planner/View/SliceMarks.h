#pragma once
#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>

class QPainter;

namespace hasp
{

/// What is written over a slice.
struct SliceMarks
{
  QRectF area;                      ///< of the view, pixels
  QColor frame;                     ///< the plane's
  bool keyboard = false;            ///< the view has it: a wider frame
  QString left, right, top, bottom; ///< the patient's sides
  QString place;                    ///< "S 12.3 mm"
  QString grey;                     ///< at the crosshair: "312 HU"
  QString windowLevel;              ///< "W 1000 L 400"
  double mmPerPixel = 0.0;          ///< 0: no ruler
  std::optional<QPointF> cross;     ///< nothing: no crosshair
  QColor across, down;              ///< its lines', of the planes that they stand for
};

void PaintSliceMarks(QPainter& painter, const SliceMarks& marks);

} // namespace hasp
