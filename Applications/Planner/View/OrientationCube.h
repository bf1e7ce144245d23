#pragma once
#include <QPolygonF>
#include <QString>
#include <QTransform>

#include <glm/vec3.hpp>

#include <vector>

class QPainter;

namespace hasp
{

/// What of the world points to the right of a view, up in it, and towards the viewer; unit vectors.
struct ViewAxes
{
  glm::dvec3 right, up, towardsViewer;
};

/// One side of the orientation cube as it is seen.
struct CubeSide
{
  QString letter;
  QPolygonF outline;    ///< pixels
  QTransform lettering; ///< of a square of 2 x 2 around 0, y down, onto the outline
  double towards = 0.0; ///< (0, 1]: how much it faces the viewer
};

/// The sides that are seen, at most three, around `middle`; each edge is 2 * half pixels long where
/// it is parallel to the screen. Letters stand upright (superior up; anterior up on S and I).
std::vector<CubeSide> VisibleSides(const ViewAxes& axes, const QPointF& middle, double half);

void PaintOrientationCube(
  QPainter& painter, const ViewAxes& axes, const QPointF& middle, double half);

} // namespace hasp
