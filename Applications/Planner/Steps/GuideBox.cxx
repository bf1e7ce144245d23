// What a guide's form does; its rows are in GuideRows.cxx, pins and the label in GuidePins.cxx.
#include "Steps/GuideBox.h"

#include "PlanFragmentLabels.h"
#include "Planning/BladePlacing.h"
#include "Steps/MatchPoints.h"
#include "Steps/ObjectChecks.h"
#include "Steps/PaintedArea.h"
#include "Steps/PointsEdit.h"
#include "Steps/TouchedFragment.h"

#include <QComboBox>
#include <QTabWidget>

#include <algorithm>

namespace hasp
{

namespace
{
constexpr double SameDirection = 2e-3; // a tenth of a degree

LandmarkPurpose LandmarksOf(const GuideRecipe& recipe)
{
  LandmarkPurpose purpose{ GuideBox::tr("Touch bone along the middle of the guide, in order.") };
  purpose.line = recipe.outline == GuideOutline::Open ? LandmarkPurpose::Line::Open
                                                      : LandmarkPurpose::Line::Closed;
  return purpose;
}
} // namespace

GuideBox::GuideBox(Planner& planner, QWidget* parent)
  : ObjectBox(planner, "guide", tr("&New"), tr("guide"), parent),
    Landmarks(new PointsEdit(planner, "guide.landmarks", tr("&Touch bone"), LandmarksOf({}))),
    Pins(new PointsEdit(planner, "guide.pins", tr("Touch &pins"),
      { tr("Touch where pins go through the guide into bone."), 100, true,
        LandmarkPurpose::Line::None, QColor(120, 200, 255) })),
    LabelPlace(new PointsEdit(planner, "guide.label", tr("Touch the &label's place"),
      { tr("Touch bone below the middle of the label."), 1, true, LandmarkPurpose::Line::None,
        QColor(255, 140, 255) })),
    Cuts(new ObjectChecks("guide.cut", tr("The plan has no cuts: make them in the step Cut."))),
    Paint(new PaintedArea(planner))
{
  this->NextLabel.kind = GuideLabelKind::Case;
  this->Pages = new QTabWidget;
  this->Pages->setObjectName("guide.pages");
  this->Pages->addTab(this->AreaPage(), tr("Area"));
  this->Pages->addTab(this->ShapePage(), tr("Shape"));
  this->Pages->addTab(this->CutsPage(), tr("Cuts"));
  this->Pages->addTab(this->PinsPage(), tr("Pins"));
  this->Column->addWidget(this->Pages);
  const auto put = [this] { this->Put(); };
  for (RecipeForm* form : { this->Area, this->Shape, this->LabelForm })
    connect(form, &RecipeForm::Edited, this, put);
  connect(this->PinForm, &RecipeForm::Edited, this, &GuideBox::TakePinNumbers);
  connect(this->Landmarks, &PointsEdit::Edited, this, &GuideBox::TakeLandmarks);
  connect(this->Paint, &PaintedArea::Painted, this, &GuideBox::TakePaint);
  connect(this->Paint, &PaintedArea::Cleared, this, [this] { this->TakePaint({}); });
  connect(this->Pins, &PointsEdit::Edited, this, &GuideBox::TakePins);
  connect(&this->Pins->Tool(), &LandmarkTool::SelectedChanged, this->PinForm, &RecipeForm::Refresh);
  connect(this->LabelPlace, &PointsEdit::Edited, this, &GuideBox::TakeLabel);
  connect(this->Bone, qOverload<int>(&QComboBox::activated), this, &GuideBox::TakeBone);
  connect(this->Cuts, &ObjectChecks::Edited, this,
    [this]
    {
      this->Draft.Typed().cuts = this->Cuts->Ticked();
      this->Put();
    });
  this->Fill();
}

PlanGuide GuideBox::Fresh()
{
  const Plan& plan = this->Of.plan.Now();
  PlanGuide guide;
  guide.cuts = IdsOf(plan.cuts); // a guide is there for its cuts
  return guide;
}

void GuideBox::Begun()
{
  this->FollowsNormals = true;
  this->Pages->setCurrentIndex(0);
  this->Landmarks->Take();
}

/// As the guide's bone was scanned, of a fragment that the reduction has turned.
glm::dvec3 GuideBox::InScan(const glm::dvec3& direction)
{
  TouchedPlace place;
  place.object = this->Draft.Typed().bone;
  place.normal = direction;
  return NormalInScan(this->Of.plan.Now(), place);
}

glm::dvec3 GuideBox::MeanNormal()
{
  Planner& planner = this->Of;
  const PlanId bone = this->Draft.Typed().bone;
  const PlanId scan = VolumeOfFragment(planner.plan.Now(), bone);
  std::vector<glm::dvec3> normals;
  const auto add = [&](const TouchedPlace& place)
  { normals.push_back(ScanNormal(planner, scan != 0 ? scan : bone, place)); };
  for (const TouchedPlace& place : this->Landmarks->Places())
    add(place);
  if (normals.empty()) // a painted one
    for (const GuideStroke& stroke : this->Recipe().strokes)
      for (const glm::dvec3& point : stroke.points)
        if (!stroke.erased)
          add(PlaceOfScan(planner.plan.Now(), bone, point));
  return MeanDirection(normals).value_or(glm::dvec3(0.0));
}

void GuideBox::SetWithdrawal(const glm::dvec3& direction)
{
  GuideRecipe& recipe = this->Recipe();
  for (GuideHole& hole : recipe.holes) // those that stood along it, stand along it
    if (glm::distance(hole.axis, recipe.withdrawal) < SameDirection)
      hole.axis = direction;
  recipe.withdrawal = direction;
  this->FollowsNormals = glm::distance(this->MeanNormal(), direction) < SameDirection;
}

/// A new one sits on what was touched first. Guides are worn before the saw: on the whole bone,
/// where a piece of it was touched.
void GuideBox::BeginOn(const TouchedPlace& place)
{
  if (!this->Draft.IsShown())
  {
    this->Draft.Begin(this->Fresh());
    this->FollowsNormals = true;
  }
  const Plan& plan = this->Of.plan.Now();
  PlanGuide& guide = this->Draft.Typed();
  if (guide.bone != 0)
    return;
  const PlanFragment* whole = WholeOf(plan, place.object);
  guide.bone = whole ? whole->id : this->Of.scene.ShownVolume();
  guide.recipe.isovalue = whole ? IsovalueOfFragment(plan, whole->id) : this->Of.scene.Isovalue();
}

void GuideBox::LiftAlongNormals()
{
  if (const glm::dvec3 mean = this->MeanNormal(); this->FollowsNormals && mean != glm::dvec3(0.0))
    this->SetWithdrawal(mean);
}

void GuideBox::TakeLandmarks()
{
  if (!this->Landmarks->Places().empty())
    this->BeginOn(this->Landmarks->Places()[0]);
  this->Recipe().landmarks = this->Landmarks->Points();
  this->LiftAlongNormals();
  this->Put();
}

void GuideBox::TakePaint(const TouchedPlace& first)
{
  if (!this->Paint->Strokes().empty())
    this->BeginOn(first);
  this->Recipe().strokes = this->Paint->Strokes();
  this->LiftAlongNormals();
  this->Put();
}

void GuideBox::TakeBone()
{
  if (!this->Draft.IsShown())
    return;
  this->Draft.Typed().bone = this->Bone->currentData().toUInt();
  this->Put();
}

void GuideBox::Fill()
{
  const Plan& plan = this->Of.plan.Now();
  const PlanGuide& guide = this->Draft.Typed();
  const bool shown = this->Draft.IsShown();
  this->Landmarks->Tool().SetPurpose(LandmarksOf(guide.recipe));
  this->Landmarks->SetPoints(guide.recipe.landmarks, guide.bone);
  this->Paint->SetStrokes(guide.recipe.strokes, guide.bone);
  this->Pins->SetPoints(PointsOf(guide.recipe.holes), guide.bone);
  const GuideLabel* label = this->CaseLabel();
  this->LabelPlace->SetPoints(
    label ? std::vector<glm::dvec3>{ label->point } : std::vector<glm::dvec3>{}, guide.bone);
  if (shown && !this->Draft.IsNew())
    this->FollowsNormals =
      glm::distance(this->MeanNormal(), guide.recipe.withdrawal) < SameDirection;
  this->FillBones();
  this->Cuts->Show(plan, IdsOf(plan.cuts), guide.cuts);
  this->FillForms();
  this->Pins->setEnabled(shown);
  this->LabelPlace->setEnabled(shown);
  this->Cuts->setEnabled(shown);
}

void GuideBox::FillBones()
{
  const Plan& plan = this->Of.plan.Now();
  this->Bone->clear();
  for (const PlanVolume& volume : plan.volumes)
    this->Bone->addItem(CalledWithName(plan, volume.id), volume.id);
  for (const PlanId fragment : FragmentsOfScans(plan))
    this->Bone->addItem(CalledWithName(plan, fragment), fragment);
  this->Bone->setCurrentIndex(this->Bone->findData(this->Draft.Typed().bone));
}

} // namespace hasp
