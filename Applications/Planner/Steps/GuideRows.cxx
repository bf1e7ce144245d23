// The rows of a guide's form.
#include "Planning/GuideSlots.h"
#include "Planning/PlanLists.h"
#include "Steps/GuideBox.h"
#include "Steps/ObjectChecks.h"
#include "Steps/PaintedArea.h"
#include "Steps/PanelGroup.h"
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
  AddGroup(column, tr("And what is painted"), this->Paint);
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
