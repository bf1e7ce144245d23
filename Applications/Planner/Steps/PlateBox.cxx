#include "Steps/PlateBox.h"

#include "PlanFragmentLabels.h"
#include "Steps/MatchPoints.h"
#include "Steps/ObjectChecks.h"
#include "Steps/PointsEdit.h"
#include "Steps/TouchedFragment.h"

#include <QComboBox>
#include <QPushButton>
#include <QTabWidget>

#include <algorithm>

namespace hasp
{

PlateBox::PlateBox(Planner& planner, QWidget* parent)
  : ObjectBox(planner, "plate", tr("&New"), tr("plate"), parent),
    Bone(new QComboBox),
    Fragments(new ObjectChecks("plate.fragment", tr("The plan has no fragments."))),
    Landmarks(new PointsEdit(planner, "plate.landmarks", tr("&Touch bone"),
      { tr("Touch bone along the middle of the plate, in order."), 200, true,
        LandmarkPurpose::Line::Open },
      PointsEdit::Space::Planned)),
    Screws(new PointsEdit(planner, "plate.screws", tr("Touch &screws"),
      { tr("Touch bone where screws go through the plate."), 100, true, LandmarkPurpose::Line::None,
        QColor(120, 200, 255) },
      PointsEdit::Space::Planned))
{
  this->Pages = new QTabWidget;
  this->Pages->setObjectName("plate.pages");
  this->Pages->addTab(this->LinePage(), tr("Line"));
  this->Pages->addTab(this->ShapePage(), tr("Shape"));
  this->Pages->addTab(this->ScrewPage(), tr("Screws"));
  this->Column->addWidget(this->Pages);
  connect(this->Form, &RecipeForm::Edited, this, [this] { this->Put(); });
  connect(this->ScrewForm, &RecipeForm::Edited, this, &PlateBox::TakeScrewNumbers);
  connect(this->Landmarks, &PointsEdit::Edited, this, &PlateBox::TakeLandmarks);
  connect(this->Screws, &PointsEdit::Edited, this, &PlateBox::TakeScrews);
  connect(
    &this->Screws->Tool(), &LandmarkTool::SelectedChanged, this->ScrewForm, &RecipeForm::Refresh);
  connect(this->Bone, qOverload<int>(&QComboBox::activated), this, &PlateBox::TakeBone);
  connect(this->Fragments, &ObjectChecks::Edited, this, &PlateBox::TakeBone);
  this->Fill();
}

QWidget* PlateBox::LinePage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->addWidget(this->Landmarks);
  auto* rows = new RecipeForm("plate");
  this->Bone->setObjectName("plate.bone");
  this->Bone->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  rows->Row(tr("On"), this->Bone);
  rows->Row(this->Fragments);
  column->addWidget(rows);
  column->addStretch(1);
  return page;
}

QWidget* PlateBox::ShapePage()
{
  this->Form = this->Add(new RecipeForm("plate"));
  this->Form->Text(
    "name", tr("Name"), [this]() -> std::string& { return this->Draft.Typed().name; });
  const auto number = [this](const char* name, const char* key, const QString& label,
                        const FormNumber& range, double PlateRecipe::*member)
  {
    this->Form->Number(
      name, key, label, range, [this, member]() -> double& { return this->Recipe().*member; });
  };
  number("gap", "gapMm", tr("Gap to the bone"), Millimetres(0, 5, 0.05), &PlateRecipe::gapMm);
  number(
    "thickness", "thicknessMm", tr("Thickness"), Millimetres(0.1, 20), &PlateRecipe::thicknessMm);
  number("width", "widthMm", tr("Width"), Millimetres(0.1, 100, 0.5), &PlateRecipe::widthMm);
  number("bevel", "bevelMm", tr("Bevel"), Millimetres(0, 16, 0.05), &PlateRecipe::bevelMm);
  number("bridge", "bridgeMm", tr("Bridge clefts to"), Millimetres(0, 10), &PlateRecipe::bridgeMm);
  number(
    "edge", "edgeDistanceMm", tr("Hole to edge"), Millimetres(0, 20), &PlateRecipe::edgeDistanceMm);
  number(
    "hole", "holeDistanceMm", tr("Hole to hole"), Millimetres(0, 20), &PlateRecipe::holeDistanceMm);
  number("spacing", "spacingMm", tr("Working grid"), Millimetres(0.05, 2, 0.05),
    &PlateRecipe::spacingMm);
  number("isovalue", "isovalue", tr("Bone from"), FormNumber{ -1e6, 1e6, {}, 1, 10 },
    &PlateRecipe::isovalue);
  number("ignore", "ignoreBelowMm3", tr("Ignore pieces below"),
    FormNumber{ 0, 1e6, QStringLiteral(" mm³"), 0, 10 }, &PlateRecipe::ignoreBelowMm3);
  return this->Form;
}

