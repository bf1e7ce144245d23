#include "Steps/SplitPanel.h"

#include "Steps/BonesBox.h"
#include "Steps/FragmentMaking.h"
#include "Steps/IsovalueBox.h"
#include "Steps/LabelList.h"
#include "Steps/PanelWidgets.h"
#include "Tools/StrokeEdits.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <optional>

namespace hasp
{

SplitPanel::SplitPanel(Planner& planner, QWidget* parent)
  : StepPanel(planner, parent),
    Brush(planner)
{
  auto* layout = new QVBoxLayout(this);
  auto* bone = new QGroupBox(tr("Bone"));
  auto* inBone = new QVBoxLayout(bone);
  inBone->addWidget(new IsovalueBox(planner));
  layout->addWidget(bone);
  layout->addWidget(this->MakePainting());
  this->Bones = new BonesBox(planner);
  layout->addWidget(this->Bones);
  layout->addStretch(1);

  connect(&planner.tools, &ToolBox::Changed, this, &SplitPanel::Refresh);
  connect(&planner.plan, &PlanSession::Changed, this, &SplitPanel::Refresh);
  connect(&planner.scene, &PlanScene::PropsChanged, this, &SplitPanel::Refresh);
  connect(&planner.scene, &PlanScene::IsovalueChanged, this, &SplitPanel::Refresh);
  connect(&planner.scene, &PlanScene::IsovalueChanged, this, &SplitPanel::ShowLine);
  connect(&this->Brush.Preview(), &PaintPreview::WorkChanged, this, &SplitPanel::ShowWork);
  this->Brush.SetNames(this->Labels->Names());
  this->Brush.SetLabel(this->Labels->Label());
  this->Refresh();
  this->ShowWork();
}

/// Tools are put away while all that follows them is there.
SplitPanel::~SplitPanel()
{
  SplitPanel::Leave();
}

QGroupBox* SplitPanel::MakePainting()
{
  auto* group = new QGroupBox(tr("Fragments by painting"));
  auto* layout = new QVBoxLayout(group);
  this->Painting = AddButton(layout, "split.paint", tr("&Paint"));
  this->Painting->setCheckable(true);
  connect(this->Painting, &QPushButton::clicked, this,
    [this](bool on) { this->Of.tools.Take(on ? &this->Brush : nullptr); });

  this->Labels = new LabelList(this->Of);
  layout->addWidget(this->Labels);
  connect(this->Labels, &LabelList::LabelChosen, &this->Brush, &PaintTool::SetLabel);
  connect(this->Labels, &LabelList::NamesChanged, this,
    [this] { this->Brush.SetNames(this->Labels->Names()); });

  QBoxLayout* row = AddRow(layout);
  this->Radius = AddSpinBox(row, "split.radius", tr("&Brush"), { 0.1, 50.0, 2.0, tr(" mm") });
  connect(this->Radius, QOverload<double>::of(&QDoubleSpinBox::valueChanged), &this->Brush,
    &PaintTool::SetRadius);
  connect(&this->Brush, &PaintTool::RadiusChanged, this,
    [this](double mm)
    {
      const QSignalBlocker quiet(this->Radius);
      this->Radius->setValue(mm);
    });
  this->Eraser = new QCheckBox(tr("E&raser"));
  this->Eraser->setObjectName("split.eraser");
  connect(this->Eraser, &QCheckBox::toggled, &this->Brush, &PaintTool::SetEraser);
  row->addWidget(this->Eraser);

  this->AtCrosshair = AddButton(layout, "split.paint.crosshair", tr("Paint at the cros&shair"));
  connect(this->AtCrosshair, &QPushButton::clicked, this,
    [this] { this->Brush.PaintAt(this->Of.views.Crosshair()); });
  this->Working = new QProgressBar;
  this->Working->setObjectName("split.working");
  this->Working->setFormat(tr("sharing out bone: %p %"));
  layout->addWidget(this->Working);
  this->AddCleaning(layout);
  this->Make = AddButton(layout, "split.make", tr("Ma&ke fragments"));
  connect(this->Make, &QPushButton::clicked, this,
    [this]
    {
      if (const PlanSegmentation* painted =
            PaintedIn(this->Of.plan.Now(), this->Of.scene.ShownVolume()))
        MakeFragmentsOf(this->Of, painted->id);
    });
  return group;
}

void SplitPanel::AddCleaning(QBoxLayout* layout)
{
  this->Rethreshold =
    AddButton(layout, "split.rethreshold", tr("Split by the isovalue that is set &now"));
  connect(this->Rethreshold, &QPushButton::clicked, this, &SplitPanel::UseIsovalue);
  this->Fill = AddButton(layout, "split.fill", tr("Fill its cav&ities"));
  this->Fill->setToolTip(
    tr("Of the label that is chosen; shows when the fragments have been made."));
  connect(this->Fill, &QPushButton::clicked, this,
    [this]
    {
      const int label = this->Labels->Label();
      this->AddStep(FillStep{ std::uint16_t(label) }, tr("Fill cavities of label %1").arg(label));
    });
  QBoxLayout* row = AddRow(layout);
  this->Close = AddButton(row, "split.close", tr("Close its &gaps of"));
  this->Close->setToolTip(
    tr("Of the label that is chosen: gaps that a ball of this radius does not "
       "go through; shows when the fragments have been made."));
  this->CloseRadius = AddSpinBox(row, "split.close.radius", {}, { 0.1, 10.0, 1.0, tr(" mm") });
  this->CloseRadius->setAccessibleName(tr("Radius of gaps"));
  connect(this->Close, &QPushButton::clicked, this,
    [this]
    {
      const int label = this->Labels->Label();
      this->AddStep(
        MorphologyStep{ std::uint16_t(label), Morphology::Close, this->CloseRadius->value() },
        tr("Close gaps of label %1").arg(label));
    });
}

QString SplitPanel::StillNeeds() const
{
  if (this->Of.plan.Now().volumes.empty())
    return tr("Import a scan first.");
  if (!this->Of.scene.ShownImage())
    return tr("No scan is shown: show one, or locate it in the step Import.");
  return {};
}

void SplitPanel::Enter()
{
  this->Entered = true;
  this->ShowLine();
}

void SplitPanel::ShowLine()
{
  this->Of.views.SetIsovalueLine(this->Entered && this->Of.scene.ShownImage()
                                   ? std::optional(this->Of.scene.Isovalue())
                                   : std::nullopt);
}

void SplitPanel::Leave()
{
  this->Entered = false;
  this->ShowLine();
  this->Bones->PutAway();
  if (this->Of.tools.InHand() == &this->Brush)
    this->Of.tools.Take(nullptr);
  this->Brush.Preview().Release();
}

void SplitPanel::Refresh()
{
  const bool has = this->Of.scene.ShownImage() != nullptr;
  this->Painting->setChecked(this->Of.tools.InHand() == &this->Brush);
  this->Painting->setEnabled(has);
  this->AtCrosshair->setEnabled(has);
  const PlanSegmentation* painted =
    has ? PaintedIn(this->Of.plan.Now(), this->Of.scene.ShownVolume()) : nullptr;
  for (QPushButton* button : { this->Fill, this->Close, this->Make })
    button->setEnabled(painted != nullptr);
  this->Rethreshold->setVisible(
    painted && ThresholdOf(*painted)->lowest != this->Of.scene.Isovalue());
}

void SplitPanel::ShowWork()
{
  const PaintPreview& preview = this->Brush.Preview();
  this->Working->setVisible(preview.IsWorking());
  this->Working->setValue(int(100.0 * preview.Share()));
}

void SplitPanel::AddStep(const SegmentationStep& step, const QString& label)
{
  if (const PlanSegmentation* painted =
        PaintedIn(this->Of.plan.Now(), this->Of.scene.ShownVolume()))
    this->Of.plan.Do(AddSegmentationStep{ painted->id, step }, label);
}

void SplitPanel::UseIsovalue()
{
  const PlanSegmentation* painted = PaintedIn(this->Of.plan.Now(), this->Of.scene.ShownVolume());
  if (!painted)
    return;
  PlanSegmentation changed = *painted;
  for (SegmentationStep& step : changed.recipe.steps)
    if (auto* bone = std::get_if<ThresholdStep>(&step))
      bone->lowest = this->Of.scene.Isovalue();
  this->Of.plan.Do(
    ChangeObject<PlanSegmentation>{ std::move(changed) }, tr("Split by another isovalue"));
}

} // namespace hasp
