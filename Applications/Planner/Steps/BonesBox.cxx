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
  this->Least = AddSpinBox(row, "split.pieces.least", {}, { 0.0, 99999.0, 500.0, tr(" mm³"), 0 });
  this->Least->setAccessibleName(tr("Least volume of a piece"));
  layout->addLayout(row);
  connect(this->Picking, &QPushButton::clicked, this,
    [this](bool on) { this->Of.tools.Take(on ? &this->Pick : nullptr); });
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

void BonesBox::Refresh()
{
  const bool has = this->Of.scene.ShownImage() != nullptr;
  this->Picking->setChecked(this->Of.tools.InHand() == &this->Pick);
  for (QPushButton* button : { this->Picking, this->AtCrosshair, this->Pieces })
    button->setEnabled(has);
  this->ShowToPick();
}

/// A scan whose fragments are there is hidden by the scene: it is shown to be picked from. Hidden
/// again after that, it is seen once it has no fragments any more.
void BonesBox::ShowToPick()
{
  const Plan& plan = this->Of.plan.Now();
  const PlanId volume = this->Of.scene.ShownVolume();
  const bool picks = this->Of.tools.InHand() == &this->Pick,
             hasFragments = std::any_of(plan.fragments.begin(), plan.fragments.end(),
               [&](const PlanFragment&one) { return VolumeOfFragment(plan, one.id) == volume; });
  if (picks && volume != 0 && !this->Of.scene.IsVisible(volume))
  {
    this->ShownToPick = volume;
    this->Of.scene.SetVisible(volume, true);
  }
  else if (!picks && volume != 0 && std::exchange(this->ShownToPick, 0) == volume)
  {
    this->HiddenAfterPick = volume;
    this->Of.scene.SetVisible(volume, false);
  }
  else if (!hasFragments && volume != 0 && this->HiddenAfterPick == volume)
  {
    this->HiddenAfterPick = 0;
    this->Of.scene.SetVisible(volume, true);
  }
}

} // namespace hasp
