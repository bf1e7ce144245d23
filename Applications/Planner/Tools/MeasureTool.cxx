#include "Tools/MeasureTool.h"

#include "Planning/PlanEdits.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"

#include <QKeyEvent>
#include <QPainter>

namespace hasp
{

namespace
{
const QColor Colour(120, 255, 140);

std::size_t PlacesOf(MeasureKind kind)
{
  return kind == MeasureKind::Distance ? 2 : 3;
}
} // namespace

MeasureTool::MeasureTool(Planner& planner, QObject* parent) : Tool(parent), Of(planner)
{
  this->Mouse.click = [this](FrameView& view, const QPointF& pixel)
  { this->Add(TouchAt(this->Of, view, pixel)); };
  this->Mouse.key = [this](const QKeyEvent& key)
  {
    const bool back = key.key() == Qt::Key_Delete || key.key() == Qt::Key_Backspace;
    if (key.key() == Qt::Key_Insert)
      this->TouchCrosshair();
    else if (back && !this->All.empty())
    {
      this->All.pop_back();
      this->Update();
    }
    return back || key.key() == Qt::Key_Insert;
  };
  connect(&planner.plan, &PlanSession::Replaced, this,
    [this]
    {
      this->All.clear(); // they were touched in the old one
      this->Update();
    });
}

MeasureTool::~MeasureTool()
{
  if (this->Of.tools.InHand() == this)
    this->Of.tools.Take(nullptr);
}

void MeasureTool::Start(MeasureKind kind)
{
  this->Now = kind;
  this->All.clear();
  this->Of.tools.Take(this);
  this->Update();
}

void MeasureTool::Begin()
{
  this->Marks = std::make_unique<ToolMarks>(this->Of.views,
    [this](QPainter& painter, const MarkedView& view) { this->Paint(painter, view); });
  this->Mouse.Watch(this->Of.views);
}

void MeasureTool::End()
{
  this->Mouse.Leave();
  this->Marks.reset();
  this->All.clear();
}

QString MeasureTool::Hint() const
{
  const int left = int(PlacesOf(this->Now) - this->All.size());
  return this->Now == MeasureKind::Distance
           ? tr("Distance: places still to touch: %1; or press Insert at the crosshair.").arg(left)
           : tr("Angle, its corner second: places still to touch: %1; or press Insert at the "
                "crosshair.")
               .arg(left);
}

bool MeasureTool::TouchCrosshair()
{
  const auto place = hasp::TouchCrosshair(this->Of);
  if (!place)
    this->Of.SayFault(tr("There is no crosshair: show a scan first."));
  return place && this->Add(place);
}

bool MeasureTool::Add(const std::optional<TouchedPlace>& place)
{
  if (!place)
    return false;
  this->All.push_back(*place);
  if (this->All.size() == PlacesOf(this->Now))
    this->Finish();
  this->Update();
  return true;
}

void MeasureTool::Finish()
{
  const Plan& plan = this->Of.plan.Now();
  PlanMeasure measure;
  measure.id = this->Of.plan.NewId();
  measure.kind = this->Now;
  measure.name = (this->Now == MeasureKind::Distance ? tr("distance %1") : tr("angle %1"))
                   .arg(measure.id)
                   .toStdString();
  for (const TouchedPlace& place : this->All)
  {
    const bool goes = FindPlanObject<PlanFragment>(plan, place.object) != nullptr;
    measure.points.push_back({ goes ? place.object : 0, goes ? place.inScan : place.world });
  }
  this->All.clear();
  if (this->Of.plan.Do(AddObject<PlanMeasure>{ measure }))
    Q_EMIT this->Measured(measure.id);
}

void MeasureTool::Paint(QPainter& painter, const MarkedView& view) const
{
  constexpr double SliceMm = 2.0;
  for (std::size_t n = 0; n < this->All.size(); ++n)
  {
    const TouchedPlace& place = this->All[n];
    const auto at = view.PixelOf(view.slice ? place.inScan : place.world);
    if (at && view.Off(place.inScan) <= SliceMm)
      PaintBall(painter, *at, Colour, QString::number(n + 1), false,
        !view.Faces(place.world, place.normal));
  }
}

void MeasureTool::Update()
{
  if (this->Marks)
    this->Marks->Update();
  Q_EMIT this->HintChanged();
}

} // namespace hasp
