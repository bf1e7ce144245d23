#include "Steps/BonesBox.h"

#include "PlanFragmentLabels.h"
#include "Steps/FragmentMaking.h"
#include "Steps/PanelWidgets.h"

#include <QDoubleSpinBox>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace hasp
{

BonesBox::BonesBox(Planner& planner, QWidget* parent)
  : QGroupBox(tr("Whole pieces of bone"), parent),
    Of(planner),
    Pick(planner, tr("Click on the bone that shall be a fragment. Esc: back"))
{
  auto* layout = new QVBoxLayout(this);
  this->Picking = AddButton(layout, "split.bone.pick", tr("Bone from here: &click on it"));
  this->Picking->setCheckable(true);
  this->AtCrosshair = AddButton(layout, "split.bone.crosshair", tr("&Whole bone at the crosshair"));
  auto* row = new QHBoxLayout;
  this->Pieces = AddButton(row, "split.pieces", tr("All pieces of at leas&t"));
  this->Least = AddSpinBox(row, "split.pieces.least", {}, { 0.0, 1e6, 500.0, tr(" mm³") });
  this->Least->setAccessibleName(tr("Least volume of a piece"));
  layout->addLayout(row);
  connect(this->Picking, &QPushButton::clicked, this, &BonesBox::BeginPick);
  connect(&this->Pick, &PickTool::Picked, this,
    [this](const PlanScene::Place& place) { AddBoneAt(this->Of, place.inScan); });
  connect(this->AtCrosshair, &QPushButton::clicked, this,
    [this] { AddBoneAt(this->Of, this->Of.views.Crosshair()); });
  connect(this->Pieces, &QPushButton::clicked, this,
    [this] { MakePieces(this->Of, this->Least->value()); });
  connect(&planner.tools, &ToolBox::Changed, this, &BonesBox::Refresh);
  connect(&planner.plan, &PlanSession::Changed, this, &BonesBox::Refresh);
  connect(&planner.scene, &PlanScene::PropsChanged, this, &BonesBox::Refresh);
  this->Refresh();
}

void BonesBox::PutAway()
{
  if (this->Of.tools.InHand() == &this->Pick)
    this->Of.tools.Take(nullptr);
}

void BonesBox::BeginPick(bool on)
{
  const PlanId volume = this->Of.scene.ShownVolume();
  const bool hidden = on && !this->Of.scene.IsVisible(volume); // its fragments are there
  if (hidden)
    this->Of.scene.SetVisible(volume, true);
  this->Of.tools.Take(on ? &this->Pick : nullptr);
  this->ShownToPick = hidden ? volume : 0;
}

void BonesBox::Refresh()
{
  const bool has = this->Of.scene.ShownImage() != nullptr;
  this->Picking->setChecked(this->Of.tools.InHand() == &this->Pick);
  for (QPushButton* button : { this->Picking, this->AtCrosshair, this->Pieces })
    button->setEnabled(has);
  this->HideAfterPick();
}

/// A scan that was only shown to be picked from; and once it has no fragments any more it is seen.
void BonesBox::HideAfterPick()
{
  const Plan& plan = this->Of.plan.Now();
  const PlanId volume = this->Of.scene.ShownVolume();
  if (this->Of.tools.InHand() != &this->Pick)
    if (const PlanId shown = std::exchange(this->ShownToPick, 0); shown == volume && shown != 0)
    {
      this->HiddenAfterPick = shown;
      this->Of.scene.SetVisible(shown, false);
    }
  const bool hasFragments = std::any_of(plan.fragments.begin(), plan.fragments.end(),
    [&](const PlanFragment& one) { return VolumeOfFragment(plan, one.id) == volume; });
  if (!hasFragments && volume != 0 && this->HiddenAfterPick == volume)
  {
    this->HiddenAfterPick = 0;
    this->Of.scene.SetVisible(volume, true);
  }
}

} // namespace hasp
