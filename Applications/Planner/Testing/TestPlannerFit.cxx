// The test fit: by a push, by hand, and from the Check panel.
#include "PartsDesk.h"

#include "Output/PartFacts.h"
#include "Output/PartFit.h"
#include "Output/PartMaking.h"
#include "Output/PartWork.h"
#include "Steps/CheckPanel.h"
#include "Steps/ExportPanel.h"
#include "Steps/FitBox.h"
#include "Steps/PartTable.h"

#include "Planning/PlanLists.h"

#include "Grid/GridView.h"
#include "vtkHaspVolumeView.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTableWidget>
#include <QTextBrowser>
#include <QtTest>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

using namespace hasp;

namespace
{

std::shared_ptr<const PartOnBone> BodyOf(const Planner& planner, PlanId object)
{
  PartWork work(planner, { object });
  return MakePartOnBone(work, object, {});
}

/// The same with a ball of bone in it.
PartOnBone WithBall(const PartOnBone& body, const glm::dvec3& middle, double radius)
{
  PartOnBone with = body;
  with.bone = std::visit(
    [&]<typename T>(const GridView<const T>& bone)
    {
      std::vector<T> samples(bone.data, bone.data + bone.geometry.Size());
      std::size_t n = 0;
      const glm::ivec3 dims = bone.geometry.dims;
      for (int k = 0; k < dims.z; ++k)
        for (int j = 0; j < dims.y; ++j)
          for (int i = 0; i < dims.x; ++i, ++n)
            if (glm::distance(bone.geometry.IndexToWorld(glm::dvec3(i, j, k)), middle) < radius)
              samples[n] = T(2.0 * body.isovalue);
      return MakeImage(bone.geometry, samples);
    },
    ViewImage(body.bone));
  return with;
}

TEST_F(PlannerParts, SeatWhereTheirCertificateSaysAndNotThroughBone)
{
  MakePart(*this->planner, 8);
  this->Finish();
  const PartFacts facts = FactsOf(*this->planner, 8);
  ASSERT_TRUE(facts.certificate && facts.certificate->gap);
  const auto body = BodyOf(*this->planner, 8);
  const PartSeat free = SeatPart(*body, {});
  EXPECT_TRUE(free.seat.seats);
  EXPECT_TRUE(free.seat.touched);
  // Where the wall looks against the way both are one; the map is sampled 0.5 mm apart, 0.03 of
  // that off on smooth bone, and more where this bone of 1 mm is edged.
  EXPECT_NEAR(free.seat.depthMm, facts.certificate->gap->least, 0.1);
  // Bone in its way, 12 mm before its place: no part of it reaches so far sideways as the ball.
  const glm::dvec3 at = free.seat.partAt + 12.0 * body->withdrawal;
  const PartSeat blocked = SeatPart(WithBall(*body, at, 4.0), {});
  EXPECT_FALSE(blocked.seat.seats);
  ASSERT_TRUE(blocked.seat.touched);
  EXPECT_LT(blocked.seat.depthMm, -5.0);
  EXPECT_LT(glm::distance(blocked.seat.boneAt, at), 5.0);  // on the ball: a voxel of its surface
  EXPECT_THROW(BodyOf(*this->planner, 5), std::exception); // a fragment is put on nothing
}

TEST_F(PlannerParts, AreTriedOnAndPutBackFromTheCheckPanel)
{
  CheckPanel panel(*this->planner, nullptr);
  panel.show();
  panel.Enter();
  const auto button = [&](const char* name)
  {
    auto* found = panel.findChild<QPushButton*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  };
  panel.Parts().Choose(8);
  EXPECT_FALSE(button("check.seat")->isEnabled());
  EXPECT_FALSE(button("check.page")->isEnabled());
  button("check.make")->click();
  this->Finish();
  ASSERT_TRUE(panel.Parts().Chosen());
  EXPECT_EQ(panel.Parts().Chosen()->state, PartState::InDate);
  EXPECT_GT(panel.findChild<QTableWidget*>("check.measures")->rowCount(), 10);
  button("check.page")->click();
  const auto* page = panel.findChild<QTextBrowser*>("check.page.text");
  ASSERT_TRUE(page);
  EXPECT_TRUE(page->toPlainText().contains("The part holds"));
  const PlanDocument before = this->planner->plan.Document();
  button("check.seat")->click();
  this->Finish();
  ASSERT_TRUE(panel.Fit().LastSeat());
  EXPECT_TRUE(panel.Fit().LastSeat()->seats);
  EXPECT_TRUE(panel.findChild<QLabel*>("check.seat.result")->text().contains("guide 8 seats"));
  button("check.fit")->click();
  this->Finish();
  FitTool& tool = panel.Fit().Tool();
  ASSERT_EQ(this->planner->tools.InHand(), &tool);
  EXPECT_NEAR(tool.State().offMm, PartOnBone::LiftMm, 1e-9);
  tool.Show(*panel.Fit().LastSeat());
  EXPECT_NEAR(tool.State().offMm, -panel.Fit().LastSeat()->depthMm, 1e-9);
  button("check.lift")->click();
  EXPECT_NEAR(tool.State().offMm, PartOnBone::LiftMm, 1e-9);
  panel.Leave();
  EXPECT_EQ(this->planner->tools.InHand(), nullptr);
  EXPECT_EQ(this->planner->plan.Document(), before); // nothing of it is an edit
  this->MoveCut(1.0);
  EXPECT_FALSE(panel.Fit().LastSeat());
  EXPECT_FALSE(button("check.seat")->isEnabled());
}

/// At the width of the planner's panel.
void ExpectReadable(const QTableWidget& table)
{
  EXPECT_EQ(table.horizontalScrollBar()->maximum(), 0);
  for (int row = 0; row < table.rowCount(); ++row)
    for (int column = 0; column < table.columnCount(); ++column)
    {
      const QRect cell = table.visualRect(table.model()->index(row, column));
      const QString text = table.item(row, column)->text();
      const QRect words =
        table.fontMetrics().boundingRect(QRect(0, 0, cell.width(), 10'000), Qt::TextWordWrap, text);
      EXPECT_GE(cell.height(), words.height()) << text.toStdString();
      EXPECT_GE(cell.width(), words.width()) << text.toStdString();
    }
}

TEST_F(PlannerParts, WithoutACertificateSayWhyAndWhatToDo)
{
  PlanPlate plate = *FindPlanObject<PlanPlate>(this->planner->plan.Now(), 9);
  plate.volume = 0;
  plate.fragments = { 2 };
  plate.recipe.screws.clear();
  this->Do(ChangeObject<PlanPlate>{ plate });
  CheckPanel panel(*this->planner, nullptr);
  panel.resize(300, 1100);
  panel.show();
  panel.Parts().Choose(9);
  const auto text = [&](const char* name) { return panel.findChild<QLabel*>(name)->text(); };
  EXPECT_EQ(text("check.why"), "plate 9 has not been made.");
  for (const PlanId part : { 8, 9 })
    MakePart(*this->planner, part);
  this->Finish();
  ASSERT_TRUE(panel.Parts().Chosen());
  EXPECT_EQ(panel.Parts().Chosen()->verdict, FitVerdict::NotCertified)
    << this->faults.join(' ').toStdString();
  EXPECT_TRUE(text("check.why").contains("Touch screws")) << text("check.why").toStdString();
  EXPECT_FALSE(panel.findChild<QPushButton*>("check.seat")->isEnabled()); // on what?
  EXPECT_TRUE(text("check.fit.state").contains("cannot be tried"));
  QTest::qWait(100);
  ExpectReadable(panel.Parts()); // guide 8 was held to fragment 2 alone, which is long
}

TEST(SeatText, OfABlockedPartNamesWhatItsStepCanChange)
{
  Plan plan;
  plan.guides.push_back({ .id = 1 });
  plan.plates.push_back({ .id = 2 });
  plan.implants.push_back({ .id = 3 });
  plan.mitreGuides.push_back({ .id = 4 });
  PartSeat push;
  push.seat.touched = true;
  push.seat.depthMm = -3.0;
  const auto text = [&](PlanId object)
  {
    PartFacts facts;
    facts.object = object;
    return SeatText(plan, push, facts);
  };
  EXPECT_TRUE(text(1).contains("the way it lifts off"));
  EXPECT_TRUE(text(2).contains("landmarks")); // it has no way that a user could set
  EXPECT_TRUE(text(3).contains("clearance"));
  EXPECT_TRUE(text(4).contains("beyond the cuts"));
}

TEST_F(PlannerParts, SayInTheExportPanelWhyTheyStay)
{
  ExportPanel panel(*this->planner, nullptr);
  panel.show();
  QCoreApplication::processEvents();
  const auto button = [&](const char* name)
  {
    auto* found = panel.findChild<QPushButton*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  };
  EXPECT_FALSE(button("export.part.8")->isEnabled());
  EXPECT_EQ(panel.findChild<QLabel*>("export.why.8")->text(), "guide 8 has not been made");
  MakeAll(*this->planner);
  this->Finish();
  EXPECT_TRUE(button("export.part.8")->isEnabled());
  EXPECT_FALSE(button("export.all")->isEnabled()); // no folder yet
  panel.findChild<QLineEdit*>("export.folder")->setText(QString::fromStdString(this->Path("out")));
  ASSERT_TRUE(button("export.all")->isEnabled());
  button("export.all")->click();
  this->Finish();
  EXPECT_TRUE(this->Files("out").contains("run.json"));
  this->MoveCut(1.0);
  EXPECT_FALSE(button("export.part.8")->isEnabled());
  EXPECT_FALSE(button("export.all")->isEnabled());
  EXPECT_TRUE(panel.findChild<QLabel*>("export.all.why")->text().contains("cut 3 has changed"));
}

} // namespace
