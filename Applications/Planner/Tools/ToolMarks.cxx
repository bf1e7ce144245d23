#include "Tools/ToolMarks.h"

#include "View/SceneView.h"
#include "View/SliceView.h"
#include "View/ViewGrid.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <QEvent>
#include <QPainter>
#include <QRadialGradient>

#include <glm/geometric.hpp>

#include <cmath>

namespace hasp
{

std::optional<QPointF> MarkedView::PixelOf(const glm::dvec3& world) const
{
  return this->view.PixelOf(world);
}

double MarkedView::Off(const glm::dvec3& world) const
{
  return this->slice ? std::abs(glm::dot(world - this->cross, this->slice->towardsViewer)) : 0.0;
}

bool MarkedView::Faces(const glm::dvec3& world, const glm::dvec3& normal) const
{
  if (this->slice || normal == glm::dvec3(0.0))
    return true;
  vtkCamera* camera = this->view.Renderer()->GetActiveCamera();
  double eye[3], way[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(way);
  const glm::dvec3 into = camera->GetParallelProjection()
                            ? glm::dvec3(way[0], way[1], way[2])
                            : world - glm::dvec3(eye[0], eye[1], eye[2]);
  return glm::dot(into, normal) < 0.0;
}

ToolMarks::ToolMarks(ViewGrid& views, Paint paint) : Views(views)
{
  const auto add = [&](FrameView& view)
  {
    auto* marks = new ViewMarks(
      view, [this, paint, &view](QPainter& painter) { paint(painter, this->Of(view)); });
    marks->show();
    view.installEventFilter(this);
    connect(&view, &FrameView::Shown, marks, qOverload<>(&QWidget::update));
    this->Marks.emplace_back(marks);
  };
  add(views.Scene());
  for (const SliceAxis axis : SliceAxes)
    add(views.Slice(axis));
}

ToolMarks::~ToolMarks()
{
  for (const QPointer<ViewMarks>& marks : this->Marks)
    delete marks.data();
}

void ToolMarks::Update()
{
  for (const QPointer<ViewMarks>& marks : this->Marks)
    if (marks)
      marks->update();
}

MarkedView ToolMarks::Of(FrameView& view) const
{
  for (const SliceAxis axis : SliceAxes)
    if (static_cast<FrameView*>(&this->Views.Slice(axis)) == &view)
      return { view, &FrameOf(axis), this->Views.Crosshair() };
  return { view };
}

bool ToolMarks::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::Resize)
    for (const QPointer<ViewMarks>& marks : this->Marks)
      if (marks && marks->parent() == watched)
        marks->resize(static_cast<QWidget*>(watched)->size());
  return false;
}

void PaintBall(QPainter& painter, const QPointF& at, const QColor& colour, const QString& text,
  bool selected, bool faint)
{
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(selected ? QColor(Qt::white) : QColor(0, 0, 0, 180), selected ? 2.5 : 1.0));
  if (faint)
  {
    painter.setPen(QPen(selected ? QColor(Qt::white) : colour, 1.5));
    painter.setBrush(Qt::NoBrush);
  }
  else
  {
    QRadialGradient shade(at - QPointF(2, 2), BallPixels);
    shade.setColorAt(0.0, colour.lighter(160));
    shade.setColorAt(1.0, colour);
    painter.setBrush(shade);
  }
  painter.drawEllipse(at, BallPixels, BallPixels);
  if (!text.isEmpty())
    PaintText(painter, QRectF(at.x() + BallPixels, at.y() - 18.0, 60.0, 18.0),
      Qt::AlignLeft | Qt::AlignVCenter, text);
}

} // namespace hasp
