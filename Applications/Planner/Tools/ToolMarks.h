#pragma once
#include "View/ViewMarks.h"

#include <QObject>
#include <QPointF>
#include <QPointer>
#include <QString>

#include <glm/vec3.hpp>

#include <functional>
#include <optional>
#include <vector>

class QColor;
class QPainter;

namespace hasp
{

class FrameView;
struct SliceFrame;
class ViewGrid;

/// One of the planner's views, for what is marked in it.
struct MarkedView
{
  FrameView& view;
  const SliceFrame* slice = nullptr; ///< of a slice; nullptr: 3D
  glm::dvec3 cross{ 0.0 };           ///< the slices' place

  std::optional<QPointF> PixelOf(const glm::dvec3& world) const;
  /// Off a slice's plane, mm; 0 in 3D.
  double Off(const glm::dvec3& world) const;
  /// Whether a surface of that normal there looks towards the viewer; true where none is known.
  bool Faces(const glm::dvec3& world, const glm::dvec3& normal) const;
};

/// What a tool draws over the planner's views, as ViewMarks does: in no depth that a pick asks, and
/// without a frame of the view. Follows frames and sizes. Threads: RENDER.
class ToolMarks : public QObject
{
  Q_OBJECT
public:
  using Paint = std::function<void(QPainter& painter, const MarkedView& view)>;
  ToolMarks(ViewGrid& views, Paint paint);
  ~ToolMarks() override;

  void Update();
  /// As it is marked.
  MarkedView Of(FrameView& view) const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  ViewGrid& Views;
  std::vector<QPointer<ViewMarks>> Marks; ///< the views own them, and may go before
};

/// A numbered ball; `faint`: hollow, of what is turned away or off the slice.
void PaintBall(QPainter& painter, const QPointF& at, const QColor& colour, const QString& text,
  bool selected, bool faint);
inline constexpr double BallPixels = 6.0;  ///< its radius
inline constexpr double GripPixels = 10.0; ///< so near a press takes it

} // namespace hasp
