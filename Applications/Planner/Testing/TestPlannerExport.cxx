// The step Export: files and their endings, and what another plan leaves of it.
#include "Output/ReportVoxels.h"
#include "Output/ScanWorlds.h"
#include "Planning/PlanEdits.h"
#include "Steps/ExportPanel.h"
#include "StepsDesk.h"

#include "vtkPolyData.h"

#include <QApplication>
#include <QDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

using namespace hasp;
using namespace hasp::testing;

namespace
{

namespace fs = std::filesystem;

/// Gives dialogs their answers, one after the other: a name for a file, or the name of a button.
/// Without one, and when there is none left, they are cancelled.
class Answers
{
public:
  explicit Answers(QStringList answers) : Left(std::move(answers))
  {
    QObject::connect(&this->Look, &QTimer::timeout, [this] { this->Answer(); });
    this->Look.start(20);
  }
  QStringList asked; ///< the names of buttons that there were

private:
  void Answer()
  {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!dialog || !dialog->isVisible())
      return;
    const QString answer = this->Left.isEmpty() ? QString() : this->Left.takeFirst();
    auto* button = answer.isEmpty() ? nullptr : dialog->findChild<QPushButton*>(answer);
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    if (button)
    {
      this->asked << answer;
      button->click();
    }
    else if (name && !answer.isEmpty())
    {
      name->setText(answer);
      dialog->accept();
    }
    else
      dialog->reject();
  }

  QStringList Left;
  QTimer Look;
};

