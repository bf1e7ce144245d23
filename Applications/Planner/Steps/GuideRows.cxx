// The rows of a guide's form.
#include "Planning/GuideSlots.h"
#include "Planning/PlanLists.h"
#include "Steps/GuideBox.h"
#include "Steps/ObjectChecks.h"
#include "Steps/PointsEdit.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace hasp
{

RecipeForm::Value<double> GuideBox::Member(double GuideRecipe::*member)
{
  return [this, member]() -> double& { return this->Recipe().*member; };
}

QWidget* GuideBox::AreaPage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->addWidget(this->Landmarks);
  this->Area = this->Add(new RecipeForm("guide"));
  this->Area->Text(
    "name", tr("Name"), [this]() -> std::string& { return this->Draft.Typed().name; });
  this->Bone = new QComboBox;
  this->Bone->setObjectName("guide.bone");
  this->Bone->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Area->Row(tr("On the bone"), this->Bone);
  this->Area->Choice(
    "outline", tr("Outline"), { tr("Band"), tr("Ring"), tr("Filled ring") },
    [this] { return int(this->Recipe().outline); },
    [this](int row) { this->Recipe().outline = GuideOutline(row); });
  this->Area->Number("width", "widthMm", tr("Width"), Millimetres(0.1, 200.0, 1.0),
    this->Member(&GuideRecipe::widthMm));
  this->Area->Direction(
    "withdrawal", "withdrawal", tr("Lifts off along"),
    { { "mean", tr("Mean normal"), [this] { return this->MeanNormal(); } },
      { "view", tr("As I look"), [this] { return this->InScan(-ViewDirection(this->Of)); } } },
    [this] { return this->Recipe().withdrawal; },
    [this](const glm::dvec3& direction) { this->SetWithdrawal(direction); });
  this->Area->Number("search", "axisSearchDeg", tr("Search near it"), Degrees(0.0, 60.0),
    this->Member(&GuideRecipe::axisSearchDeg));
  column->addWidget(this->Area);
  column->addStretch(1);
  return page;
}

QWidget* GuideBox::ShapePage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  this->Shape = this->Add(new RecipeForm("guide"));
  const auto number = [this](const char* name, const char* key, const QString& label,
                        const FormNumber& range, double GuideRecipe::*member)
  { this->Shape->Number(name, key, label, range, this->Member(member)); };
  number("gap", "gapMm", tr("Gap to the bone"), Millimetres(0.0, 10.0, 0.05), &GuideRecipe::gapMm);
  number("thickness", "thicknessMm", tr("Thickness"), Millimetres(0.1, 50.0, 0.5),
    &GuideRecipe::thicknessMm);
  number(
    "edge", "edgeRadiusMm", tr("Round edges"), Millimetres(0.0, 5.0), &GuideRecipe::edgeRadiusMm);
  number("clearance", "clearanceMm", tr("Slots wider by"), Millimetres(0.0, 2.0, 0.05),
    &GuideRecipe::clearanceMm);
  auto* presets = new QWidget;
  auto* row = new QHBoxLayout(presets);
  row->setContentsMargins(0, 0, 0, 0);
  const auto preset = [&](const char* name, const QString& text, double clearanceMm)
  {
    auto* button = new QPushButton(text);
    button->setObjectName(name);
    connect(button, &QPushButton::clicked, this,
      [this, clearanceMm]
      {
        this->Recipe().clearanceMm = clearanceMm;
        this->Put();
      });
    row->addWidget(button);
  };
  preset("guide.clearance.sla", tr("For resin"), SlaClearanceMm);
  preset("guide.clearance.fdm", tr("For filament"), FdmClearanceMm);
  this->Shape->Row(presets);
  number("wall", "wallMm", tr("Walls of slots"), Millimetres(0.1, 20.0), &GuideRecipe::wallMm);
  number("sleeve", "sleeveWallMm", tr("Walls of sleeves"), Millimetres(0.1, 20.0),
    &GuideRecipe::sleeveWallMm);
  number("spacing", "spacingMm", tr("Working grid"), Millimetres(0.05, 2.0, 0.05),
    &GuideRecipe::spacingMm);
  number("isovalue", "isovalue", tr("Bone from"), FormNumber{ -1e6, 1e6, {}, 1, 10.0 },
    &GuideRecipe::isovalue);
  number("ignore", "ignoreBelowMm3", tr("Ignore pieces below"),
    FormNumber{ 0.0, 1e6, QStringLiteral(" mm³"), 0, 10.0 }, &GuideRecipe::ignoreBelowMm3);
  column->addWidget(this->Shape);
  column->addStretch(1);
  return page;
}

