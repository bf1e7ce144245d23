#include "View/OrientationCube.h"

#include "View/SliceAxis.h"

#include <QPainter>

#include <glm/geometric.hpp>

namespace hasp
{

namespace
{

constexpr double LeastSeen = 0.02; // below this a side is a line

/// Blue as the views' background would be under a lamp; red, green and yellow are the slices'.
QColor SideColour(double towards)
{
  return QColor::fromHslF(0.58, 0.30, 0.28 + 0.30 * towards, 0.85);
}

} // namespace

std::vector<CubeSide> VisibleSides(const ViewAxes& axes, const QPointF& middle, double half)
{
  const auto seen = [&](const glm::dvec3& place)
  { return middle + half * QPointF(glm::dot(place, axes.right), -glm::dot(place, axes.up)); };
  std::vector<CubeSide> sides;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : { 1.0, -1.0 })
    {
      glm::dvec3 normal(0.0);
      normal[axis] = sign;
      const double towards = glm::dot(normal, axes.towardsViewer);
      if (towards < LeastSeen)
        continue;
      const glm::dvec3 up = axis == 2 ? glm::dvec3(0, -1, 0) : glm::dvec3(0, 0, 1);
      const glm::dvec3 right = glm::cross(up, normal);
      CubeSide side{ SideLetter(normal), {}, {}, towards };
      for (const glm::dvec3& corner : { up - right, up + right, right - up, -up - right })
        side.outline << seen(normal + corner);
      const QPointF x = seen(right) - middle, y = seen(-up) - middle, at = seen(normal);
      side.lettering = QTransform(x.x(), x.y(), y.x(), y.y(), at.x(), at.y());
      sides.push_back(side);
    }
  return sides;
}

void PaintOrientationCube(
  QPainter& painter, const ViewAxes& axes, const QPointF& middle, double half)
{
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QTransform before = painter.transform();
  QFont font = painter.font();
  font.setBold(true);
  font.setPixelSize(100); // of a side of 160: scaled by its lettering
  painter.setFont(font);
  for (const CubeSide& side : VisibleSides(axes, middle, half))
  {
    painter.setPen(QPen(QColor(15, 18, 24), 1.0));
    painter.setBrush(SideColour(side.towards));
    painter.drawPolygon(side.outline);
    painter.setTransform(QTransform::fromScale(1 / 80.0, 1 / 80.0) * side.lettering * before);
    painter.setPen(QColor(255, 255, 255, int(255 * side.towards)));
    painter.drawText(QRectF(-80, -80, 160, 160), Qt::AlignCenter, side.letter);
    painter.setTransform(before);
  }
  painter.restore();
}

} // namespace hasp
