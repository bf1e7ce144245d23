// What a report says.
#include "CaseReportFixture.h"

#include "Output/ReportPage.h"
#include "Output/ReportTables.h"

namespace
{

TEST_F(CaseReport, DamagedMeasurementsAreSaidToBeMissing)
{
  this->KeepPart(8, std::string("{\"verdict\":\"") + Erika + "\"}");
  const QStringList row = this->RowOf("Parts", "guide 8");
  ASSERT_EQ(row.size(), 5);
  EXPECT_TRUE(row[2].contains("make it again")) << row[2].toStdString();
  EXPECT_EQ(ReportPage(this->Contents()).indexOf(Erika), -1);
}

TEST_F(CaseReport, NamesAreForWhoAsks)
{
  this->KeepGuide(true);
  this->Do(RenameObject{ 1, std::string("scan of ") + Erika });
  this->Do(RenameObject{ 6, std::string("ramus of ") + Erika });
  EXPECT_EQ(ReportPage(this->Contents()).indexOf(Erika), -1);
  const QByteArray named = ReportPage(this->Contents({ true, {} }));
  EXPECT_NE(named.indexOf("fragment 6 (ramus of Erika)"), -1);
  EXPECT_EQ(named.indexOf("scan of"), -1) << "a scan's name may be a file's";
  EXPECT_EQ(named.indexOf(this->folder.filename().string().c_str()), -1);
}

TEST_F(CaseReport, FragmentsMoveAsPlanned)
{
  const QStringList moved = this->RowOf("Fragments", "fragment 6");
  ASSERT_EQ(moved.size(), 5);
  EXPECT_EQ(moved[1], "a piece of fragment 2");
  EXPECT_EQ(moved[2], "kept");
  EXPECT_EQ(moved[3], "5.00 mm: 3.00 L, 4.00 P");
  EXPECT_EQ(moved[4], QString::fromUtf8("30.00° about (0.000, 0.000, 1.000)"));
  EXPECT_EQ(this->RowOf("Fragments", "fragment 5")[3], "not moved");
  EXPECT_EQ(this->RowOf("Fragments", "fragment 2")[2], "cut into pieces");
  EXPECT_EQ(this->RowOf("Fragments", "fragment 7")[2], "resected");
  this->bodies.fragments.clear(); // its scan is not there: the place that it was picked at moves
  const glm::dvec3 seed(-35.5, -43.5, -96.0);
  const PlanPose& pose = this->document.history.Current().fragments[2].scanToPlanned;
  EXPECT_TRUE(this->RowOf("Fragments", "fragment 6")[3].startsWith(
    Decimal(glm::length(pose.Place(seed) - seed), 2)));
}

TEST_F(CaseReport, CutsHaveTheirPlacesAndAngles)
{
  const QStringList cut = this->RowOf("Cuts", "cut 3"); // normal (0.8985, -0.439, 0)
  ASSERT_EQ(cut.size(), 8);
  EXPECT_EQ(cut[1], "fragment 2");
  EXPECT_EQ(cut[2], "(-9.66, -77.77, -96.00)");
  EXPECT_EQ(cut[3], QString::fromUtf8("90.0°"));
  EXPECT_EQ(cut[4], QString::fromUtf8("64.0°")); // acos 0.439
  EXPECT_EQ(cut[5], QString::fromUtf8("26.0°")); // acos 0.8985
  EXPECT_EQ(cut[6], QString::fromUtf8("50.0 × 60.0"));
  EXPECT_EQ(cut[7], "1.00");
}

TEST_F(CaseReport, MeasuresAreThoseOfThePlanAndOfTheScan)
{
  const PlanId id = this->document.history.NewId();
  PlanMeasure measure{ id, "", MeasureKind::Distance,
    { { 6, { -35.0, -45.0, -95.0 } }, { 0, { -35.0, -45.0, -105.0 } } } };
  this->Do(AddObject<PlanMeasure>{ measure });
  const QStringList row = this->RowOf("Measures", QString("measure %1").arg(id));
  ASSERT_EQ(row.size(), 4);
  EXPECT_EQ(row[1], "11.18 mm"); // sqrt(5^2 + 10^2)
  EXPECT_EQ(row[2], "10.00 mm");
  EXPECT_EQ(row[3], "1.18 mm");
}

TEST_F(CaseReport, PartsHaveTheirVerdictsFiguresAndHashes)
{
  EXPECT_EQ(this->RowOf("Parts", "guide 8")[2], "guide 8 has not been made");
  this->KeepGuide();
  const QStringList row = this->RowOf("Parts", "guide 8");
  ASSERT_EQ(row.size(), 5);
  EXPECT_EQ(row[1], "STL");
  EXPECT_EQ(row[2], "green");
  EXPECT_EQ(row[3], "987.6");
  EXPECT_EQ(row[4].toStdString(), this->bytes);
  EXPECT_TRUE(this->RowOf("Certificate of guide 8", "thinnest wall")[1].startsWith("0.83 mm"));
  EXPECT_TRUE(this->RowOf("Certificate of guide 8", "slots[0]")[1].startsWith("1.230 mm wide"));
  EXPECT_EQ(this->RowOf("Certificate of guide 8", "slots[0]")[3], "holds");
  this->KeepGuide(true);
  EXPECT_EQ(this->RowOf("Parts", "guide 8")[2], "red");
  EXPECT_EQ(this->RowOf("Certificate of guide 8", "thinnest wall")[3], "holds");
  const std::string page = ReportPage(this->Contents()).toStdString();
  EXPECT_NE(page.find("a wall is too thin at (1.0, 2.0, 3.0) mm"), std::string::npos);
  PlanCut cut = this->document.history.Current().cuts[0];
  cut.blade.kerfMm = 1.2;
  this->Do(ChangeObject<PlanCut>{ cut });
  EXPECT_EQ(this->RowOf("Parts", "guide 8")[2], "guide 8 is out of date: cut 3 has changed");
}

TEST_F(CaseReport, HasEveryHashAndVersion)
{
  const Plan& plan = this->document.history.Current();
  const std::string page = ReportPage(this->Contents()).toStdString();
  EXPECT_NE(page.find(PlanHash(plan)), std::string::npos);
  EXPECT_NE(page.find(plan.volumes[0].hash.substr(0, 32)), std::string::npos);
  EXPECT_NE(page.find(plan.volumes[0].hash.substr(32)), std::string::npos);
  for (const char* program : { "hasp-planner", "VTK", "Qt", "OpenGL" })
    EXPECT_EQ(this->RowOf("Program", program).size(), 2) << program;
  EXPECT_EQ(this->RowOf("Program", "Qt")[1], qVersion());
}

} // namespace