QWidget* GuideBox::CutsPage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  auto* text = new QLabel(tr("The guide gets a slot for each of these cuts, and follows them:"));
  text->setWordWrap(true);
  column->addWidget(text);
  column->addWidget(this->Cuts);
  column->addStretch(1);
  return page;
}

QWidget* GuideBox::PinsPage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->addWidget(this->Pins);
  this->AddPinRows();
  column->addWidget(this->PinForm);
  column->addWidget(this->LabelPlace);
  this->AddLabelRows();
  column->addWidget(this->LabelForm);
  column->addStretch(1);
  return page;
}

void GuideBox::AddPinRows()
{
  this->PinForm = this->Add(new RecipeForm("guide.pin"));
  this->PinForm->setToolTip(tr("Of the chosen pin; of all of them where none is chosen"));
  const auto number = [this](const char* name, const char* key, const QString& label,
                        const FormNumber& range, double GuideHole::*member)
  {
    this->PinForm->Number(
      name, key, label, range, [this, member]() -> double& { return this->Pin().*member; });
  };
  number("diameter", "diameterMm", tr("Pin, as printed"), Millimetres(0.1, 20.0),
    &GuideHole::diameterMm);
  number(
    "depth", "depthMm", tr("Drilled into bone"), Millimetres(0.1, 500.0, 1.0), &GuideHole::depthMm);
  number("height", "sleeveHeightMm", tr("Sleeve above bone"), Millimetres(0.0, 100.0, 0.5),
    &GuideHole::sleeveHeightMm);
}

void GuideBox::AddLabelRows()
{
  this->LabelForm = this->Add(new RecipeForm("guide"));
  this->LabelForm->Choice(
    "side", tr("Side"), { tr("none"), tr("left"), tr("right") },
    [this] { return int(this->Draft.Typed().side); },
    [this](int row) { this->Draft.Typed().side = BodySide(row); });
  this->LabelForm->Number("label.height", "heightMm", tr("Letters"), Millimetres(3.6, 50.0, 0.5),
    [this]() -> double& { return this->Label().heightMm; });
  this->LabelForm->Number("label.depth", "depthMm", tr("Letters' depth"), Millimetres(0.1, 5.0),
    [this]() -> double& { return this->Label().depthMm; });
  this->LabelForm->Check(
    "label.engraved", tr("Cut in"), [this] { return this->Label().engraved; },
    [this](bool on) { this->Label().engraved = on; });
  this->LabelForm->Direction(
    "label.right", "right", tr("Written towards"),
    { { "view", tr("My right"), [this] { return this->InScan(ViewRight(this->Of)); } } },
    [this] { return this->Label().right; },
    [this](const glm::dvec3& direction) { this->Label().right = direction; });
}

/// Its cuts' slots must be ones that its recipe can show.
QString GuideBox::WhyNotMade()
{
  const Plan& plan = this->Of.plan.Now();
  for (const PlanId id : this->Draft.Typed().cuts)
    try
    {
      const std::string called = CalledObject(plan, id);
      GuideRecipe recipe = this->Recipe();
      const auto* cut = FindPlanObject<PlanCut>(plan, id);
      if (!cut)
        continue;
      recipe.slots = { SlotOfBlade(cut->blade, recipe.withdrawal, called) };
      ValidateGuideRecipe(recipe);
    }
    catch (const std::invalid_argument& error)
    {
      return QString::fromStdString(error.what())
        .replace(QStringLiteral("slots[0]"), QString::fromStdString(CalledObject(plan, id)));
    }
  return {};
}

} // namespace hasp
