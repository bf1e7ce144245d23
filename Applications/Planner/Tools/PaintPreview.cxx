#include "Tools/PaintPreview.h"

#include "LabelPalette.h"
#include "Tools/Planner.h"
#include "Tools/StrokeEdits.h"
#include "vtkHaspClusteredCellMapper.h"
#include "vtkHaspSegmentationSession.h"
#include "vtkHaspStrokeActor.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkProp3D.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace hasp
{
namespace
{
constexpr int PollMs = 30;
}

PaintPreview::PaintPreview(Planner& planner, QObject* parent)
  : QObject(parent),
    Of(planner),
    Faults([&planner](const QString& text) { planner.SayFault(text); }),
    Covered(planner.views.Scene())
{
  this->Polling.setInterval(PollMs);
  connect(&this->Polling, &QTimer::timeout, this, &PaintPreview::Poll);
  connect(&planner.plan, &PlanSession::Changed, this, &PaintPreview::Follow);
  connect(&planner.scene, &PlanScene::PropsChanged, this, &PaintPreview::Follow);
  connect(&planner.scene, &PlanScene::IsovalueChanged, this, &PaintPreview::Follow);
}

PaintPreview::~PaintPreview()
{
  this->Release();
}

void PaintPreview::Show()
{
  if (!this->Session)
  {
    this->Session = vtkSmartPointer<vtkHaspSegmentationSession>::New();
    this->Mapper = vtkSmartPointer<vtkHaspClusteredCellMapper>::New();
    this->Bone = vtkSmartPointer<vtkActor>::New();
    this->Bone->SetMapper(this->Mapper);
    this->Balls = vtkSmartPointer<vtkHaspStrokeActor>::New();
    for (vtkObject* object : { static_cast<vtkObject*>(this->Session),
           static_cast<vtkObject*>(this->Mapper), static_cast<vtkObject*>(this->Balls) })
      this->Faults.Follow(object);
    this->Session->SetMapper(this->Mapper);
    this->Of.views.Scene().Renderer()->AddActor(this->Bone);
    this->Of.views.Scene().Renderer()->AddViewProp(this->Balls);
  }
  this->Shown = true;
  this->Balls->VisibilityOn();
  this->Follow();
}

void PaintPreview::Hide()
{
  if (!this->Shown)
    return;
  this->Shown = false;
  this->Balls->VisibilityOff();
  this->Cover();
  this->Of.views.SetLabels(nullptr, {});
  this->Of.views.DrawAll();
}

void PaintPreview::Release()
{
  this->Hide();
  if (!this->Session)
    return;
  this->Polling.stop();
  this->Of.views.Scene().Renderer()->RemoveActor(this->Bone);
  this->Of.views.Scene().Renderer()->RemoveViewProp(this->Balls);
  this->Session = nullptr; // waits for its WORKER, which gives up
  this->Mapper = nullptr;
  this->Bone = nullptr;
  this->Balls = nullptr;
  this->Now = {};
  this->LabelMap = nullptr;
  Q_EMIT this->LabelsChanged();
  Q_EMIT this->WorkChanged();
}

void PaintPreview::Follow()
{
  if (!this->Session)
    return;
  Way way;
  way.scan = this->Of.scene.ShownImage();
  const PlanSegmentation* painted =
    way.scan ? PaintedIn(this->Of.plan.Now(), this->Of.scene.ShownVolume()) : nullptr;
  const SplitStep* split = painted ? SplitOf(*painted) : nullptr;
  if (split)
  {
    const ThresholdStep& bone = *ThresholdOf(*painted);
    way = { way.scan, bone.lowest, bone.highest, split->beta, split->crack, split->norm };
  }
  if (!(way == this->Now))
  {
    this->Session->SetScan(way.scan);
    this->Session->SetLowestBone(way.lowest);
    this->Session->SetHighestBone(way.highest);
    this->Session->SetBeta(way.beta);
    this->Session->SetCrack(way.crack);
    this->Session->SetNorm(way.norm);
    this->Now = way;
    this->LabelMap = nullptr;
    if (vtkImageData* image = this->Session->GetImage())
    {
      this->LabelMap = vtkSmartPointer<vtkImageData>::New();
      this->LabelMap->CopyStructure(image);
      this->LabelMap->GetPointData()->SetScalars(image->GetPointData()->GetArray("Labels"));
    }
    Q_EMIT this->LabelsChanged();
  }
  this->FollowStrokes(split ? split->strokes : std::vector<BrushStroke>{});
  this->ColourLabels(painted ? painted->recipe.names : std::vector<LabelName>{});
  this->Mapper->SetIsoValue(this->Of.scene.Isovalue());
  this->ShowStrokes();
  this->Cover();
}

/// Each stroke is a drag of the session's, so that each can be taken back alone.
void PaintPreview::FollowStrokes(const std::vector<BrushStroke>& strokes)
{
  const std::vector<BrushStroke> known = this->Session->GetStrokes();
  std::size_t common = 0;
  while (common < std::min(strokes.size(), known.size()) && strokes[common] == known[common])
    ++common;
  for (std::size_t n = common; n < known.size(); ++n)
    this->Session->Undo();
  for (std::size_t n = common; n < strokes.size(); ++n)
    if (!this->Session->AddStrokes({ strokes[n] }))
      break; // it has said why
  if (this->Session->IsWorking())
    this->Polling.start();
  this->Poll();
}

void PaintPreview::ColourLabels(const std::vector<LabelName>& names)
{
  std::map<int, glm::dvec3> colours;
  for (const BrushStroke& stroke : this->Session->GetStrokes())
    colours[stroke.label] = PaletteColour(stroke.label);
  for (const LabelName& name : names)
    colours[name.label] = glm::dvec3(name.colour[0], name.colour[1], name.colour[2]) / 255.0;
  for (const auto& [label, colour] : colours)
  {
    this->Mapper->SetLabelColor(label, colour.x, colour.y, colour.z);
    this->Balls->SetLabelColor(label, colour.x, colour.y, colour.z);
  }
  this->Of.views.SetLabels(this->Shown ? this->LabelMap : nullptr, colours);
}

void PaintPreview::SetDrag(const std::vector<BrushStroke>& pieces)
{
  this->Drag = pieces;
  this->ShowStrokes();
}

void PaintPreview::ShowStrokes()
{
  if (!this->Balls)
    return;
  std::vector<BrushStroke> all = this->Session->GetStrokes();
  all.insert(all.end(), this->Drag.begin(), this->Drag.end());
  this->Balls->SetStrokes(all);
  this->Of.views.Scene().Draw();
}

/// The scene's own bone and fragments give way while there is something to be seen here.
void PaintPreview::Cover()
{
  const bool covers =
    this->Shown && this->Now.scan && (this->Strokes() > 0 || !this->Of.scene.ScanProp());
  this->Bone->SetVisibility(covers);
  std::vector<vtkProp*> covered;
  if (covers && this->Of.scene.ScanProp())
    covered.push_back(this->Of.scene.ScanProp());
  if (covers)
    for (const PlanFragment& fragment : this->Of.plan.Now().fragments)
      if (vtkProp3D* prop = this->Of.scene.PropOf(fragment.id))
        covered.push_back(prop);
  this->Covered.Set(covered);
}

void PaintPreview::Poll()
{
  if (this->Session)
    this->Tell(this->Session->Update());
}

void PaintPreview::Finish()
{
  if (this->Session)
    this->Tell(this->Session->Finish());
}

void PaintPreview::Tell(bool changed)
{
  if (!this->Session->IsWorking())
    this->Polling.stop();
  if (changed)
  {
    this->Of.views.DrawAll();
    Q_EMIT this->LabelsChanged();
  }
  Q_EMIT this->WorkChanged();
}

bool PaintPreview::IsWorking() const
{
  return this->Session && this->Session->IsWorking();
}

double PaintPreview::Share() const
{
  return this->Session ? this->Session->GetProgress() : 0.0;
}

int PaintPreview::Strokes() const
{
  return this->Session ? this->Session->GetNumberOfDrags() : 0;
}

vtkImageData* PaintPreview::Labels() const
{
  return this->LabelMap;
}

} // namespace hasp
