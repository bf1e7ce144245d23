// What a transplant's form does on the jaw's side; its rows are in TransplantRows.cxx.
#include "Steps/TransplantBox.h"

#include "BoneTouch.h"
#include "PlanFragmentLabels.h"
#include "Planning/TransplantPath.h"
#include "Steps/PointsEdit.h"
#include "Steps/TouchedFragment.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <QComboBox>
#include <QLabel>
#include <QTabWidget>

#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace hasp
{

namespace
{
constexpr double JawMm = 25.0; // no jaw is thicker
constexpr int RestMs = 300;
} // namespace

TransplantBox::TransplantBox(Planner& planner, QWidget* parent)
  : ObjectBox(planner, "transplant", tr("&New"), tr("transplant"), parent),
    Layout(new QLabel),
    Axis(new QLabel)
{
  const auto points = [&](const char* name, const QString& text, const LandmarkPurpose& purpose,
                        PointsEdit::Space space = PointsEdit::Space::Scan)
  { return new PointsEdit(planner, name, text, purpose, space); };
  using Line = LandmarkPurpose::Line;
  this->Path = points("transplant.path", tr("&Touch the path"),
    { tr("Touch the new jaw's middle line, from stump to stump, with a place at each corner."),
      MostPathPlaces, false, Line::Open },
    PointsEdit::Space::Planned);
  this->Tips = points("transplant.tips", tr("Touch both ti&ps"),
    { tr("Touch the two ends of the donor bone."), 2, true, Line::Open });
  this->Vessel = points("transplant.vessel", tr("Vessel"),
    { tr("Touch the vessel along the donor bone, in slices."), 1000, false, Line::Open });
  this->Paddle = points("transplant.paddle", tr("Skin"),
    { tr("Touch the outline of the skin that comes along, in order."), 1000, false, Line::Closed });
  this->Perforator = points("transplant.perforator", tr("Its vessel"),
    { tr("Touch where the skin's vessel reaches the bone."), 1, false });
  this->Pages = new QTabWidget;
  this->Pages->setObjectName("transplant.pages");
  this->Pages->addTab(this->JawPage(), tr("Jaw"));
  this->Pages->addTab(this->DonorPage(), tr("Donor"));
  this->Pages->addTab(this->TissuePage(), tr("Tissue"));
  this->Column->addWidget(this->Pages);
  this->Layout->setObjectName("transplant.segments");
  this->Layout->setWordWrap(true);
  this->Column->addWidget(this->Layout);
  this->Column->addStretch(1);
  connect(this->Path, &PointsEdit::Edited, this, &TransplantBox::TakePath);
  connect(this->Tips, &PointsEdit::Edited, this, &TransplantBox::TakeTips);
  connect(&planner.tools, &ToolBox::Changed, this,
    [this]
    {
      if (this->Of.tools.InHand() != &this->Path->Tool())
        this->Fill();
    });
  for (PointsEdit* tissue : { this->Vessel, this->Paddle, this->Perforator })
    connect(tissue, &PointsEdit::Edited, this, &TransplantBox::TakeTissue);
  this->Resting.setSingleShot(true);
  this->Resting.setInterval(RestMs);
  connect(&this->Resting, &QTimer::timeout, this, &TransplantBox::FindAxis);
  this->Fill();
}

PlanTransplant TransplantBox::Fresh()
{
  const Plan& plan = this->Of.plan.Now();
  PlanTransplant transplant;
  if (plan.cuts.size() >= 2) // the first two are the defect's
  {
    const PlanCut &first = plan.cuts[0], &last = plan.cuts[1];
    transplant.first = { first.id, StumpOf(plan, first, last) };
    transplant.last = { last.id, StumpOf(plan, last, first) };
  }
  return transplant;
}

void TransplantBox::Begun()
{
  this->Laid.clear();
  this->Path->SetPlaces({});
  this->Tips->SetPlaces({});
  this->Pages->setCurrentIndex(0);
  this->Path->Take();
}

void TransplantBox::TakePath()
{
  if (!this->Draft.IsShown())
    this->Draft.Begin(this->Fresh());
  if (this->Path->Places().size() >= 2)
    this->LayPath(this->Path->Points());
}

void TransplantBox::LayPath(const std::vector<glm::dvec3>& path)
{
  try
  {
    this->Draft.Typed() = AlongPath(this->Of.plan.Now(), this->Draft.Typed(), path, this->LeastMm);
  }
  catch (const std::invalid_argument& error)
  {
    return this->ShowFault(QString::fromStdString(error.what()));
  }
  this->Laid = path == this->Path->Points() ? this->Bone().joints : std::vector<TransplantJoint>{};
  if (this->Bone().donor.axis.size() >= 2)
    return this->Put();
  this->ShowFault({}); // it lacks its donor yet, which is said below
  this->Fill();
}

std::vector<glm::dvec3> TransplantBox::PathNow() const
{
  const PlanTransplant& transplant = this->Draft.Typed();
  return transplant.transplant.joints == this->Laid ? this->Path->Points()
                                                    : PathOf(this->Of.plan.Now(), transplant);
}

/// Places that were touched on the bone's outside go into its middle, across the path. One on a
/// sawn face is in the bone already.
void TransplantBox::ToTheMiddle()
{
  const Plan& plan = this->Of.plan.Now();
  const std::vector<glm::dvec3> path = this->Path->Points();
  std::vector<TouchedPlace> places = this->Path->Places();
  for (std::size_t n = 0; n < places.size() && path.size() >= 2; ++n)
  {
    TouchedPlace place = places[n];
    const PlanId volume = VolumeOfFragment(plan, place.object);
    const ShelfScan* scan =
      this->Of.scans.OfVolume(plan, volume != 0 ? volume : this->Of.scene.ShownVolume());
    const auto across =
      place.normal == glm::dvec3(0.0) ? std::nullopt : AcrossPath(path, n, place.normal);
    if (!scan || !across)
      continue;
    place.normal = *across;
    const double isovalue =
      volume != 0 ? IsovalueOfFragment(plan, place.object) : this->Of.scene.Isovalue();
    if (const auto middle = MiddleOfBone(
          ViewImage(scan->image), isovalue, place.inScan, -NormalInScan(plan, place), JawMm))
      places[n] = PlaceOfScan(plan, place.object, *middle);
  }
  this->Path->SetPlaces(std::move(places));
  this->TakePath();
}

void TransplantBox::TakeFaces()
{
  if (!this->Draft.IsShown())
    return;
  const auto chosen = [](const QComboBox* box) { return PlanId(box->currentData().toUInt()); };
  PlanTransplant& transplant = this->Draft.Typed();
  // The path is where it is planned, whatever its ends lie in.
  const std::vector<glm::dvec3> path = this->PathNow();
  transplant.first = { chosen(this->FirstCut), chosen(this->FirstFragment) };
  transplant.last = { chosen(this->LastCut), chosen(this->LastFragment) };
  if (path.size() >= 2)
    this->LayPath(path);
}

bool TransplantBox::IsChosen(std::size_t segment) const
{
  const int chosen = this->Segment->currentIndex(); // 0: all
  return chosen <= 0 || std::size_t(chosen - 1) == segment;
}

glm::dvec3 TransplantBox::Outward() const
{
  const std::vector<glm::dvec3>& outward = this->Draft.Typed().transplant.outward;
  for (std::size_t n = 0; n < outward.size(); ++n)
    if (this->IsChosen(n))
      return outward[n];
  return { 0.0, 0.0, 1.0 };
}

void TransplantBox::SetOutward(const glm::dvec3& direction)
{
  std::vector<glm::dvec3>& outward = this->Bone().outward;
  if (outward.empty()) // before the path: of all segments to come
    outward.push_back(direction);
  for (std::size_t n = 0; n < outward.size(); ++n)
    if (this->IsChosen(n))
      outward[n] = direction;
}

void TransplantBox::TakeRoll()
{
  if (const double degrees = std::exchange(this->RollDeg, 0.0);
      degrees != 0.0 && this->Bone().joints.size() >= 2)
  {
    const std::vector<glm::dvec3> path = PathOf(this->Of.plan.Now(), this->Draft.Typed());
    for (std::size_t n = 0; n < this->Bone().outward.size(); ++n)
      if (this->IsChosen(n))
      {
        const auto turn =
          glm::angleAxis(glm::radians(degrees), glm::normalize(path[n + 1] - path[n]));
        this->Bone().outward[n] = glm::normalize(turn * this->Bone().outward[n]);
      }
  }
  this->Put();
}

void TransplantBox::Fill()
{
  const PlanTransplant& transplant = this->Draft.Typed();
  const Transplant& bone = transplant.transplant;
  const bool shown = this->Draft.IsShown();
  // The path stays as it was touched or typed, though its ends go into the cuts' faces: the last
  // place may be a corner next.
  if (shown && !bone.joints.empty() && bone.joints != this->Laid)
    this->Path->SetPoints(PathOf(this->Of.plan.Now(), transplant), 0);
  else if (!shown && this->Of.tools.InHand() != &this->Path->Tool())
    this->Path->SetPlaces({});
  if (bone.donor.axis.size() >= 2)
    this->Tips->SetPoints({ bone.donor.axis.front(), bone.donor.axis.back() }, transplant.donor);
  else if (!shown)
    this->Tips->SetPlaces({});
  this->Vessel->SetPoints(bone.vessel, transplant.donor);
  if (bone.paddle || !shown)
  {
    this->Paddle->SetPoints(bone.paddle.value_or(SkinPaddle{}).outline, transplant.donor);
    this->Perforator->SetPoints(
      bone.paddle ? std::vector{ bone.paddle->perforator } : std::vector<glm::dvec3>{},
      transplant.donor);
  }
  this->FillChoices();
  this->FillForms();
  this->SayLayout();
}

} // namespace hasp
