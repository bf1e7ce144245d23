// The rows of a transplant's form.
#include "Planning/TransplantPath.h"
#include "Steps/PointsEdit.h"
#include "Steps/TouchButton.h"
#include "Steps/TouchedFragment.h"
#include "Steps/TransplantBox.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include <glm/trigonometric.hpp>

namespace hasp
{

namespace
{
QComboBox* NamedBox(const char* name)
{
  auto* box = new QComboBox;
  box->setObjectName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  return box;
}

template <typename Act>
QPushButton* NamedButton(QBoxLayout* row, const char* name, const QString& text, Act act)
{
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  QObject::connect(button, &QPushButton::clicked, button, act);
  row->addWidget(button);
  return button;
}
} // namespace

QWidget* TransplantBox::JawPage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  NamedButton(
    column, "transplant.look.jaw", tr("Look at the &jaw"), [this] { this->LookAt(false); });
  column->addWidget(this->Path);
  auto* row = new QHBoxLayout;
  column->addLayout(row);
  NamedButton(row, "transplant.middle", tr("To its middle"), [this] { this->ToTheMiddle(); })
    ->setToolTip(tr("Places that were touched on the bone's outside go into its middle"));
  NamedButton(row, "transplant.more", tr("Segment +"),
    [this] { this->LayPath(PathWithOneMore(this->PathNow())); });
  NamedButton(row, "transplant.less", tr("Segment −"),
    [this] { this->LayPath(PathWithOneLess(this->PathNow())); });
  RecipeForm* form = this->Add(new RecipeForm("transplant"));
  form->Text("name", tr("Name"), [this]() -> std::string& { return this->Draft.Typed().name; });
  this->AddFaces(form);
  this->AddOutward(form);
  form->Number("least", "leastSegmentMm", tr("Shortest segment"), Millimetres(1, 200, 1),
    [this]() -> double& { return this->LeastMm; });
  form->Number("gap", "mostGapMm", tr("Gaps up to"), Millimetres(0, 10),
    [this]() -> double& { return this->Draft.Typed().mostGapMm; });
  form->Number("overlap", "mostOverlapMm", tr("Overlaps up to"), Millimetres(0, 10),
    [this]() -> double& { return this->Draft.Typed().mostOverlapMm; });
  connect(form, &RecipeForm::Edited, this, &TransplantBox::TakeRoll);
  column->addWidget(form);
  column->addStretch(1);
  return page;
}

void TransplantBox::AddFaces(RecipeForm* form)
{
  const auto add = [&](const char* name, const QString& label)
  {
    QComboBox* box = NamedBox(name);
    form->Row(label, box);
    connect(box, qOverload<int>(&QComboBox::activated), this, &TransplantBox::TakeFaces);
    return box;
  };
  this->FirstCut = add("transplant.first.cut", tr("Begins at the face of"));
  this->FirstFragment = add("transplant.first.fragment", tr("of the stump"));
  this->LastCut = add("transplant.last.cut", tr("Ends at the face of"));
  this->LastFragment = add("transplant.last.fragment", tr("of the stump"));
}

void TransplantBox::AddOutward(RecipeForm* form)
{
  this->Segment = NamedBox("transplant.segment");
  form->Row(tr("Of segment"), this->Segment);
  connect(this->Segment, qOverload<int>(&QComboBox::activated), form, [form] { form->Refresh(); });
  form->Direction(
    "outward", "outward", tr("Its lateral side looks"),
    { { "view", tr("Towards me"), [this] { return -ViewDirection(this->Of); } } },
    [this] { return this->Outward(); },
    [this](const glm::dvec3& direction) { this->SetOutward(direction); });
  form->Number("roll", "rollDeg", tr("Turn it about its axis"), Degrees(-180, 180),
    [this]() -> double& { return this->RollDeg; });
}

QWidget* TransplantBox::DonorPage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  NamedButton(
    column, "transplant.look.donor", tr("Look at the d&onor"), [this] { this->LookAt(true); });
  column->addWidget(this->Tips);
  NamedButton(
    column, "transplant.axis.find", tr("Find &its middle line"), [this] { this->FindAxis(); });
  this->Axis->setObjectName("transplant.axis");
  column->addWidget(this->Axis);
  auto* side = new TouchButton(this->Of, "transplant.side", tr("Touch its lateral &side"),
    tr("Touch the side of the donor bone that is known again in the defect."));
  connect(side, &TouchButton::Touched, this, &TransplantBox::TakeSide);
  column->addWidget(side);
  RecipeForm* form = this->Add(new RecipeForm("transplant"));
  this->Donor = NamedBox("transplant.donor");
  form->Row(tr("Donor bone"), this->Donor);
  connect(this->Donor, qOverload<int>(&QComboBox::activated), this,
    [this] { this->TakeDonor(this->Donor->currentData().toUInt()); });
  form->Direction(
    "lateral", "donor.lateral", tr("Lateral side"),
    { { "view", tr("Towards me"), [this] { return -ViewDirection(this->Of); } } },
    [this] { return this->Bone().donor.lateral; },
    [this](const glm::dvec3& direction) { this->Bone().donor.lateral = direction; });
  this->AddSaw(form);
  connect(form, &RecipeForm::Edited, this, [this] { this->Put(); });
  column->addWidget(form);
  column->addStretch(1);
  return page;
}

