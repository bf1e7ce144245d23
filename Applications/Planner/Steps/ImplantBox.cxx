#include "Steps/ImplantBox.h"

#include "Planning/PlanLists.h"
#include "Steps/PointsEdit.h"

#include <QComboBox>
#include <QPushButton>

namespace hasp
{

ImplantBox::ImplantBox(Planner& planner, QWidget* parent)
  : ObjectBox(planner, "implant", tr("&New"), tr("implant"), parent),
    Form(this->Add(new RecipeForm("implant"))),
    Outline(new PointsEdit(planner, "implant.outline", tr("&Touch the outline"),
      { tr("Touch the outer bone all around the hole, in order, some millimetres from its rim."),
        200, true, LandmarkPurpose::Line::Closed })),
    Volume(new QComboBox),
    Mirror(new QComboBox)
{
  this->Column->addWidget(this->Outline);
  this->Form->Text(
    "name", tr("Name"), [this]() -> std::string& { return this->Draft.Typed().name; });
  this->Volume->setObjectName("implant.volume");
  this->Mirror->setObjectName("implant.mirror");
  for (QComboBox* box : { this->Volume, this->Mirror })
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Form->Row(tr("In the scan"), this->Volume);
  this->AddNumbers();
  this->AddDirections();
  this->Column->addWidget(this->Form);
  this->Column->addStretch(1);
  connect(this->Form, &RecipeForm::Edited, this, [this] { this->Put(); });
  connect(this->Outline, &PointsEdit::Edited, this, &ImplantBox::TakeOutline);
  connect(this->Volume, qOverload<int>(&QComboBox::activated), this,
    [this]
    {
      this->Draft.Typed().volume = this->Volume->currentData().toUInt();
      this->Put();
    });
  connect(this->Mirror, qOverload<int>(&QComboBox::activated), this,
    [this]
    {
      const auto* mirror =
        FindPlanObject<PlanMirror>(this->Of.plan.Now(), this->Mirror->currentData().toUInt());
      this->Recipe().mirror = mirror ? mirror->plane : std::nullopt;
      this->Put();
    });
  this->Fill();
}

void ImplantBox::AddNumbers()
{
  const auto number = [this](const char* name, const char* key, const QString& label,
                        const FormNumber& range, double ImplantRecipe::*member)
  {
    this->Form->Number(
      name, key, label, range, [this, member]() -> double& { return this->Recipe().*member; });
  };
  number("clearance", "clearanceMm", tr("Clearance to the edge"), Millimetres(0, 5, 0.05),
    &ImplantRecipe::clearanceMm);
  number("thickness", "thicknessMm", tr("Thickness"), Millimetres(0.1, 20, 0.5),
    &ImplantRecipe::thicknessMm);
  number("holes", "holeDiameterMm", tr("Holes, 0: none"), Millimetres(0, 20),
    &ImplantRecipe::holeDiameterMm);
  number("pitch", "holePitchMm", tr("Holes apart"), Millimetres(1, 100, 0.5),
    &ImplantRecipe::holePitchMm);
  number("edge", "holeEdgeMm", tr("Holes to the edge"), Millimetres(0.5, 50, 0.5),
    &ImplantRecipe::holeEdgeMm);
  number("spacing", "spacingMm", tr("Working grid"), Millimetres(0.1, 2, 0.05),
    &ImplantRecipe::spacingMm);
  number("isovalue", "isovalue", tr("Bone from"), FormNumber{ -1e6, 1e6, {}, 1, 10 },
    &ImplantRecipe::isovalue);
  number("ignore", "ignoreBelowMm3", tr("Ignore pieces below"),
    FormNumber{ 0, 1e6, QStringLiteral(" mm³"), 0, 10 }, &ImplantRecipe::ignoreBelowMm3);
}

void ImplantBox::AddDirections()
{
  this->Form->Direction(
    "axis", "axis", tr("Put in against"),
    { { "view", tr("Towards me"), [this] { return -ViewDirection(this->Of); } } },
    [this] { return this->Recipe().axis.value_or(glm::dvec3(0.0)); },
    [this](const glm::dvec3& axis) { this->Recipe().axis = axis; });
  auto* upright = new QPushButton(tr("Upright on the outline"));
  upright->setObjectName("implant.axis.upright");
  connect(upright, &QPushButton::clicked, this,
    [this]
    {
      this->Recipe().axis.reset();
      this->Put();
    });
  this->Form->Row(upright);
  this->Form->Row(tr("Mirrored at"), this->Mirror);
}

PlanImplant ImplantBox::Fresh()
{
  PlanImplant implant;
  implant.volume = this->Of.scene.ShownVolume();
  implant.recipe.isovalue = this->Of.scene.Isovalue();
  return implant;
}

void ImplantBox::Begun()
{
  this->Outline->Take();
}

void ImplantBox::TakeOutline()
{
  if (!this->Draft.IsShown())
    this->Draft.Begin(this->Fresh());
  this->Recipe().outline = this->Outline->Points();
  this->Put();
}

void ImplantBox::Fill()
{
  this->Outline->SetPoints(this->Draft.Typed().recipe.outline, 0);
  this->FillChoices();
  this->FillForms();
}

void ImplantBox::FillChoices()
{
  const Plan& plan = this->Of.plan.Now();
  const PlanImplant& implant = this->Draft.Typed();
  this->Volume->clear();
  for (const PlanVolume& volume : plan.volumes)
    this->Volume->addItem(CalledWithName(plan, volume.id), volume.id);
  this->Volume->setCurrentIndex(this->Volume->findData(implant.volume));
  this->Mirror->clear();
  this->Mirror->addItem(tr("the plane found in the scan"), 0U);
  int row = implant.recipe.mirror ? -1 : 0; // -1: a plane of its own
  for (const PlanMirror& mirror : plan.mirrors)
    if (mirror.plane)
    {
      if (implant.recipe.mirror == mirror.plane)
        row = this->Mirror->count();
      this->Mirror->addItem(CalledWithName(plan, mirror.id), mirror.id);
    }
  this->Mirror->setCurrentIndex(row);
}

} // namespace hasp
