// What the panel of cuts does; its pages are in CutRows.cxx.
#include "Steps/CutPanel.h"

#include "Planning/BladePlacing.h"
#include "Steps/BladeNudge.h"
#include "Steps/FaultLine.h"
#include "Steps/ObjectChecks.h"
#include "Steps/ObjectChooser.h"
#include "Steps/PiecesBox.h"
#include "Steps/PointsEdit.h"
#include "Steps/RecipeForm.h"
#include "Steps/TouchedFragment.h"

#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

namespace hasp
{

CutPanel::CutPanel(Planner& planner, QWidget* parent)
  : StepPanel(planner, parent),
    Draft(planner),
    Blade(planner)
{
  auto* column = new QVBoxLayout(this);
  this->List = new ObjectChooser(
    planner, "cut", tr("&New"), [](const Plan& plan) { return IdsOf(plan.cuts); });
  column->addWidget(this->List);
  this->Fault = new FaultLine("cut");
  column->addWidget(this->Fault);
  this->Pages = new QTabWidget;
  this->Pages->setObjectName("cut.pages");
  this->Pages->addTab(this->PlacePage(), tr("Place"));
  this->Pages->addTab(this->BladePage(), tr("Blade"));
  this->Pages->addTab(this->Pieces = new PiecesBox(planner), tr("Pieces"));
  column->addWidget(this->Pages);
  column->addStretch(1);

  connect(this->List, &ObjectChooser::ChosenChanged, this, &CutPanel::ChooseCut);
  connect(this->List, &ObjectChooser::NewAsked, this,
    [this]
    {
      this->List->Choose(0);
      this->ChooseCut(0);
      this->Pages->setCurrentIndex(0);
      this->Places->Take();
    });
  connect(this->Nudge, &BladeNudge::Nudged, this,
    [this](const Osteotomy& blade)
    {
      this->Draft.Typed().blade = blade;
      this->Put();
    });
  connect(this->Fragments, &ObjectChecks::Edited, this,
    [this]
    {
      this->Draft.Typed().fragments = this->Fragments->Ticked();
      this->Put();
    });
  connect(&planner.plan, &PlanSession::Replaced, this,
    [this]
    {
      this->List->Choose(0);
      this->ChooseCut(0);
    });
  connect(&planner.plan, &PlanSession::Changed, this, &CutPanel::Follow);
  connect(&planner.tools, &ToolBox::Changed, this,
    [this] { this->Drag->setChecked(this->Of.tools.InHand() == &this->Blade); });
  this->Fill();
}

CutPanel::~CutPanel()
{
  this->Of.tools.Take(nullptr); // while all that follows it is there
}

QString CutPanel::StillNeeds() const
{
  const Plan& plan = this->Of.plan.Now();
  if (plan.volumes.empty())
    return tr("Import a scan first.");
  if (!this->Of.scans.Missing(plan).empty() && !this->Of.scene.ShownImage())
    return tr("Find the plan's scan first: it is not in memory.");
  return {};
}

void CutPanel::Enter()
{
  if (this->List->Chosen() != 0)
    this->Of.tools.Take(&this->Blade);
}

void CutPanel::Leave()
{
  this->Of.tools.Take(nullptr);
}

void CutPanel::AddBone(const TouchedPlace& place)
{
  const PlanFragment bone = FragmentFromTouch(this->Of, place);
  if (this->Of.plan.Do(AddObject<PlanFragment>{ bone }))
    this->Of.scene.Select(bone.id);
}

void CutPanel::ChooseCut(PlanId cut)
{
  if (cut == 0 || cut != this->Draft.Id()) // 0: also one that was begun and is not in the plan
  {
    this->Draft.Show(cut);
    this->ForgetPlaces();
  }
  this->Fault->Say({});
  this->Fill();
  const bool placing = this->Of.tools.InHand() == &this->Places->Tool();
  if (cut != 0 && !placing && this->isVisible())
    this->Of.tools.Take(&this->Blade);
}

void CutPanel::ForgetPlaces()
{
  this->Places->SetPlaces({});
  this->Counted = 0;
}

void CutPanel::Touched()
{
  const std::size_t count = this->Places->Places().size();
  if (count == 2 && this->Counted < 2)
    this->Seen = ViewDirection(this->Of);
  const bool third = count == 3 && this->Counted == 2;
  this->Counted = count;
  if (count < 2)
    return;
  this->PlaceBlade();
  if (third && this->Of.tools.InHand() == &this->Places->Tool())
    this->Of.tools.Take(&this->Blade);
}

void CutPanel::PlaceBlade()
{
  const Plan& plan = this->Of.plan.Now();
  const std::vector<TouchedPlace>& places = this->Places->Places();
  TouchedPlace looked = places[0]; // cuts lie in the scan
  looked.normal = this->Seen;
  if (!this->Draft.IsShown())
    this->Draft.Begin({});
  PlanCut& cut = this->Draft.Typed();
  if (this->Draft.IsNew())
    cut.fragments = FragmentsOf(plan, places);
  try
  {
    cut.blade = BladeThrough(this->Places->Points(), NormalInScan(plan, looked), cut.blade);
  }
  catch (const std::invalid_argument& error)
  {
    this->Fault->Say(QString::fromStdString(error.what()));
    return;
  }
  std::vector<PlanEdit> before;
  if (this->Draft.IsNew() && cut.fragments.empty() && places[0].object != 0)
    return this->Fault->Say(tr("That is a surface: only bone of scans can be cut."));
  if (this->Draft.IsNew() && cut.fragments.empty())
  {
    const PlanFragment bone = FragmentFromTouch(this->Of, places[0]);
    cut.fragments = { bone.id };
    before = { AddObject<PlanFragment>{ bone } };
  }
  this->Fault->Say({});
  const bool fresh = this->Draft.IsNew();
  if (!this->Draft.Put(fresh ? tr("Add a cut") : tr("Place cut %1").arg(cut.id), before))
    return;
  this->List->Choose(this->Draft.Id());
}

void CutPanel::Put()
{
  if (!this->Draft.IsShown())
    return;
  const QString fault = this->Draft.Fault();
  this->Fault->Say(fault);
  if (fault.isEmpty())
    this->Draft.Put(tr("Change cut %1").arg(this->Draft.Id()));
}

void CutPanel::Follow()
{
  if (this->Draft.Follow())
  {
    this->Fault->Say({});
    this->ForgetPlaces(); // the blade is no longer the one through them
  }
  this->Fill();
}

void CutPanel::Fill()
{
  const Plan& plan = this->Of.plan.Now();
  const bool shown = this->Draft.Id() != 0;
  this->Blade.SetCut(this->Draft.Id());
  this->Form->Refresh();
  this->Form->setEnabled(shown);
  this->Nudge->setEnabled(shown);
  this->Drag->setEnabled(shown);
  this->Fragments->Show(plan, FragmentsOfScans(plan), this->Draft.Typed().fragments);
  this->Fragments->setEnabled(shown);
  this->Pieces->Show(this->Draft.Id());
}

} // namespace hasp