void TransplantBox::AddSaw(RecipeForm* form)
{
  const auto donor = [this](double DonorBone::*member)
  {
    return [this, member]() -> double& { return this->Bone().donor.*member; };
  };
  const auto saw = [this](double Transplant::*member)
  {
    return [this, member]() -> double& { return this->Bone().*member; };
  };
  form->Number("radius", "donor.radiusMm", tr("Radius"), Millimetres(0.1, 50, 0.5),
    donor(&DonorBone::radiusMm));
  form->Number("keep", "donor.keepMm", tr("Stays at both tips"), Millimetres(0, 500, 1),
    donor(&DonorBone::keepMm));
  form->Number("start", "startOffsetMm", tr("Left over before"), Millimetres(0, 500, 1),
    saw(&Transplant::startOffsetMm));
  form->Check(
    "lasttip", tr("From the second tip"), [this] { return this->Bone().fromLastTip; },
    [this](bool on) { this->Bone().fromLastTip = on; });
  form->Number("kerf", "kerfMm", tr("Kerf"), Millimetres(0.05, 5, 0.05), saw(&Transplant::kerfMm));
  form->Number("between", "betweenMm", tr("Between segments"), Millimetres(0, 100, 0.5),
    saw(&Transplant::betweenMm));
}

QWidget* TransplantBox::TissuePage()
{
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  const auto add = [&](const QString& title, PointsEdit* points)
  {
    auto* text = new QLabel(title);
    text->setWordWrap(true);
    column->addWidget(text);
    column->addWidget(points);
  };
  add(tr("The vessel along the donor, if it is to be followed:"), this->Vessel);
  add(
    tr(
      "Skin that comes along: its outline on the donor, three places or more, and where its vessel "
      "reaches the bone:"),
    this->Paddle);
  column->addWidget(this->Perforator);
  column->addStretch(1);
  return page;
}

void TransplantBox::FillChoices()
{
  const Plan& plan = this->Of.plan.Now();
  const PlanTransplant& transplant = this->Draft.Typed();
  const auto fill = [&](QComboBox* box, const std::vector<PlanId>& ids, PlanId now)
  {
    box->clear();
    box->addItem(tr("none"), 0U);
    for (const PlanId id : ids)
      box->addItem(CalledWithName(plan, id), id);
    box->setCurrentIndex(box->findData(now));
  };
  const std::vector<PlanId> cuts = IdsOf(plan.cuts), fragments = FragmentsOfScans(plan);
  fill(this->FirstCut, cuts, transplant.first.cut);
  fill(this->LastCut, cuts, transplant.last.cut);
  fill(this->FirstFragment, fragments, transplant.first.fragment);
  fill(this->LastFragment, fragments, transplant.last.fragment);
  fill(this->Donor, fragments, transplant.donor);
  const int chosen = std::max(0, this->Segment->currentIndex());
  const int segments = int(transplant.transplant.outward.size());
  this->Segment->clear();
  this->Segment->addItem(tr("all"));
  for (int n = 1; n <= segments; ++n)
    this->Segment->addItem(QString::number(n));
  this->Segment->setCurrentIndex(chosen <= segments ? chosen : 0);
  const std::size_t axis = transplant.transplant.donor.axis.size();
  this->Axis->setText(axis < 2   ? QString()
                      : axis > 2 ? tr("Its middle line has %1 places.").arg(axis)
                                 : tr("Its middle line is straight, from tip to tip."));
}

/// What the segments come out as, or why they cannot be cut: before anything is made.
void TransplantBox::SayLayout()
{
  const PlanTransplant& transplant = this->Draft.Typed();
  if (!this->Draft.IsShown() || transplant.transplant.joints.size() < 2)
    return this->Layout->clear();
  if (transplant.transplant.donor.axis.size() < 2)
    return this->Layout->setText(tr("Touch both tips of the donor bone."));
  try
  {
    QStringList lines;
    const auto segments = LayOutSegments(TransplantOf(this->Of.plan.Now(), transplant));
    for (std::size_t n = 0; n < segments.size(); ++n)
      lines << tr("Segment %1: %2 mm, shortest side %3 mm, wedge %4°")
                 .arg(n + 1)
                 .arg(segments[n].lengthMm, 0, 'f', 1)
                 .arg(segments[n].shortestMm, 0, 'f', 1)
                 .arg(glm::degrees(segments[n].wedgeRadians), 0, 'f', 1);
    this->Layout->setText(lines.join('\n'));
  }
  catch (const std::exception& error)
  {
    this->Layout->setText(this->Fault->InWords(QString::fromStdString(error.what())));
  }
}

} // namespace hasp
