#include "Tools/PaintTool.h"

#include "Tools/Planner.h"
#include "Tools/StrokeEdits.h"
#include "View/SliceView.h"
#include "vtkHaspSeedPainter.h"

#include "QVTKInteractor.h"
#include "vtkImageSlice.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <QTimer>

#include <algorithm>

namespace hasp
{

PaintTool::PaintTool(Planner& planner, QObject* parent)
  : Tool(parent),
    Of(planner),
    Faults([&planner](const QString& text) { planner.SayFault(text); }),
    Shown(planner)
{
  this->Command->SetClientData(this);
  this->Command->SetCallback([](vtkObject* painter, unsigned long event, void* self, void*)
    { static_cast<PaintTool*>(self)->Heard(*static_cast<vtkHaspSeedPainter*>(painter), event); });
  this->BeforePress->SetClientData(this);
  this->BeforePress->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<PaintTool*>(self)->LookBeforePress(); });
}

PaintTool::~PaintTool()
{
  if (this->Of.tools.InHand() == this)
    this->Of.tools.Take(nullptr);
}

void PaintTool::Begin()
{
  this->Canvases = { { &this->Of.views.Scene(), nullptr, {} } };
  for (const SliceAxis axis : { SliceAxis::Axial, SliceAxis::Coronal, SliceAxis::Sagittal })
    this->Canvases.push_back(
      { &this->Of.views.Slice(axis), this->Of.views.Slice(axis).Prop(), {} });
  for (Canvas& canvas : this->Canvases)
  {
    canvas.painter = vtkSmartPointer<vtkHaspSeedPainter>::New();
    this->Faults.Follow(canvas.painter);
    canvas.painter->SetRenderer(canvas.view->Renderer());
    canvas.painter->SetSlice(canvas.slice);
    this->SetUp(*canvas.painter);
    for (const unsigned long event : { vtkHaspSeedPainter::StrokeStartedEvent,
           vtkHaspSeedPainter::StrokeChangedEvent, vtkHaspSeedPainter::StrokeEndedEvent,
           vtkHaspSeedPainter::StrokeCancelledEvent, vtkHaspSeedPainter::RadiusChangedEvent })
      canvas.painter->AddObserver(event, this->Command);
    canvas.painter->EnabledOn();
  }
  this->Of.views.Scene().interactor()->AddObserver(
    vtkCommand::LeftButtonPressEvent, this->BeforePress, 2.0F); // before the painter
  this->Shown.Show();
}

/// A painter asks for a frame whose depth it has not, and our frames come later: too late for a
/// press that no motion came before, or that ended a turn of the view.
void PaintTool::LookBeforePress()
{
  const int* at = this->Of.views.Scene().interactor()->GetEventPosition();
  double place[3];
  if (!this->Canvases.front().painter->GetPlace(at[0], at[1], place))
    this->Of.views.Scene().renderWindow()->Render();
}

void PaintTool::End()
{
  this->Of.views.Scene().interactor()->RemoveObserver(this->BeforePress);
  for (Canvas& canvas : this->Canvases)
  {
    canvas.painter->RemoveObserver(this->Command); // a drag that is cut off here is none
    canvas.painter->EnabledOff();
  }
  this->Canvases.clear();
  this->Shown.SetDrag({});
  this->Shown.Hide();
}

QString PaintTool::Hint() const
{
  return this->Erases
           ? tr("Drag over strokes to take them away. Shift and wheel: size. Esc: back")
           : tr(
               "Drag on bone to paint label %1. Shift and wheel: size. Beside bone the view turns. "
               "Esc: back")
               .arg(this->Now);
}

void PaintTool::SetUp(vtkHaspSeedPainter& painter) const
{
  painter.SetLabel(this->Now);
  painter.SetErase(this->Erases);
  painter.SetRadiusMm(this->RadiusMm);
  for (const LabelName& name : this->Names)
  {
    const auto [r, g, b] = name.colour;
    painter.SetLabelColor(name.label, r / 255.0, g / 255.0, b / 255.0);
  }
}

void PaintTool::SetLabel(int label)
{
  this->Now = std::clamp(label, 1, 65535);
  for (const Canvas& canvas : this->Canvases)
    canvas.painter->SetLabel(this->Now);
  Q_EMIT this->HintChanged();
}

void PaintTool::SetEraser(bool erases)
{
  this->Erases = erases;
  for (const Canvas& canvas : this->Canvases)
    canvas.painter->SetErase(erases);
  Q_EMIT this->HintChanged();
}

void PaintTool::SetRadius(double mm)
{
  mm = std::clamp(mm, 0.1, 50.0);
  if (mm == this->RadiusMm)
    return;
  this->RadiusMm = mm;
  for (const Canvas& canvas : this->Canvases)
    canvas.painter->SetRadiusMm(mm);
  Q_EMIT this->RadiusChanged(mm);
}

void PaintTool::SetNames(const std::vector<LabelName>& names)
{
  this->Names = names;
  for (const Canvas& canvas : this->Canvases)
    this->SetUp(*canvas.painter);
}

void PaintTool::Heard(vtkHaspSeedPainter& painter, unsigned long event)
{
  switch (event)
  {
    case vtkHaspSeedPainter::RadiusChangedEvent:
      this->SetRadius(painter.GetRadiusMm());
      break;
    case vtkHaspSeedPainter::StrokeStartedEvent:
    case vtkHaspSeedPainter::StrokeChangedEvent:
      this->Shown.SetDrag(painter.GetPieces());
      break;
    case vtkHaspSeedPainter::StrokeEndedEvent:
      this->Shown.SetDrag({});
      this->Take(painter.GetPieces());
      break;
    default: // cancelled
      this->Shown.SetDrag({});
  }
}

bool PaintTool::PaintAt(const glm::dvec3& place)
{
  const auto label = std::uint16_t(this->Erases ? 0 : this->Now);
  return this->Take({ { label, this->RadiusMm, { place } } });
}

bool PaintTool::Take(const std::vector<BrushStroke>& pieces)
{
  const PlanId volume = this->Of.scene.ShownImage() ? this->Of.scene.ShownVolume() : 0;
  if (volume == 0)
  {
    this->Of.SayFault(tr("No scan is shown that could be painted on: import one, or show it."));
    return false;
  }
  const Plan& plan = this->Of.plan.Now();
  if (this->Erases)
  {
    const std::optional<PlanEdit> edit = EraseEdit(plan, volume, pieces);
    if (!edit)
      this->Of.Say(tr("There is no stroke under the eraser."));
    return edit && this->Of.plan.Do(*edit, tr("Erase strokes"));
  }
  const PaintedSegmentation first{ volume, tr("painted").toStdString(), this->Of.scene.Isovalue(),
    this->Names };
  return this->Of.plan.Do(
    PaintEdits(plan, this->Of.plan.NewId(), first, pieces), tr("Paint label %1").arg(this->Now));
}

} // namespace hasp
