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

constexpr int LeastPixels = 56; ///< four of them fit into the panel

struct Nudge
{
  const char *name, *letters, *text;
  glm::dvec3 axis;
};

constexpr Nudge Moves[] = {
  { "reduce.move.left", "L", QT_TRANSLATE_NOOP("hasp::NudgePad", "Move to the left"), { 1, 0, 0 } },
  { "reduce.move.right", "R", QT_TRANSLATE_NOOP("hasp::NudgePad", "Move to the right"),
    { -1, 0, 0 } },
  { "reduce.move.posterior", "P", QT_TRANSLATE_NOOP("hasp::NudgePad", "Move backwards"),
    { 0, 1, 0 } },
  { "reduce.move.anterior", "A", QT_TRANSLATE_NOOP("hasp::NudgePad", "Move forwards"),
    { 0, -1, 0 } },
  { "reduce.move.superior", "S", QT_TRANSLATE_NOOP("hasp::NudgePad", "Move up"), { 0, 0, 1 } },
  { "reduce.move.inferior", "I", QT_TRANSLATE_NOOP("hasp::NudgePad", "Move down"), { 0, 0, -1 } },
};
constexpr Nudge Turns[] = {
  { "reduce.turn.xplus", "↻ LR", QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn about left and right"),
    { 1, 0, 0 } },
  { "reduce.turn.xminus", "↺ LR",
    QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn back about left and right"), { -1, 0, 0 } },
  { "reduce.turn.yplus", "↻ PA", QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn about front and back"),
    { 0, 1, 0 } },
  { "reduce.turn.yminus", "↺ PA",
    QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn back about front and back"), { 0, -1, 0 } },
  { "reduce.turn.zplus", "↻ SI", QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn about up and down"),
    { 0, 0, 1 } },
  { "reduce.turn.zminus", "↺ SI",
    QT_TRANSLATE_NOOP("hasp::NudgePad", "Turn back about up and down"), { 0, 0, -1 } },
};

} // namespace

NudgePad::NudgePad(Planner& planner, QWidget* parent) : QWidget(parent), Of(planner)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->MoveStep = AddSpinBox(
    AddRow(layout), "reduce.move.step", tr("Move b&y"), { 0.01, 50.0, 0.5, tr(" mm"), 2 });
  this->TurnStep =
    AddSpinBox(AddRow(layout), "reduce.turn.step", tr("t&urn by"), { 0.1, 90.0, 1.0, tr("°") });
  auto* grid = new QGridLayout;
  const auto add = [&](const Nudge& nudge, int row, int column, auto method)
  {
    auto* button = new QPushButton(QString::fromUtf8(nudge.letters));
    button->setObjectName(QLatin1String(nudge.name));
    button->setAccessibleName(tr(nudge.text));
    button->setToolTip(tr(nudge.text));
    button->setMinimumWidth(LeastPixels);
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
