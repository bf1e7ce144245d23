#include "Tools/BladeTool.h"

#include "Planning/BladePlacing.h"
#include "Planning/PlanEdits.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"
#include "Tools/Touch.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProp3D.h"

#include <QLineF>
#include <QPainter>

#include <array>

namespace hasp
{

namespace
{
const QColor ShiftColour(80, 200, 255), TurnColour(255, 120, 200), EdgeColour(80, 200, 255);

/// What brings the one blade to where the other is.
vtkSmartPointer<vtkMatrix4x4> Motion(const Osteotomy& from, const Osteotomy& to)
{
  const glm::dmat3 turn = BladeAxes(to) * glm::transpose(BladeAxes(from));
  const glm::dvec3 shift = to.point - turn * from.point;
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
      matrix->SetElement(row, column, turn[column][row]);
    matrix->SetElement(row, 3, shift[row]);
  }
  return matrix;
}
} // namespace

BladeTool::BladeTool(Planner& planner, QObject* parent) : Tool(parent), Of(planner)
{
  this->Mouse.press = [this](FrameView& view, const QPointF& pixel)
  { return this->Press(view, pixel); };
  this->Mouse.drag = [this](FrameView& view, const QPointF& pixel) { this->Drag(view, pixel); };
  this->Mouse.release = [this](FrameView&, const QPointF&) { this->Release(); };
  this->Mouse.grips = [this](FrameView& view, const QPointF& pixel)
  { return this->At(view, pixel).has_value(); };
  connect(&planner.plan, &PlanSession::Changed, this, &BladeTool::Follow);
}

BladeTool::~BladeTool()
{
  if (this->Of.tools.InHand() == this)
    this->Of.tools.Take(nullptr);
}

void BladeTool::Begin()
{
  this->Marks = std::make_unique<ToolMarks>(this->Of.views,
    [this](QPainter& painter, const MarkedView& view) { this->Paint(painter, view); });
  this->Mouse.Watch(this->Of.views);
  this->Marks->Update();
}

void BladeTool::End()
{
  this->PutBack();
  this->Mouse.Leave();
  this->Marks.reset();
}

QString BladeTool::Hint() const
{
  return tr(
    "Drag the blade's middle to shift it, its arrow to move it along its normal, a corner to "
    "turn it. Escape ends.");
}

void BladeTool::SetCut(PlanId cut)
{
  if (cut == this->Chosen)
    return;
  this->PutBack();
  this->Chosen = cut;
  this->Follow();
}

void BladeTool::Follow()
{
  this->PutBack(); // another plan: what was dragged was of the old one
  if (this->Chosen != 0 && !this->Found())
    this->Chosen = 0;
  if (this->Marks)
    this->Marks->Update();
}

const PlanCut* BladeTool::Found() const
{
  return FindPlanObject<PlanCut>(this->Of.plan.Now(), this->Chosen);
}

std::optional<Osteotomy> BladeTool::Shown() const
{
  if (this->Holds)
    return this->Holds->now;
  const PlanCut* cut = this->Found();
  return cut ? std::optional(cut->blade) : std::nullopt;
}

bool BladeTool::Put(const Osteotomy& blade)
{
  const PlanCut* found = this->Found();
  if (!found)
    return false;
  PlanCut cut = *found;
  cut.blade = blade;
  return this->Of.plan.Do(ChangeObject<PlanCut>{ cut }, tr("Move cut %1").arg(cut.id));
}

std::optional<QPointF> BladeTool::PixelOf(FrameView& view, BladeHandle handle) const
{
  const auto blade = this->Shown();
  return blade ? view.PixelOf(HandlePlace(*blade, handle)) : std::nullopt;
}

std::optional<BladeHandle> BladeTool::At(FrameView& view, const QPointF& pixel) const
{
  double nearest = GripPixels;
  std::optional<BladeHandle> found;
  for (const BladeHandle handle : BladeHandleList)
    if (const auto at = this->PixelOf(view, handle); at && QLineF(*at, pixel).length() <= nearest)
    {
      nearest = QLineF(*at, pixel).length();
      found = handle;
    }
  return found;
}

bool BladeTool::Press(FrameView& view, const QPointF& pixel)
{
  const auto handle = this->At(view, pixel);
  const auto blade = this->Shown();
  if (!handle || !blade)
    return false;
  Held held{ *handle, *blade, *blade, RayOf(this->Of, view, pixel), {}, {} };
  held.prop = this->Of.scene.PropOf(this->Chosen);
  if (held.prop)
  {
    held.matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    if (vtkMatrix4x4* own = held.prop->GetUserMatrix())
      held.matrix->DeepCopy(own);
  }
  this->Holds = held;
  return true;
}

void BladeTool::Drag(FrameView& view, const QPointF& pixel)
{
  if (!this->Holds)
    return;
  const PointerRay to = RayOf(this->Of, view, pixel);
  this->Holds->now = DraggedBlade(this->Holds->start, this->Holds->handle, this->Holds->from, to);
  this->MoveProp();
  Q_EMIT this->Dragged(this->Holds->now);
  this->Marks->Update();
}

void BladeTool::MoveProp()
{
  if (!this->Holds->prop)
    return;
  vtkNew<vtkMatrix4x4> moved;
  vtkMatrix4x4::Multiply4x4(
    Motion(this->Holds->start, this->Holds->now), this->Holds->matrix, moved);
  this->Holds->prop->SetUserMatrix(moved);
  this->Of.views.Scene().Moving();
  this->Of.views.Scene().Draw();
}

void BladeTool::Release()
{
  if (!this->Holds)
    return;
  const Osteotomy start = this->Holds->start, now = this->Holds->now;
  this->PutBack(); // the scene follows the plan
  if (!(now == start))
    this->Put(now);
}

void BladeTool::PutBack()
{
  if (!this->Holds)
    return;
  if (this->Holds->prop)
  {
    this->Holds->prop->SetUserMatrix(this->Holds->matrix);
    this->Of.views.Scene().Draw();
  }
  this->Holds.reset();
  if (this->Marks)
    this->Marks->Update();
}

void BladeTool::Paint(QPainter& painter, const MarkedView& view) const
{
  const auto blade = this->Shown();
  if (!blade)
    return;
  const std::array corners{ BladeHandle::Corner0, BladeHandle::Corner1, BladeHandle::Corner2,
    BladeHandle::Corner3 };
  const auto at = [&](BladeHandle handle) { return view.PixelOf(HandlePlace(*blade, handle)); };
  const auto line = [&](BladeHandle from, BladeHandle to)
  {
    if (const auto a = at(from), b = at(to); a && b)
      PaintLine(painter, *a, *b, EdgeColour);
  };
  for (std::size_t n = 0; n < corners.size(); ++n)
    line(corners[n], corners[(n + 1) % corners.size()]);
  line(BladeHandle::Middle, BladeHandle::Normal);
  for (const BladeHandle handle : BladeHandleList)
  {
    const bool turns = handle >= BladeHandle::Corner0;
    const bool held = this->Holds && this->Holds->handle == handle;
    if (const auto pixel = at(handle))
      PaintBall(painter, *pixel, turns ? TurnColour : ShiftColour, {}, held, false);
  }
}

} // namespace hasp
