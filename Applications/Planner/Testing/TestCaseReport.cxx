#include "Output/CaseReport.h"

#include "../../CommandLine/Testing/HaspProcess.h"
#include "CertificateText.h"
#include "OffscreenQt.h"
#include "Output/ReportPage.h"
#include "Output/ReportTables.h"
#include "Planning/PlanEditsFile.h"
#include "vtkHaspHeadlessWindows.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "vtkSphereSource.h"

#include <QImage>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace hasp;
namespace fs = std::filesystem;

namespace
{

constexpr const char* Erika = "Erika"; // whose name no report may say

vtkSmartPointer<vtkPolyData> Ball(const glm::dvec3& at, double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(at.x, at.y, at.z);
  source->SetRadius(radius);
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  source->Update();
  return source->GetOutput();
}

/// The plan of Data/phantom-plan-edits.json: the jaw 2, cuts 3 and 4, its pieces 5, 6 and 7, guide
/// 8 and plate 9; then piece 6 is moved. Its pieces are balls here.
class CaseReport : public HaspTest
{
protected:
  CaseReport()
  {
    unsetenv("DISPLAY"); // pictures as where there is none
    UseHeadlessWindows();
    UseOffscreenQt();
    for (const PlanEdit& edit : ParseEdits(ReadBytes(HASP_PLAN_EDITS)))
      this->document.history.Do(edit);
    const double half = 15.0 * std::acos(-1.0) / 180.0; // of 30 degrees, about the ball's middle
    const glm::dquat turn(std::cos(half), 0.0, 0.0, std::sin(half));
    const glm::dvec3 middle(-35.0, -45.0, -95.0), by(3.0, 4.0, 0.0);
    this->document.history.Do(PoseFragments{ { { 6, { middle + by - turn * middle, turn } } } });
    this->bodies.fragments = { { 5, Ball({ 10.0, -75.0, -95.0 }, 12.0) }, { 6, Ball(middle, 10.0) },
      { 7, Ball({ -20.0, -67.0, -95.0 }, 8.0) } };
    this->bodies.parts = { { 8, Ball({ -25.0, -75.0, -95.0 }, 5.0) } };
    fs::create_directories(this->Blobs());
  }
  fs::path Blobs() const { return this->folder / "plan.hasp"; }
  void Do(const PlanEdit& edit) { this->document.history.Do(edit); }
  /// A guide that was measured; red: it has a fault.
  FitCertificate KeepGuide(bool red = false)
  {
    FitCertificate c;
    c.claims.leastWallMm = 0.71;
    c.claims.slots.push_back({ .widthMm = 1.25, .toleranceMm = 0.1 });
    c.mesh.triangles = 4321;
    c.mesh.pieces = 1;
    c.pieces.resize(1);
    c.selfIntersections = 0;
    c.wall = { 10.5, 0.83, { 1, 2, 3 }, 0.9, 1.0 };
    c.slots.push_back({ 14, 1.24, { 2, 0, 0 }, 1.23, 0.03, 0.04, 0.05, 15.5, 16.5, std::nullopt });
    if (red)
      c.faults.push_back({ FitFaultKind::ThinWall, Erika, glm::dvec3(1, 2, 3) });
    const nlohmann::ordered_json report{ { "triangles", 4321 }, { "volume_mm3", 987.6 },
      { "verdict", red ? "red" : "green" }, { "certificate", CertificateJson(c) } };
    this->KeepPart(8, report.dump());
    return c;
  }
  void KeepPart(PlanId object, const std::string& report)
  {
    this->bytes = WriteBlob(this->Blobs(), std::string("solid ") + Erika);
    this->document.parts.push_back(
      { object, PartFormat::Stl, PartInputs(this->document.history.Current(), object), this->bytes,
        WriteBlob(this->Blobs(), report) });
  }
  /// Without pictures.
  ReportContents Contents(const CaseReportOptions& options = {}) const
  {
    return DescribeCase(this->document, this->Blobs(), this->bodies, {}, {}, options);
  }
  ReportContents ContentsWithPictures() const
  {
    return DescribeCase(this->document, this->Blobs(), this->bodies,
      DrawReport(this->document.history.Current(), this->bodies), {});
  }
  /// The rows of the table with that title; none: no such table.
  std::vector<QStringList> Rows(const QString& title) const
  {
    for (const ReportTable& table : this->Contents().tables)
      if (table.title == title)
        return table.rows;
    return {};
  }
  QStringList RowOf(const QString& title, const QString& first) const
  {
    for (const QStringList& row : this->Rows(title))
      if (row.front() == first)
        return row;
    return {};
  }

