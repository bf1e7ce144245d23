#include "Tools/AreaTool.h"

#include "Planning/PlanLists.h"
#include "Tools/Planner.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

#include <glm/geometric.hpp>

#include <utility>

namespace hasp
{

namespace
{
constexpr std::size_t MostPoints = 1000; // of a stroke: GuideRecipe's
constexpr double SpacingRadii = 0.25;
const QColor PaintedColour(255, 196, 0, 90), WipedColour(90, 90, 90, 120);
} // namespace

AreaTool::AreaTool(Planner& planner, QObject* parent) : Tool(parent), Of(planner)
{
  this->Mouse.press = [this](FrameView& view, const QPointF& pixel)
  { return this->Press(view, pixel); };
  this->Mouse.drag = [this](FrameView& view, const QPointF& pixel) { this->Drag(view, pixel); };
  this->Mouse.release = [this](FrameView&, const QPointF&) { this->Release(); };
  this->Mouse.key = [this](const QKeyEvent& key)
  {
    if (key.key() == Qt::Key_Insert)
      this->DabCrosshair();
    return key.key() == Qt::Key_Insert;
  };
}

AreaTool::~AreaTool()
{
  if (this->Of.tools.InHand() == this)
    this->Of.tools.Take(nullptr);
}

void AreaTool::Begin()
{
  this->Marks = std::make_unique<ToolMarks>(this->Of.views,
    [this](QPainter& painter, const MarkedView& view) { this->Paint(painter, view); });
  this->Mouse.Watch(this->Of.views);
}

void AreaTool::End()
{
  this->Mouse.Leave();
  this->Marks.reset();
  this->Now.reset();
}

QString AreaTool::Hint() const
{
  return this->Wipes
           ? tr("Drag over painted bone to wipe it off; a drag beside bone turns the view. Escape "
                "ends.")
           : tr("Drag over bone to paint it; a drag beside it turns the view. Insert dabs at the "
                "crosshair, Escape ends.");
}

void AreaTool::SetErases(bool erases)
{
  this->Wipes = erases;
  Q_EMIT this->HintChanged();
}

void AreaTool::SetStrokes(std::vector<GuideStroke> strokes, PlanId bone)
{
  this->All = std::move(strokes);
  this->Bone = bone;
  this->Update();
}

bool AreaTool::DabCrosshair()
{
  const auto place = TouchCrosshair(this->Of);
  if (!place)
  {
    this->Of.SayFault(tr("There is no crosshair: show a scan first."));
    return false;
  }
  Q_EMIT this->Painted({ { place->inScan }, this->radiusMm, this->Wipes }, *place);
  return true;
}

std::optional<TouchedPlace> AreaTool::BoneAt(FrameView& view, const QPointF& pixel) const
{
  const auto place = TouchAt(this->Of, view, pixel);
  const bool bone = place && (place->object == 0 ||
                               FindPlanObject<PlanFragment>(this->Of.plan.Now(), place->object));
  return bone ? place : std::nullopt;
}

bool AreaTool::Press(FrameView& view, const QPointF& pixel)
{
  const auto place = this->BoneAt(view, pixel);
  if (!place)
    return false;
  this->First = *place;
  this->Now = GuideStroke{ { place->inScan }, this->radiusMm, this->Wipes };
  this->Update();
  return true;
}

void AreaTool::Drag(FrameView& view, const QPointF& pixel)
{
  const auto place = this->BoneAt(view, pixel);
  if (!place || !this->Now)
    return;
  const double away = glm::distance(place->inScan, this->Now->points.back());
  if (away < SpacingRadii * this->radiusMm || this->Now->points.size() >= MostPoints)
    return;
  this->Now->points.push_back(place->inScan);
  this->Update();
}

void AreaTool::Release()
{
  if (!this->Now)
    return;
  const GuideStroke stroke = *std::exchange(this->Now, std::nullopt);
  Q_EMIT this->Painted(stroke, this->First);
  this->Update();
}

void AreaTool::Paint(QPainter& painter, const MarkedView& view) const
{
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const auto mark = [&](const GuideStroke& stroke, PlanId bone)
  {
    painter.setBrush(stroke.erased ? WipedColour : PaintedColour);
    const double radius = stroke.radiusMm / view.view.MmPerPixel();
    QPainterPath area; // one: where its discs overlap it is no darker
    area.setFillRule(Qt::WindingFill);
    for (const glm::dvec3& point : stroke.points)
    {
      const auto at =
        view.PixelOf(view.slice ? point : PlaceOfScan(this->Of.plan.Now(), bone, point).world);
      if (at && view.Off(point) < stroke.radiusMm)
        area.addEllipse(*at, radius, radius);
    }
    painter.drawPath(area);
  };
  for (const GuideStroke& stroke : this->All)
    mark(stroke, this->Bone);
  if (this->Now)
    mark(*this->Now, this->First.object);
}

void AreaTool::Update()
{
  if (this->Marks)
    this->Marks->Update();
}

} // namespace hasp
