#include "Steps/NudgePad.h"

#include "Planning/PlanLists.h"
#include "Steps/MoveEdits.h"
#include "Steps/PanelWidgets.h"
#include "Tools/DistanceBody.h"

#include "vtkDataSet.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace hasp
{
namespace
{

struct Nudge
{
  const char *name, *text;
  glm::dvec3 axis;
};

constexpr Nudge Moves[] = {
  { "reduce.move.left", QT_TRANSLATE_NOOP("hasp::NudgePad", "Left"), { 1, 0, 0 } },
  { "reduce.move.right", QT_TRANSLATE_NOOP("hasp::NudgePad", "Right"), { -1, 0, 0 } },
  { "reduce.move.posterior", QT_TRANSLATE_NOOP("hasp::NudgePad", "Posterior"), { 0, 1, 0 } },
  { "reduce.move.anterior", QT_TRANSLATE_NOOP("hasp::NudgePad", "Anterior"), { 0, -1, 0 } },
  { "reduce.move.superior", QT_TRANSLATE_NOOP("hasp::NudgePad", "Superior"), { 0, 0, 1 } },
  { "reduce.move.inferior", QT_TRANSLATE_NOOP("hasp::NudgePad", "Inferior"), { 0, 0, -1 } },
};
constexpr Nudge Turns[] = {
  { "reduce.turn.xplus", QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn x +"), { 1, 0, 0 } },
  { "reduce.turn.xminus", QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn x −"), { -1, 0, 0 } },
  { "reduce.turn.yplus", QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn y +"), { 0, 1, 0 } },
  { "reduce.turn.yminus", QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn y −"), { 0, -1, 0 } },
  { "reduce.turn.zplus", QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn z +"), { 0, 0, 1 } },
  { "reduce.turn.zminus", QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn z −"), { 0, 0, -1 } },
};

} // namespace

NudgePad::NudgePad(Planner& planner, QWidget* parent) : QWidget(parent), Of(planner)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* steps = new QHBoxLayout;
  this->MoveStep =
    AddSpinBox(steps, "reduce.move.step", tr("Move b&y"), { 0.01, 50.0, 0.5, tr(" mm"), 2 });
  this->TurnStep =
    AddSpinBox(steps, "reduce.turn.step", tr("t&urn by"), { 0.1, 90.0, 1.0, tr("°") });
  layout->addLayout(steps);
  auto* grid = new QGridLayout;
  const auto add = [&](const Nudge& nudge, int row, int column, auto method)
  {
    auto* button = new QPushButton(tr(nudge.text));
    button->setObjectName(QLatin1String(nudge.name));
    button->setAutoRepeat(true);
    grid->addWidget(button, row, column);
    connect(button, &QPushButton::clicked, this, [=, this] { (this->*method)(nudge.axis); });
  };
  for (int n = 0; n < 6; ++n)
  {
    add(Moves[n], n / 2, n % 2, &NudgePad::Move);
    add(Turns[n], n / 2, 2 + n % 2, &NudgePad::Turn);
  }
  layout->addLayout(grid);
  QPushButton* back = AddButton(layout, "reduce.back", tr("&Back to where it was scanned"));
  connect(back, &QPushButton::clicked, this, &NudgePad::Back);
  connect(&planner.scene, &PlanScene::SelectedChanged, this, &NudgePad::Refresh);
  connect(&planner.plan, &PlanSession::Changed, this, &NudgePad::Refresh);
  this->Refresh();
}

void NudgePad::Refresh()
{
  this->setEnabled(!this->Unit().empty());
}

std::vector<PlanId> NudgePad::Unit() const
{
  return UnitOf(this->Of.plan.Now(), this->Of.scene.Selected());
}

void NudgePad::Move(const glm::dvec3& direction)
{
  const PlanPose motion{ this->MoveStep->value() * direction };
  this->Of.plan.Do(MovedFragments(this->Of.plan.Now(), this->Unit(), motion));
}

void NudgePad::Turn(const glm::dvec3& axis)
{
  const Plan& plan = this->Of.plan.Now();
  const PlanId id = this->Of.scene.Selected();
  const auto* fragment = FindPlanObject<PlanFragment>(plan, id);
  const std::optional<ShownBody> body = ShownBody::Of(this->Of.scene.PropOf(id));
  if (!fragment || !body)
  {
    this->Of.SayFault(tr("What is not shown has no middle to be turned about: show it first."));
    return;
  }
  glm::dvec3 middle;
  vtkDataSet::SafeDownCast(body->data)->GetCenter(&middle.x);
  const PlanPose motion =
    TurnAbout(fragment->scanToPlanned.Place(middle), axis, this->TurnStep->value());
  this->Of.plan.Do(MovedFragments(plan, this->Unit(), motion));
}

void NudgePad::Back()
{
  const std::optional<PoseFragments> edit = BackToScan(this->Of.plan.Now(), this->Unit());
  if (edit)
    this->Of.plan.Do(*edit, tr("Back to where it was scanned"));
  else
    this->Of.Say(tr("It is where it was scanned."));
}

} // namespace hasp