  PlanDocument document;
  ReportBodies bodies;
  std::string bytes; ///< of the part's file: their hash
};

void ExpectWellFormed(const QByteArray& page)
{
  QXmlStreamReader reader(page);
  while (!reader.atEnd())
    reader.readNext();
  EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString() << " in line "
                                  << reader.lineNumber();
}

TEST_F(CaseReport, WhereItCannotBeWrittenNothingIsAndNoPathIsSaid)
{
  const fs::path html = this->folder / "none" / "report.html";
  try
  {
    SaveReport(this->Contents(), html);
    FAIL() << "its folder is not there";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_EQ(std::string(error.what()).find(this->folder.string()), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(html.parent_path()));
}

TEST_F(CaseReport, DamagedMeasurementsAreSaidToBeMissing)
{
  this->KeepPart(8, std::string("{\"verdict\":\"") + Erika + "\"}");
  const QStringList row = this->RowOf("Parts", "guide 8");
  ASSERT_EQ(row.size(), 5);
  EXPECT_TRUE(row[2].contains("make it again")) << row[2].toStdString();
  EXPECT_EQ(ReportPage(this->Contents()).indexOf(Erika), -1);
}

TEST_F(CaseReport, EqualPlansHaveEqualReports)
{
  this->KeepGuide();
  SaveReport(this->ContentsWithPictures(), this->folder / "a.html");
  SaveReport(this->ContentsWithPictures(), this->folder / "b.html");
  for (const char* ending : { ".html", ".pdf" })
  {
    const std::string a = ReadBytes(this->Path(std::string("a") + ending));
    EXPECT_GT(a.size(), 10'000U) << ending;
    EXPECT_EQ(a, ReadBytes(this->Path(std::string("b") + ending))) << ending;
  }
  EXPECT_EQ(ReadBytes(this->Path("a.html")).find("Date:"), std::string::npos);
  const QByteArray dated = ReportPage(this->Contents({ false, "1 May 2031" }));
  EXPECT_NE(dated.indexOf("1 May 2031"), -1);
  this->Do(SetCaseLabel{ "case 7" });
  SaveReport(this->Contents(), this->folder / "c.html");
  for (const char* ending : { ".html", ".pdf" })
    EXPECT_NE(ReadBytes(this->Path(std::string("a") + ending)),
      ReadBytes(this->Path(std::string("c") + ending)))
      << ending;
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

TEST_F(CaseReport, IsWellFormedWhateverTheCaseIsCalled)
{
  const QString label = QString::fromUtf8("<b>&\"A'</b> Ähre");
  this->KeepGuide();
  this->Do(SetCaseLabel{ label.toStdString() });
  ReportContents contents = this->Contents();
  contents.pictures.resize(3, { label, "no picture" });
  const QByteArray page = ReportPage(contents);
  ExpectWellFormed(page);
  EXPECT_NE(page.indexOf(("<h1>Case report: " + label.toHtmlEscaped() + "</h1>").toUtf8()), -1);
  EXPECT_EQ(page.count("Research use only, not a medical device. Not for clinical use."), 2);
  for (const char* forbidden : { "<script", "http:", "https:", "file:/" })
    EXPECT_EQ(page.indexOf(forbidden), -1) << forbidden;
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

TEST_F(CaseReport, PicturesShowTheBoneFromFourSidesBeforeAndAfter)
{
  const ReportContents contents = this->ContentsWithPictures();
  ASSERT_EQ(contents.pictures.size(), 8U);
  std::vector<QByteArray> seen;
  for (const ReportPicture& picture : contents.pictures)
  {
    for (const char* chunk : { "tEXt", "iTXt", "zTXt", "tIME", "eXIf" })
      EXPECT_EQ(picture.png.indexOf(chunk), -1) << chunk;
    const QImage image = QImage::fromData(picture.png, "PNG");
    ASSERT_EQ(image.size(), QSize(800, 600));
    EXPECT_EQ(qRed(image.pixel(2, 2)), 255); // paper
    int ink = 0;
    for (int y = 0; y < image.height(); y += 4)
      for (int x = 0; x < image.width(); x += 4)
        ink += qGray(image.pixel(x, y)) < 250 ? 1 : 0;
    EXPECT_GT(ink, 1000) << picture.caption.toStdString(); // of 30,000
    EXPECT_EQ(std::count(seen.begin(), seen.end(), picture.png), 0);
    seen.push_back(picture.png);
  }
  this->bodies = {};
  EXPECT_TRUE(this->ContentsWithPictures().pictures.empty()) << "of nothing";
}

TEST_F(CaseReport, ThePdfHasPagesAndNoDate)
{
  this->KeepGuide();
  const QByteArray pdf = ReportPdf(this->ContentsWithPictures());
  EXPECT_TRUE(pdf.startsWith("%PDF-1."));
  EXPECT_TRUE(pdf.trimmed().endsWith("%%EOF"));
  EXPECT_GE(pdf.count("/Type /Page\n"), 2); // eight pictures and the tables are more than one
  EXPECT_EQ(pdf.indexOf("Date ("), -1);
  // And each object is still where the file's table says.
  const int start = pdf.lastIndexOf("startxref\n") + 10;
  const QByteArray table = pdf.mid(pdf.mid(start, pdf.indexOf('\n', start) - start).toInt());
  ASSERT_TRUE(table.startsWith("xref\n0 "));
  const QList<QByteArray> lines = table.split('\n');
  const int objects = lines[1].split(' ')[1].toInt();
  ASSERT_GT(objects, 10);
  for (int n = 1; n < objects; ++n)
    if (const QByteArray entry = lines[n + 2]; entry.contains(" n"))
    {
      const QByteArray begin = QByteArray::number(n) + " 0 obj";
      EXPECT_EQ(pdf.mid(entry.left(10).toInt(), begin.size()), begin);
    }
}

} // namespace
