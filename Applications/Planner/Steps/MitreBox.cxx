#include "Steps/MitreBox.h"

#include <QComboBox>

namespace hasp
{

MitreBox::MitreBox(Planner& planner, QWidget* parent)
  : ObjectBox(planner, "mitre", tr("&New"), tr("mitre guide"), parent),
    Form(this->Add(new RecipeForm("mitre"))),
    Transplant(new QComboBox)
{
  this->Form->Text(
    "name", tr("Name"), [this]() -> std::string& { return this->Draft.Typed().name; });
  this->Transplant->setObjectName("mitre.transplant");
  this->Transplant->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Form->Row(tr("For"), this->Transplant);
  this->AddNumbers();
  this->Column->addWidget(this->Form);
  this->Column->addStretch(1);
  connect(this->Form, &RecipeForm::Edited, this, [this] { this->Put(); });
  connect(this->Transplant, qOverload<int>(&QComboBox::activated), this,
    [this]
    {
      this->Draft.Typed().transplant = this->Transplant->currentData().toUInt();
      this->Put();
    });
  this->Fill();
}

void MitreBox::AddNumbers()
{
  const auto number = [this](const char* name, const char* key, const QString& label,
                        const FormNumber& range, double MitreGuideChoices::*member)
  {
    this->Form->Number(name, key, label, range,
      [this, member]() -> double& { return this->Draft.Typed().choices.*member; });
  };
  using Choices = MitreGuideChoices;
  number("gap", "gapMm", tr("Gap to the bone"), Millimetres(0, 10, 0.05), &Choices::gapMm);
  number(
    "thickness", "thicknessMm", tr("Thickness"), Millimetres(0.1, 50, 0.5), &Choices::thicknessMm);
  number("width", "widthMm", tr("Width"), Millimetres(0.1, 200, 1), &Choices::widthMm);
  number("clearance", "clearanceMm", tr("Slots wider by"), Millimetres(0, 2, 0.05),
    &Choices::clearanceMm);
  number("wall", "wallMm", tr("Walls of slots"), Millimetres(0.1, 20), &Choices::wallMm);
  number(
    "slot", "slotLengthMm", tr("Slots across"), Millimetres(0.1, 500, 1), &Choices::slotLengthMm);
  number("height", "guidingHeightMm", tr("Slots above bone"), Millimetres(0.1, 100, 1),
    &Choices::guidingHeightMm);
  number("beyond", "beyondMm", tr("Beyond the cuts"), Millimetres(5, 100, 1), &Choices::beyondMm);
  number("pin", "pinDiameterMm", tr("Pins, 0: none"), Millimetres(0, 20), &Choices::pinDiameterMm);
  number(
    "spacing", "spacingMm", tr("Working grid"), Millimetres(0.05, 2, 0.05), &Choices::spacingMm);
}

PlanMitreGuide MitreBox::Fresh()
{
  const Plan& plan = this->Of.plan.Now();
  PlanMitreGuide guide;
  guide.transplant = plan.transplants.empty() ? 0 : plan.transplants.back().id;
  return guide;
}

void MitreBox::Begun()
{
  if (this->Draft.Typed().transplant == 0)
    return this->ShowFault(tr("Plan a transplant first."));
  this->Put();
}

void MitreBox::Fill()
{
  const Plan& plan = this->Of.plan.Now();
  this->Transplant->clear();
  for (const PlanTransplant& transplant : plan.transplants)
    this->Transplant->addItem(CalledWithName(plan, transplant.id), transplant.id);
  this->Transplant->setCurrentIndex(this->Transplant->findData(this->Draft.Typed().transplant));
  this->FillForms();
}

} // namespace hasp
