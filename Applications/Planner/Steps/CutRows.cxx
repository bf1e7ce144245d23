// The pages of the panel of cuts.
#include "Steps/BladeNudge.h"
#include "Steps/CutPanel.h"
#include "Steps/FaultLine.h"
#include "Steps/ObjectChecks.h"
#include "Steps/PanelGroup.h"
#include "Steps/PointsEdit.h"
#include "Steps/RecipeForm.h"
#include "Steps/TouchButton.h"

#include <QDoubleSpinBox>
#include <QPushButton>

namespace hasp
{

QWidget* CutPanel::PlacePage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  auto* bone = new TouchButton(this->Of, "cut.bone", tr("&Bone from here"),
    tr("Touch bone: all that is connected with it becomes a fragment, which can be cut."));
  connect(bone, &TouchButton::Touched, this, &CutPanel::AddBone);
  column->addWidget(bone);
  this->Places = new PointsEdit(this->Of, "cut.place", tr("&Touch the cut"),
    { tr("Touch two places: the blade goes through them as you look. A third one turns it into the "
         "plane through all three."),
      3, true, LandmarkPurpose::Line::Open });
  column->addWidget(this->Places);
  this->Drag = new QPushButton(tr("&Drag its handles"));
  this->Drag->setObjectName("cut.drag");
  this->Drag->setCheckable(true);
  column->addWidget(this->Drag);
  this->Fragments =
    new ObjectChecks("cut.fragment", tr("No fragment yet: touch bone, and it becomes one."));
  AddGroup(column, tr("It cuts"), this->Fragments);
  column->addStretch(1);
  connect(this->Places, &PointsEdit::Edited, this, &CutPanel::Touched);
  connect(this->Drag, &QPushButton::clicked, this,
    [this](bool on) { this->Of.tools.Take(on ? &this->Blade : nullptr); });
  return page;
}

QWidget* CutPanel::BladePage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  this->Form = new RecipeForm("cut");
  this->Form->Text(
    "name", tr("Name"), [this]() -> std::string& { return this->Draft.Typed().name; });
  const auto number = [this](const char* name, const char* key, const QString& label,
                        const FormNumber& range, double Osteotomy::*member)
  {
    this->Form->Number(name, key, label, range,
      [this, member]() -> double& { return this->Draft.Typed().blade.*member; });
  };
  number("kerf", "kerfMm", tr("Kerf"), Millimetres(0.2, 5.0, 0.05), &Osteotomy::kerfMm);
  number("width", "widthMm", tr("Width"), Millimetres(0.1, 500.0, 1.0), &Osteotomy::widthMm);
  number("depth", "depthMm", tr("Depth"), Millimetres(0.1, 500.0, 1.0), &Osteotomy::depthMm);
  this->Form
    ->Number("reach", "reachMm", tr("Reach"), Millimetres(0.0, 500.0, 1.0),
      [this]() -> double& { return this->Draft.Typed().reachMm; })
    ->setToolTip(tr("Bone of the fragment that is farther from what it cuts stays whole"));
  column->addWidget(this->Form);
  this->Nudge = new BladeNudge;
  this->Nudge->blade = [this] { return this->Draft.Typed().blade; };
  AddGroup(column, tr("Move it by numbers"), this->Nudge);
  column->addStretch(1);
  this->Fault->Know(this->Form);
  connect(this->Form, &RecipeForm::Edited, this, &CutPanel::Put);
  return page;
}

} // namespace hasp