std::string BytesOf(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

class ExportSteps : public ::testing::Test
{
protected:
  ExportSteps() : desk(ScanOfBar()), panel(this->desk.planner)
  {
    this->desk.Show(&this->panel);
    fs::create_directories(this->folder);
  }
  ~ExportSteps() override { fs::remove_all(this->folder); }
  QString PathOf(const char* name) const
  {
    return QString::fromStdString((this->folder / name).string());
  }

  const fs::path folder =
    fs::path(::testing::TempDir()) / ("export-steps-" + std::to_string(getpid()));
  StepsDesk desk;
  ExportPanel panel;
};

TEST_F(ExportSteps, AReportGetsItsEndingAndAsksBeforeItReplacesAnother)
{
  Answers first({ this->PathOf("report") });
  this->desk.Press("export.report");
  EXPECT_TRUE(first.asked.isEmpty()) << first.asked.join(' ').toStdString();
  EXPECT_FALSE(fs::exists(this->folder / "report"));
  EXPECT_EQ(BytesOf(this->folder / "report.html").substr(0, 9), "<!DOCTYPE");
  EXPECT_EQ(BytesOf(this->folder / "report.pdf").substr(0, 5), "%PDF-");
}

TEST_F(ExportSteps, AFileThatIsThereIsReplacedIfTheUserSaysSo)
{
  for (const char* there : { "page.html", "beside.pdf" }) // either, and it is not lost
  {
    std::ofstream(this->folder / there) << "kept";
    const QString name = this->PathOf(fs::path(there).stem().c_str());
    {
      Answers no({ name, "question.replace.no", this->PathOf("other") });
      this->desk.Press("export.report");
      EXPECT_EQ(no.asked, QStringList{ "question.replace.no" }) << there;
    }
    EXPECT_EQ(BytesOf(this->folder / there), "kept");
    EXPECT_TRUE(fs::exists(this->folder / "other.html")) << there;
    fs::remove(this->folder / "other.html");
    fs::remove(this->folder / "other.pdf");
    Answers yes({ name, "question.replace.yes" });
    this->desk.Press("export.report");
    EXPECT_EQ(yes.asked, QStringList{ "question.replace.yes" }) << there;
    EXPECT_NE(BytesOf(this->folder / there), "kept");
  }
}

TEST_F(ExportSteps, AnotherPlanHasNoFolderAndNoMessageOfTheFormerOne)
{
  QStringList messages; // as the message bar has them
  QObject::connect(&this->desk.planner, &Planner::Said, &this->panel,
    [&](const QString& text, bool) { messages << text; });
  QObject::connect(
    &this->desk.planner, &Planner::Withdrawn, &this->panel, [&] { messages.clear(); });
  auto* line = qobject_cast<QLineEdit*>(this->desk.Find("export.folder"));
  ASSERT_TRUE(line);
  line->setText(this->PathOf("parts"));
  this->desk.planner.SayFault("guide 8 does not hold");
  ASSERT_EQ(messages.size(), 1);
  EXPECT_FALSE(this->desk.planner.plan.Open(this->folder / "none.hasp")); // the plan stays
  EXPECT_EQ(messages.size(), 2);
  EXPECT_FALSE(line->text().isEmpty());
  this->desk.planner.plan.BeginNew();
  EXPECT_TRUE(messages.isEmpty()) << messages.join('\n').toStdString();
  EXPECT_TRUE(line->text().isEmpty());
}

TEST_F(ExportSteps, WhatIsWarnedOfTheNewPlanStays)
{
  QStringList messages;
  QObject::connect(&this->desk.planner, &Planner::Said, &this->panel,
    [&](const QString& text, bool) { messages << text; });
  QObject::connect(
    &this->desk.planner, &Planner::Withdrawn, &this->panel, [&] { messages.clear(); });
  fs::remove_all(this->desk.planner.plan.Folder()); // where its journal is written
  this->desk.planner.plan.BeginNew();
  ASSERT_EQ(messages.size(), 1);
  EXPECT_TRUE(messages[0].contains("not kept against a crash")) << messages[0].toStdString();
}

TEST_F(ExportSteps, AJobsFaultNamesItsObjectOnce)
{
  this->desk.planner.jobs.Add("Making plate 7",
    [](const ProgressFunction&) -> JobQueue::Finish
    { throw std::runtime_error("plate 7: landmarks[1] is 4 mm from bone, must be within 3"); });
  this->desk.Settle();
  EXPECT_EQ(
    this->desk.said, "Making plate 7 failed: landmarks[1] is 4 mm from bone, must be within 3");
  this->desk.planner.jobs.Add("Making group 8",
    [](const ProgressFunction&) -> JobQueue::Finish
    { throw std::runtime_error("fragment 8: there is no bone"); });
  this->desk.Settle();
  EXPECT_EQ(this->desk.said, "Making group 8 failed: fragment 8: there is no bone");
}

TEST_F(ExportSteps, AReportHasTheBoneOfScansThatNoFragmentIsOf)
{
  QStringList missing;
  const auto scans = [&]
  {
    std::vector<PlanId> ids;
    for (const auto& [id, bone] : BodiesOf(this->desk.planner, missing).scans)
    {
      EXPECT_GT(bone->GetNumberOfPoints(), 1000) << id;
      ids.push_back(id);
    }
    return ids;
  };
  EXPECT_EQ(scans(), std::vector<PlanId>{ 1 });
  const PlanId other = this->desk.Add(ScanOfBar());
  EXPECT_EQ(scans(), std::vector<PlanId>{ 1 }); // nothing is on the other
  this->desk.CutBar(0.0);                       // now there is a fragment of the first
  EXPECT_TRUE(scans().empty());
  PlanGuide guide{ this->desk.planner.plan.NewId(), "", other, {}, {}, BodySide::None };
  guide.recipe.landmarks = { Front(-10.0), Front(10.0) };
  ASSERT_TRUE(this->desk.planner.plan.Do(AddObject<PlanGuide>{ guide }));
  EXPECT_EQ(scans(), std::vector<PlanId>{ other });
  const auto points = [&]
  { return BodiesOf(this->desk.planner, missing).scans.at(other)->GetNumberOfPoints(); };
  const vtkIdType asItIsMade = points();
  this->desk.planner.scene.SetShownVolume(other);
  this->desk.planner.scene.SetIsovalue(900.0);
  EXPECT_EQ(points(), asItIsMade) << "the guide's bone is that of its own isovalue";
}

TEST(ScanWorlds, OnlyABoneOfAnotherScanHasAWorldOfItsOwn)
{
  Plan plan;
  plan.volumes = { { 1, "", "" }, { 2, "", "" } };
  for (const auto& [id, volume] : { std::pair<PlanId, PlanId>(3, 1), { 4, 1 }, { 9, 2 } })
  {
    PlanFragment fragment;
    fragment.id = id;
    fragment.source = ComponentSource{ volume, 226.0, {}, 0.5 };
    plan.fragments.push_back(fragment);
  }
  plan.transplants.resize(1);
  plan.transplants[0].id = 11;
  plan.transplants[0].first.fragment = 3;
  plan.transplants[0].donor = 9;
  const std::vector<ScanWorld> two = WorldsOf(plan);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_FALSE(two[0].isDonor);
  EXPECT_TRUE(two[1].isDonor);
  EXPECT_EQ(SeenIn(two[0]), (std::vector<PlanId>{ 3, 4, 11 }));
  EXPECT_EQ(SeenIn(two[1]), std::vector<PlanId>{ 9 });
  plan.transplants[0].donor = 4; // in the jaw's own scan
  EXPECT_FALSE(WorldsOf(plan)[0].isDonor);
}

} // namespace