QWidget* PlateBox::ScrewPage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->addWidget(this->Screws);
  this->ScrewForm = this->Add(new RecipeForm("plate.screw"));
  this->ScrewForm->setToolTip(tr("Of the chosen screw; of all of them where none is chosen"));
  const auto number = [this](const char* name, const char* key, const QString& label,
                        const FormNumber& range, double PlateScrew::*member)
  {
    this->ScrewForm->Number(
      name, key, label, range, [this, member]() -> double& { return this->Screw().*member; });
  };
  number("diameter", "diameterMm", tr("Bore"), Millimetres(0.1, 20), &PlateScrew::diameterMm);
  number("head", "headDiameterMm", tr("Head"), Millimetres(0.1, 30), &PlateScrew::headDiameterMm);
  number("room", "headDepthMm", tr("Straight room for it"), Millimetres(0, 20),
    &PlateScrew::headDepthMm);
  number("cone", "headAngleDeg", tr("Cone below it"), Degrees(30, 150), &PlateScrew::headAngleDeg);
  number(
    "length", "lengthMm", tr("Length in bone"), Millimetres(0.1, 200, 1), &PlateScrew::lengthMm);
  this->ScrewForm->Direction(
    "axis", "axis", tr("Out of the bone along"),
    { { "view", tr("Towards me"), [this] { return -ViewDirection(this->Of); } } },
    [this] { return this->Screw().axis.value_or(glm::dvec3(0.0)); },
    [this](const glm::dvec3& axis) { this->Screw().axis = axis; });
  auto* upright = new QPushButton(tr("Upright on the plate"));
  upright->setObjectName("plate.screw.axis.upright");
  connect(upright, &QPushButton::clicked, this,
    [this]
    {
      this->Screw().axis.reset();
      this->TakeScrewNumbers();
    });
  this->ScrewForm->Row(upright);
  column->addWidget(this->ScrewForm);
  column->addStretch(1);
  return page;
}

PlanPlate PlateBox::Fresh()
{
  PlanPlate plate;
  plate.recipe.isovalue = this->Of.scene.Isovalue();
  return plate;
}

void PlateBox::Begun()
{
  this->Pages->setCurrentIndex(0);
  this->Landmarks->Take();
}

/// The first place says whether the plate is on fragments; each fragment that is touched is one of
/// them.
void PlateBox::TakeLandmarks()
{
  if (!this->Draft.IsShown())
    this->Draft.Begin(this->Fresh());
  const Plan& plan = this->Of.plan.Now();
  PlanPlate& plate = this->Draft.Typed();
  const std::vector<TouchedPlace>& places = this->Landmarks->Places();
  const std::vector<PlanId> touched = FragmentsOf(plan, places);
  if (plate.volume == 0)
    for (const PlanId fragment : touched)
      if (std::find(plate.fragments.begin(), plate.fragments.end(), fragment) ==
          plate.fragments.end())
        plate.fragments.push_back(fragment);
  if (plate.volume == 0 && plate.fragments.empty() && !places.empty())
    plate.volume = this->Of.scene.ShownVolume();
  else if (this->Draft.IsNew() && !plate.fragments.empty())
    plate.recipe.isovalue = IsovalueOfFragment(plan, plate.fragments[0]);
  plate.recipe.landmarks = this->Landmarks->Points();
  this->Put();
}

void PlateBox::TakeBone()
{
  if (!this->Draft.IsShown())
    return;
  PlanPlate& plate = this->Draft.Typed();
  plate.volume = this->Bone->currentData().toUInt();
  plate.fragments = plate.volume == 0 ? this->Fragments->Ticked() : std::vector<PlanId>{};
  this->Put();
}

void PlateBox::TakeScrews()
{
  this->Recipe().screws =
    MatchPoints(this->Recipe().screws, this->Screws->Points(), this->NextScrew);
  this->Put();
}

PlateScrew& PlateBox::Screw()
{
  std::vector<PlateScrew>& screws = this->Recipe().screws;
  const int chosen = this->Screws->Tool().Selected();
  return chosen >= 0 && chosen < int(screws.size()) ? screws[std::size_t(chosen)] : this->NextScrew;
}

/// Of the chosen screw, or of all, and of those to come.
void PlateBox::TakeScrewNumbers()
{
  if (&this->Screw() == &this->NextScrew)
    for (PlateScrew& screw : this->Recipe().screws)
    {
      const glm::dvec3 point = screw.point;
      screw = this->NextScrew;
      screw.point = point;
    }
  this->Put();
}

void PlateBox::Fill()
{
  const PlanPlate& plate = this->Draft.Typed();
  const bool shown = this->Draft.IsShown();
  this->Landmarks->SetPoints(plate.recipe.landmarks, 0);
  this->Screws->SetPoints(PointsOf(plate.recipe.screws), 0);
  this->FillBone();
  this->FillForms();
  this->Screws->setEnabled(shown);
}

void PlateBox::FillBone()
{
  const Plan& plan = this->Of.plan.Now();
  const PlanPlate& plate = this->Draft.Typed();
  this->Bone->clear();
  this->Bone->addItem(tr("fragments, as planned"), 0U);
  for (const PlanVolume& volume : plan.volumes)
    this->Bone->addItem(CalledWithName(plan, volume.id), volume.id);
  this->Bone->setCurrentIndex(this->Bone->findData(plate.volume));
  this->Bone->setEnabled(this->Draft.IsShown());
  this->Fragments->Show(plan, FragmentsOfScans(plan), plate.fragments);
  this->Fragments->setEnabled(this->Draft.IsShown() && plate.volume == 0);
}

} // namespace hasp
