#include "Steps/ReducePanel.h"

#include "Model/ObjectNames.h"
#include "Planning/PlanLists.h"
#include "Steps/FragmentTable.h"
#include "Steps/MoveEdits.h"
#include "Steps/NudgePad.h"
#include "Steps/PanelWidgets.h"
#include "Steps/ReductionProposals.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>

namespace hasp
{

ReducePanel::ReducePanel(Planner& planner, QWidget* parent)
  : StepPanel(planner, parent),
    Hand(planner),
    Colours(planner)
{
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(this->MakeFragments());
  layout->addWidget(this->MakeByHand());
  layout->addWidget(this->MakeAutomatic());
  layout->addStretch(1);
  connect(&planner.tools, &ToolBox::Changed, this, &ReducePanel::Refresh);
  connect(&planner.plan, &PlanSession::Changed, this, &ReducePanel::Refresh);
  connect(&planner.scene, &PlanScene::PropsChanged, this, &ReducePanel::Refresh);
  connect(&planner.scene, &PlanScene::SelectedChanged, this, &ReducePanel::FollowColours);
  connect(&this->Hand, &GrabTool::HeldChanged, this, &ReducePanel::FollowColours);
  connect(&this->Hand, &GrabTool::StateChanged, this, &ReducePanel::ShowState);
  this->Refresh();
  this->ShowState();
}

/// Tools are put away while all that follows them is there.
ReducePanel::~ReducePanel()
{
  ReducePanel::Leave();
}

QGroupBox* ReducePanel::MakeByHand()
{
  auto* group = new QGroupBox(tr("By hand"));
  auto* layout = new QVBoxLayout(group);
  this->Grabbing = AddButton(layout, "reduce.grab", tr("&Grab"));
  this->Grabbing->setCheckable(true);
  connect(this->Grabbing, &QPushButton::clicked, this,
    [this](bool on) { this->Of.tools.Take(on ? &this->Hand : nullptr); });
  QCheckBox* snap = AddCheckBox(layout, "reduce.snap", tr("&Snap to fit"));
  snap->setToolTip(tr("Faces that broke apart attract each other"));
  connect(snap, &QCheckBox::toggled, &this->Hand, &GrabTool::SetSnap);
  QCheckBox* forces = AddCheckBox(layout, "reduce.forces", tr("Show for&ces"));
  connect(forces, &QCheckBox::toggled, &this->Hand, &GrabTool::SetShowForces);
  this->Distances = AddCheckBox(layout, "reduce.distances", tr("Show &distances as colours"));
  this->Distances->setToolTip(
    tr("Of the fragment in hand, or selected, to all others: −3 mm (inside) to 3 mm"));
  connect(this->Distances, &QCheckBox::toggled, &this->Colours, &DistanceColours::SetOn);
  this->Contact = new QLabel;
  this->Contact->setObjectName("reduce.contact");
  this->Contact->setWordWrap(true);
  layout->addWidget(this->Contact);
  layout->addWidget(new NudgePad(this->Of));
  return group;
}

QGroupBox* ReducePanel::MakeFragments()
{
  auto* group = new QGroupBox(tr("Fragments"));
  auto* layout = new QVBoxLayout(group);
  this->Table = new FragmentTable(this->Of);
  this->Table->setMaximumHeight(180);
  layout->addWidget(this->Table);
  connect(this->Table, &FragmentTable::SelectionChanged, this, &ReducePanel::Refresh);
  QBoxLayout* row = AddRow(layout);
  this->Grouping = AddButton(row, "reduce.group", tr("Grou&p"));
  connect(this->Grouping, &QPushButton::clicked, this, &ReducePanel::Group);
  this->Ungrouping = AddButton(row, "reduce.ungroup", tr("U&ngroup"));
  connect(this->Ungrouping, &QPushButton::clicked, this,
    [this]
    {
      this->Of.plan.Do(
        UngroupEdits(this->Of.plan.Now(), this->Table->Selected()), tr("Take groups apart"));
    });
  this->Locking = AddButton(row, "reduce.lock", tr("Stays: &lock"));
  this->Locking->setToolTip(tr("The reference, such as the cranium: it does not move"));
  connect(this->Locking, &QPushButton::clicked, this,
    [this]
    {
      this->Of.plan.Do(
        LockEdits(this->Of.plan.Now(), this->Table->Selected()), tr("Lock or free fragments"));
    });
  this->Mirror = AddButton(layout, "reduce.mirror", tr("Add the mirror &image"));
  connect(this->Mirror, &QPushButton::clicked, this, &ReducePanel::AddMirror);
  return group;
}

QGroupBox* ReducePanel::MakeAutomatic()
{
  auto* group = new QGroupBox(tr("By themselves"));
  auto* layout = new QVBoxLayout(group);
  this->StartMm = AddSpinBox(
    AddRow(layout), "reduce.startmm", tr("They are &off by up to"), { 0.0, 100.0, 3.0, tr(" mm") });
  this->StartDegrees = AddSpinBox(AddRow(layout), "reduce.startdegrees", tr("and tu&rned by up to"),
    { 0.0, 180.0, 5.0, tr("°") });
  this->Automatic = AddButton(layout, "reduce.auto", tr("Find ho&w they fit"));
  connect(this->Automatic, &QPushButton::clicked, this, &ReducePanel::Reduce);
  this->Proposals = new ReductionProposals(this->Of);
  layout->addWidget(this->Proposals);
  connect(this->Proposals, &ReductionProposals::PreviewBegins, this,
    [this]
    {
      if (this->Of.tools.InHand() == &this->Hand)
        this->Of.tools.Take(nullptr);
    });
  return group;
}

QString ReducePanel::StillNeeds() const
{
  const std::size_t count = ReducibleFragments(this->Of.plan.Now()).size();
  if (count == 0)
    return tr("Make fragments first: paint them in the step Split, or import their labels.");
  return count == 1 ? tr("There is one fragment alone: make another, or cut it.") : QString();
}

void ReducePanel::Leave()
{
  if (this->Of.tools.InHand() == &this->Hand)
    this->Of.tools.Take(nullptr);
  this->Distances->setChecked(false);
  this->Proposals->SetPreview(false);
}

void ReducePanel::Refresh()
{
  const Plan& plan = this->Of.plan.Now();
  const std::vector<PlanId> selected = this->Table->Selected();
  const bool grabs = this->Of.tools.InHand() == &this->Hand;
  if (grabs)
    this->Proposals->SetPreview(false);
  this->Grabbing->setChecked(grabs);
  this->Grabbing->setEnabled(this->StillNeeds().isEmpty());
  this->Automatic->setEnabled(this->StillNeeds().isEmpty());
  this->Grouping->setEnabled(selected.size() > 1);
  this->Ungrouping->setEnabled(!UngroupEdits(plan, selected).empty());
  this->Locking->setEnabled(!selected.empty());
  this->Mirror->setEnabled(this->Of.scene.ShownVolume() != 0);
  this->FollowColours();
}

void ReducePanel::ShowState()
{
  const GrabState state = this->Hand.State();
  if (this->Of.tools.InHand() != &this->Hand)
    this->Contact->setText(tr("Nothing is felt: take Grab."));
  else if (state.held.empty())
    this->Contact->setText(state.isReady
                             ? tr("Nothing in hand: drag a fragment.")
                             : tr("Preparing what is felt: %1 %").arg(int(100 * state.share)));
  else if (state.isTouching)
    this->Contact->setText(tr("Touches: %1 N, %2 mm deep.")
                             .arg(state.contactN, 0, 'f', 1)
                             .arg(state.deepestMm, 0, 'f', 2));
  else if (state.attractionN > 0.0)
    this->Contact->setText(tr("Pulled in by %1 N.").arg(state.attractionN, 0, 'f', 1));
  else
    this->Contact->setText(tr("Free: touches nothing."));
}

void ReducePanel::FollowColours()
{
  std::vector<PlanId> held = this->Hand.State().held;
  if (held.empty())
    held = UnitOf(this->Of.plan.Now(), this->Of.scene.Selected());
  this->Colours.SetFragments(std::move(held));
}

void ReducePanel::Group()
{
  PlanGroup group;
  group.id = this->Of.plan.NewId();
  group.name = ObjectNames::Of<PlanGroup>(group.id);
  group.fragments = this->Table->Selected();
  this->Of.plan.Do(AddObject<PlanGroup>{ std::move(group) });
}

void ReducePanel::Reduce()
{
  auto work = std::make_shared<ReductionWork>(ReductionWork{
    PlanSnapshot(this->Of.plan.Document(), this->Of.scans, this->Of.plan.Folder()), {} });
  PlanReductionSettings& settings = work->settings;
  if (!this->Table->IsAll())
    settings.fragments = this->Table->Fitted();
  settings.obstacles = this->Table->Obstacles();
  settings.assembly.proposals.startMm = this->StartMm->value();
  settings.assembly.proposals.startDegrees = this->StartDegrees->value();
  for (const PlanFragment& fragment : work->snapshot.plan.fragments)
    if (const auto* source = std::get_if<SurfaceSource>(&fragment.source))
      if (const auto* surface = FindPlanObject<PlanSurface>(work->snapshot.plan, source->surface))
        if (SurfaceShelf::Mesh mesh = SurfaceShelf::Of(this->Of).Find(surface->hash))
          work->surfaces[fragment.id] = std::move(mesh);
  this->Of.jobs.Add(tr("Finding how fragments fit"),
    [me = QPointer<ReducePanel>(this), work](const ProgressFunction& progress) -> JobQueue::Finish
    {
      auto made = std::make_shared<const ReductionResult>(hasp::Reduce(*work, progress));
      return [me, made]
      {
        if (!me)
          return;
        for (const DerivedPart& map : made->labelMaps)
          me->Of.plan.KeepMade(map);
        me->Proposals->Show(made);
      };
    });
}

void ReducePanel::AddMirror()
{
  const PlanId volume = this->Of.scene.ShownVolume();
  for (const PlanMirror& mirror : this->Of.plan.Now().mirrors)
    if (mirror.volume == volume && mirror.isovalue == this->Of.scene.Isovalue())
    {
      this->Of.Say(tr("The plan has it: mirror %1. It is in the list of objects.").arg(mirror.id));
      return;
    }
  PlanMirror mirror;
  mirror.id = this->Of.plan.NewId();
  mirror.name = ObjectNames::Of<PlanMirror>(mirror.id);
  mirror.volume = volume;
  mirror.isovalue = this->Of.scene.Isovalue();
  this->Of.plan.Do(AddObject<PlanMirror>{ std::move(mirror) });
}

} // namespace hasp
