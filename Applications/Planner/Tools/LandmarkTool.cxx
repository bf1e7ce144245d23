#include "Tools/LandmarkTool.h"

#include "Planning/PlanLists.h"
#include "Tools/Planner.h"

#include <QKeyEvent>
#include <QLineF>
#include <QPainter>

#include <utility>

namespace hasp
{

namespace
{
constexpr double SliceMm = 2.0; ///< so near to a slice places are marked in it
constexpr double FaintMm = 0.75;
} // namespace

LandmarkTool::LandmarkTool(Planner& planner, LandmarkPurpose purpose, QObject* parent)
  : Tool(parent),
    Of(planner),
    For(std::move(purpose))
{
  this->Mouse.click = [this](FrameView& view, const QPointF& pixel)
  { this->Add(TouchAt(this->Of, view, pixel, this->For.onBone)); };
  this->Mouse.press = [this](FrameView& view, const QPointF& pixel)
  { return this->Press(view, pixel); };
  this->Mouse.drag = [this](FrameView& view, const QPointF& pixel) { this->Drag(view, pixel); };
  this->Mouse.release = [this](FrameView&, const QPointF&) { this->Release(); };
  this->Mouse.grips = [this](FrameView& view, const QPointF& pixel)
  { return this->At(view, pixel) >= 0; };
  this->Mouse.key = [this](const QKeyEvent& key) { return this->Key(key); };
}

LandmarkTool::~LandmarkTool()
{
  if (this->Of.tools.InHand() == this)
    this->Of.tools.Take(nullptr);
}

void LandmarkTool::Begin()
{
  this->Mouse.Watch(this->Of.views);
  this->Update();
}

void LandmarkTool::End()
{
  this->Mouse.Leave();
  this->Update();
  if (std::exchange(this->Moved, false))
    Q_EMIT this->Edited();
}

void LandmarkTool::Show(bool shown)
{
  this->Shown = shown;
  this->Update();
}

QString LandmarkTool::Hint() const
{
  return this->For.hint + QStringLiteral(" ") +
         tr("Drag: move it, Delete: remove it, Insert: at the crosshair, Esc: back.");
}

void LandmarkTool::SetPurpose(const LandmarkPurpose& purpose)
{
  this->For = purpose;
  Q_EMIT this->HintChanged();
  this->Update();
}

void LandmarkTool::SetPlaces(std::vector<TouchedPlace> places)
{
  this->All = std::move(places);
  this->Moved = false;
  if (this->Chosen >= int(this->All.size()))
    this->Select(-1);
  this->Update();
}

void LandmarkTool::Select(int place)
{
  if (place == this->Chosen)
    return;
  this->Chosen = place;
  this->Update();
  Q_EMIT this->SelectedChanged(place);
}

bool LandmarkTool::TouchCrosshair()
{
  const auto place = hasp::TouchCrosshair(this->Of, this->For.onBone);
  if (!place)
    this->Of.SayFault(tr("There is no crosshair: show a scan first."));
  return place && this->Add(place);
}

bool LandmarkTool::RemoveSelected()
{
  if (this->Chosen < 0 || this->Chosen >= int(this->All.size()))
    return false;
  this->All.erase(this->All.begin() + this->Chosen);
  this->Select(this->Chosen < int(this->All.size()) ? this->Chosen : int(this->All.size()) - 1);
  this->Update();
  Q_EMIT this->Edited();
  return true;
}

bool LandmarkTool::IsBone(const TouchedPlace& place) const
{
  const Plan& plan = this->Of.plan.Now();
  if (place.object == 0 || FindPlanObject<PlanFragment>(plan, place.object))
    return true;
  this->Of.SayFault(tr("That is %1 and no bone: hide it, or touch beside it.")
                      .arg(QString::fromStdString(CalledObject(plan, place.object))));
  return false;
}

bool LandmarkTool::Add(const std::optional<TouchedPlace>& place)
{
  if (!place || !this->IsBone(*place))
    return false;
  if (this->For.most == 1)
    this->All.clear();
  if (this->All.size() >= this->For.most)
  {
    this->Of.SayFault(
      tr("There are %1 places, and no more are taken: drag one to another place, or "
         "remove one.")
        .arg(this->For.most));
    return false;
  }
  this->All.push_back(*place);
  this->Select(int(this->All.size()) - 1);
  this->Update();
  Q_EMIT this->Edited();
  return true;
}

int LandmarkTool::At(FrameView& view, const QPointF& pixel) const
{
  if (!this->Marks)
    return -1;
  const MarkedView marked = this->Marks->Of(view);
  double nearest = GripPixels;
  int found = -1;
  for (std::size_t n = 0; n < this->All.size(); ++n)
  {
    const TouchedPlace& place = this->All[n];
    const auto at = marked.PixelOf(marked.slice ? place.inScan : place.world); // as Paint
    if (!at || marked.Off(place.inScan) > SliceMm || !marked.Faces(place.world, place.normal))
      continue;
    if (const double away = QLineF(*at, pixel).length(); away <= nearest)
      nearest = away, found = int(n);
  }
  return found;
}

bool LandmarkTool::Press(FrameView& view, const QPointF& pixel)
{
  const int place = this->At(view, pixel);
  if (place >= 0)
    this->Select(place);
  return place >= 0;
}

void LandmarkTool::Drag(FrameView& view, const QPointF& pixel)
{
  const auto place = TouchAt(this->Of, view, pixel, this->For.onBone);
  const bool bone = place && (place->object == 0 ||
                               FindPlanObject<PlanFragment>(this->Of.plan.Now(), place->object));
  if (!bone || this->Chosen < 0 || this->Chosen >= int(this->All.size()))
    return; // off the bone it stays where it was
  this->All[std::size_t(this->Chosen)] = *place;
  this->Moved = true;
  this->Update();
}

void LandmarkTool::Release()
{
  if (std::exchange(this->Moved, false))
    Q_EMIT this->Edited();
}

bool LandmarkTool::Key(const QKeyEvent& key)
{
  if (key.modifiers() & ~Qt::KeypadModifier)
    return false;
  switch (key.key())
  {
    case Qt::Key_Insert:
      this->TouchCrosshair();
      return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      this->RemoveSelected();
      return true;
    default:
      return false;
  }
}

void LandmarkTool::Paint(QPainter& painter, const MarkedView& view) const
{
  const bool closed = this->For.line == LandmarkPurpose::Line::Closed;
  const auto where = [&](const TouchedPlace& place)
  { return view.PixelOf(view.slice ? place.inScan : place.world); };
  if (this->For.line != LandmarkPurpose::Line::None && !view.slice)
    for (std::size_t n = closed && this->All.size() > 2 ? 0 : 1; n < this->All.size(); ++n)
    {
      const auto from = where(n == 0 ? this->All.back() : this->All[n - 1]),
                 to = where(this->All[n]);
      if (from && to)
        PaintLine(painter, *from, *to, this->For.colour);
    }
  for (std::size_t n = 0; n < this->All.size(); ++n)
  {
    const TouchedPlace& place = this->All[n];
    const double off = view.Off(place.inScan);
    const auto at = where(place);
    if (!at || off > SliceMm)
      continue;
    PaintBall(painter, *at, this->For.colour, QString::number(n + 1), int(n) == this->Chosen,
      off > FaintMm || !view.Faces(place.world, place.normal));
  }
}

void LandmarkTool::Update()
{
  const bool inHand = this->Of.tools.InHand() == this;
  if (!inHand && (!this->Shown || this->All.empty()))
    this->Marks.reset();
  else if (this->Marks)
    this->Marks->Update();
  else
    this->Marks = std::make_unique<ToolMarks>(this->Of.views,
      [this](QPainter& painter, const MarkedView& view) { this->Paint(painter, view); });
}

} // namespace hasp
