#include "Steps/FitBox.h"

#include "Output/PartWork.h"
#include "Output/RedParts.h"
#include "Planning/PlanLists.h"
#include "Steps/NumberText.h"
#include "Steps/PanelWidgets.h"
#include "Tools/Planner.h"

#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include <exception>

namespace hasp
{
namespace
{

QString Mm(double mm)
{
  return QString::number(mm, 'f', 2);
}

/// What can be changed about a part that bone is in the way of.
QString RemedyOf(const Plan& plan, PlanId object)
{
  if (FindPlanObject<PlanGuide>(plan, object))
    return FitBox::tr("change the way it lifts off, or its outline");
  if (FindPlanObject<PlanPlate>(plan, object))
    return FitBox::tr("move its landmarks away from there, or make it narrower");
  if (FindPlanObject<PlanImplant>(plan, object))
    return FitBox::tr("change its outline, the way it is put in, or give it more clearance");
  return FitBox::tr("make it narrower, or shorter beyond the cuts");
}

} // namespace

QString SeatText(const Plan& plan, const PartSeat& push, const PartFacts& facts)
{
  const Seat& seat = push.seat;
  if (!seat.touched)
    return FitBox::tr("%1 touches nothing, not even %2 mm beyond its planned place.")
      .arg(facts.called, Mm(seat.depthMm));
  const QString at = WriteNumbers(seat.boneAt, 1);
  if (!seat.seats)
    return FitBox::tr(
      "%1 is blocked %2 mm before its planned place, by bone at (%3) mm: %4, and make it again.")
      .arg(facts.called, Mm(-seat.depthMm), at, RemedyOf(plan, facts.object));
  QString text =
    FitBox::tr("%1 seats: it touches first %2 mm beyond its planned place, at (%3) mm.")
      .arg(facts.called, Mm(seat.depthMm), at);
  if (facts.certificate && facts.certificate->gap)
    text += FitBox::tr(" The least gap of its certificate is %1 mm.")
              .arg(Mm(facts.certificate->gap->least));
  return text;
}

FitBox::FitBox(Planner& planner, QWidget* parent)
  : QGroupBox(tr("Test fit"), parent),
    Of(planner),
    Hand(planner)
{
  auto* layout = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  this->Taking = AddButton(row, "check.fit", tr("&Try it on"));
  this->Taking->setCheckable(true);
  this->Taking->setToolTip(tr("Move the part against its bone and feel where it touches"));
  this->Lifting = AddButton(row, "check.lift", tr("&Lift it off"));
  this->Pushing = AddButton(row, "check.seat", tr("Push it &on"));
  this->Pushing->setToolTip(tr("Straight along its withdrawal, until it touches"));
  layout->addLayout(row);
  for (auto [label, name] :
    { std::pair(&this->State, "check.fit.state"), std::pair(&this->Result, "check.seat.result") })
  {
    *label = new QLabel;
    (*label)->setObjectName(name);
    (*label)->setWordWrap(true);
    layout->addWidget(*label);
  }
  connect(this->Taking, &QPushButton::clicked, this, &FitBox::TakeInHand);
  connect(this->Lifting, &QPushButton::clicked, &this->Hand, &FitTool::Lift);
  connect(this->Pushing, &QPushButton::clicked, this, &FitBox::Push);
  connect(&this->Hand, &FitTool::StateChanged, this, &FitBox::Refresh);
  connect(&planner.tools, &ToolBox::Changed, this, &FitBox::Refresh);
  this->Refresh();
}

void FitBox::Show(const PartFacts* facts)
{
  this->Shown = facts ? std::optional<PartFacts>(*facts) : std::nullopt;
  if (this->Made && !this->IsOfNow(this->Made->inputs))
  {
    this->Hand.SetBody(nullptr);
    this->Made.reset();
  }
  this->Refresh();
}

/// Whether the part that is shown is made of these, and can be tried.
bool FitBox::IsOfNow(const std::vector<PartInput>& inputs) const
{
  return this->Shown && IsPartObject(this->Of.plan.Now(), this->Shown->object) &&
         PartInputs(this->Of.plan.Now(), this->Shown->object) == inputs;
}

std::optional<Seat> FitBox::LastSeat() const
{
  if (!this->Made || !this->Made->seat || !this->IsOfNow(this->Made->inputs))
    return std::nullopt;
  return this->Made->seat->seat;
}

void FitBox::WithBody(const std::function<void(const std::shared_ptr<const PartOnBone>&)>& then)
{
  if (!this->Shown)
    return;
  if (this->Made)
    return then(this->Made->body);
  const PlanId object = this->Shown->object;
  try
  {
    const auto work = std::make_shared<PartWork>(this->Of, std::vector<PlanId>{ object });
    this->Of.jobs.Add(tr("Preparing the test fit of %1").arg(this->Shown->called),
      [work, object, then, inputs = PartInputs(this->Of.plan.Now(), object),
        box = QPointer<FitBox>(this)](const ProgressFunction& progress) -> JobQueue::Finish
      {
        auto body = MakePartOnBone(*work, object, progress);
        return [=]
        {
          if (!box || !box->IsOfNow(inputs))
            return; // another part is shown, or it has changed
          box->Made = Kept{ inputs, body, std::nullopt };
          then(body);
        };
      });
  }
  catch (const std::exception& error)
  {
    this->Of.SayFault(QString::fromUtf8(error.what()));
  }
}

void FitBox::TakeInHand(bool on)
{
  this->Refresh(); // it is down when it is in hand
  if (!on)
    return this->Of.tools.Take(nullptr);
  this->WithBody(
    [this](const std::shared_ptr<const PartOnBone>& body)
    {
      if (!this->isVisible())
        return; // another step was chosen while the bone was prepared
      this->Hand.SetBody(body);
      this->Of.tools.Take(&this->Hand);
    });
}

void FitBox::Push()
{
  this->WithBody(
    [this](const std::shared_ptr<const PartOnBone>& body)
    {
      this->Of.jobs.Add(tr("Pushing %1 on").arg(QString::fromStdString(body->called)),
        [body, box = QPointer<FitBox>(this)](const ProgressFunction& progress) -> JobQueue::Finish
        {
          const PartSeat seat = SeatPart(*body, progress);
          return [=]
          {
            if (!box || !box->Made || box->Made->body != body)
              return;
            box->Made->seat = seat;
            box->Hand.Show(seat.seat);
            box->Refresh();
          };
        });
    });
}

void FitBox::Refresh()
{
  const bool inHand = this->Of.tools.InHand() == &this->Hand;
  const bool can =
    this->Shown &&
    (this->Shown->state == PartState::InDate || this->Shown->state == PartState::DoesNotHold) &&
    IsPutOnBone(*this->Shown);
  this->Taking->setEnabled(can || inHand);
  this->Taking->setChecked(inHand);
  this->Pushing->setEnabled(can);
  this->Lifting->setEnabled(inHand);
  const FitState now = this->Hand.State();
  if (!can)
    this->State->setText(
      !this->Shown || !this->Shown->why.isEmpty()
        ? tr("A part must be made, and in date, before it is tried on.")
      : this->Shown->certificate
        ? tr("%1 lies on fragments where the plan puts them: it cannot be tried on scanned bone.")
            .arg(this->Shown->called)
        : tr("%1 is put on no bone: there is nothing to try.").arg(this->Shown->called));
  else if (!inHand)
    this->State->setText(
      tr("Lifted off, the part is moved against its bone before it is exported."));
  else if (!now.isReady)
    this->State->setText(tr("Preparing what is felt: %1 %").arg(int(100.0 * now.share)));
  else
    this->State->setText((now.isTouching ? tr("Touches, %1 mm off its planned place.")
                                         : tr("Free, %1 mm off its planned place."))
                           .arg(Mm(now.offMm)));
  const bool pushed = can && this->Made && this->Made->seat;
  this->Result->setText(
    pushed ? SeatText(this->Of.plan.Now(), *this->Made->seat, *this->Shown) : QString());
  this->Result->setVisible(pushed);
}

} // namespace hasp
