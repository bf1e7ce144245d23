// Cutting as a surgeon does it: by touching bone, pressing buttons and typing.
#include "StepsDesk.h"

#include "Model/ObjectNames.h"
#include "Planning/PlanLists.h"
#include "Steps/CutPanel.h"
#include "Steps/ObjectChooser.h"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QTranslator>
#include <QtTest>

#include <gtest/gtest.h>

#include <cmath>

using namespace hasp;
using namespace hasp::testing;

namespace
{

TEST(CutPanel, TwoTouchesMakeACutAndAThirdTurnsIt)
{
  StepsDesk desk(ScanOfBar());
  CutPanel panel(desk.planner);
  desk.Show(&panel);
  const std::size_t steps = desk.Steps();
  desk.Press("cut.new");
  desk.Touch(Front(2.0, 4.0));
  EXPECT_TRUE(desk.Now().cuts.empty());
  desk.Touch(Front(2.0, -4.0));
  ASSERT_EQ(desk.Now().cuts.size(), 1U);
  EXPECT_EQ(desk.Steps(), steps + 1); // the bone became a fragment in the same step
  ASSERT_EQ(desk.Now().fragments.size(), 1U);
  const PlanCut cut = desk.Now().cuts[0];
  EXPECT_EQ(cut.fragments, std::vector<PlanId>{ desk.Now().fragments[0].id });
  EXPECT_EQ(desk.Now().fragments[0].name, CalledObject(desk.Now(), cut.fragments[0]));
  EXPECT_EQ(cut.name, CalledObject(desk.Now(), cut.id));
  EXPECT_EQ(CalledWithName(desk.Now(), cut.id).toStdString(), cut.name); // once
  EXPECT_GT(std::abs(cut.blade.normal.x), 0.98); // upright on the bar: as one looks
  EXPECT_NEAR(cut.blade.point.x, 2.0, ClickMm);
  desk.Settle();
  desk.Touch(Front(12.0, 0.0));
  EXPECT_EQ(desk.Steps(), steps + 2);
  const Osteotomy turned = desk.Now().cuts[0].blade;
  EXPECT_LT(std::abs(turned.normal.x), 0.9); // through three places of the front
  desk.planner.plan.Undo();
  EXPECT_EQ(desk.Now().cuts[0].blade, cut.blade);
  desk.planner.plan.Undo();
  EXPECT_TRUE(desk.Now().cuts.empty());
  EXPECT_TRUE(desk.Now().fragments.empty());
}

TEST(CutPanel, NumbersMoveTheBladeAndWhatIsTypedIsKept)
{
  StepsDesk desk(ScanOfBar());
  CutPanel panel(desk.planner);
  desk.Show(&panel);
  desk.planner.scene.Select(desk.CutBar(0.0));
  const std::size_t steps = desk.Steps();
  desk.Type("cut.kerf", "0.7");
  EXPECT_EQ(desk.Now().cuts[0].blade.kerfMm, 0.7);
  desk.Type("cut.shift.normal", "2.5");
  EXPECT_NEAR(desk.Now().cuts[0].blade.point.x, 2.5, 1e-9);
  desk.Type("cut.turn.along", "90");
  EXPECT_NEAR(std::abs(desk.Now().cuts[0].blade.normal.y), 1.0, 1e-9);
  EXPECT_EQ(desk.Steps(), steps + 3);
  desk.Type("cut.kerf", "0.7"); // as it is
  EXPECT_EQ(desk.Steps(), steps + 3);
  // A number that is being typed stays when the plan changes under it.
  auto* width = static_cast<QDoubleSpinBox*>(desk.Find("cut.width"));
  width->setFocus();
  width->selectAll();
  QTest::keyClicks(width, "33");
  desk.planner.plan.Undo();
  EXPECT_TRUE(width->text().startsWith("33"));
  QTest::keyClick(width, Qt::Key_Return);
  EXPECT_EQ(desk.Now().cuts[0].blade.widthMm, 33.0);
}

struct OneWordOfSwedish : QTranslator
{
  bool isEmpty() const override { return false; }
  QString translate(const char*, const char* text, const char*, int) const override
  {
    return QString(text) == "cut %1" ? QString("snitt %1") : QString();
  }
};

TEST(ObjectChooser, OnlyNamesThatSayMoreAreSaid)
{
  OneWordOfSwedish swedish;
  qApp->installTranslator(&swedish);
  Plan plan;
  plan.cuts.resize(1);
  plan.cuts[0].id = 4;
  for (const auto& [name, called] :
    { std::pair("", "cut 4"), std::pair("cut 4", "cut 4"), std::pair("snitt 4", "cut 4"),
      std::pair("chin", "cut 4: chin"), std::pair("cut 5", "cut 4: cut 5") })
  {
    plan.cuts[0].name = name;
    EXPECT_EQ(CalledWithName(plan, 4).toStdString(), called);
  }
  EXPECT_EQ(ObjectNames::Of<PlanCut>(4), "snitt 4");
}

/// A bar that is cut in two places.
class TwoCuts : public ::testing::Test
{
protected:
  TwoCuts()
  {
    this->desk.Show(&this->panel);
    this->desk.CutBar(-8.0);
    this->desk.planner.scene.Select(this->desk.CutBar(8.0));
    this->steps = this->desk.Steps();
  }
  StepsDesk desk{ ScanOfBar() };
  CutPanel panel{ this->desk.planner };
  std::size_t steps = 0; ///< that the plan has by then
};

TEST_F(TwoCuts, LeaveThreePiecesAndTheMiddleIsResected)
{
  desk.Press("cut.pieces");
  desk.Settle();
  EXPECT_EQ(desk.Steps(), steps + 1);
  ASSERT_EQ(desk.Now().fragments.size(), 4U) << desk.said.toStdString();
  desk.Press("cut.pieces");
  desk.Settle();
  EXPECT_EQ(desk.Steps(), steps + 1); // they are there
  auto* list = static_cast<QListWidget*>(desk.Find("cut.piece.list"));
  ASSERT_EQ(list->count(), 3);
  for (int row = 0; row < 3; ++row)
  {
    const auto* piece =
      FindPlanObject<PlanFragment>(desk.Now(), list->item(row)->data(Qt::UserRole).toUInt());
    EXPECT_EQ(piece->name, "piece " + std::to_string(piece->id) + " of fragment " +
                             std::to_string(desk.Now().fragments[0].id));
    list->item(row)->setSelected(std::abs(std::get<PieceSource>(piece->source).seed.x) < 7.5);
  }
  desk.Press("cut.resect");
  int resected = 0;
  for (const PlanFragment& fragment : desk.Now().fragments)
    resected += fragment.state == FragmentState::Resected;
  EXPECT_EQ(resected, 1);
  desk.planner.plan.Undo();
  desk.planner.plan.Undo();
  EXPECT_EQ(desk.Now().fragments.size(), 1U);
  EXPECT_EQ(list->count(), 0);
}

/// Only those, whichever was touched first, and each where it was touched.
TEST_F(TwoCuts, LeaveTheTouchedPiecesAndNoOther)
{
  const PlanId bar = desk.Now().fragments[0].id;
  desk.Press("cut.seeds");
  desk.Touch(Front(20.0));
  desk.Touch(Front(-20.0));
  EXPECT_EQ(desk.Steps(), steps); // not yet
  desk.Press("cut.keep");
  desk.Settle();
  EXPECT_EQ(desk.Steps(), steps + 1) << desk.said.toStdString();
  ASSERT_EQ(desk.Now().fragments.size(), 3U);
  for (const std::size_t n : { 1U, 2U })
  {
    const PlanFragment& piece = desk.Now().fragments[n];
    const auto& source = std::get<PieceSource>(piece.source);
    EXPECT_EQ(source.fragment, bar);
    EXPECT_NEAR(source.seed.x, n == 1 ? 20.0 : -20.0, ClickMm);
    EXPECT_EQ(piece.state, FragmentState::Kept);
  }
  desk.Press("cut.pieces"); // what was not touched is what is missing
  desk.Settle();
  ASSERT_EQ(desk.Now().fragments.size(), 4U) << desk.said.toStdString();
  EXPECT_LT(std::abs(std::get<PieceSource>(desk.Now().fragments[3].source).seed.x), 7.5);
}

} // namespace
