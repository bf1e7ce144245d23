// A report as its reader has it: page, PDF and pictures.
#include "CaseReportFixture.h"

#include "Output/ReportPage.h"

#include <QImage>
#include <QXmlStreamReader>

#include <algorithm>
#include <stdexcept>

namespace
{

using ReportFiles = CaseReport;

void ExpectWellFormed(const QByteArray& page)
{
  QXmlStreamReader reader(page);
  while (!reader.atEnd())
    reader.readNext();
  EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString() << " in line "
                                  << reader.lineNumber();
}

TEST_F(ReportFiles, WhereItCannotBeWrittenNothingIsAndNoPathIsSaid)
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

TEST_F(ReportFiles, EqualPlansHaveEqualReports)
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

TEST_F(ReportFiles, IsWellFormedWhateverTheCaseIsCalled)
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

TEST_F(ReportFiles, PicturesShowTheBoneFromFourSidesBeforeAndAfter)
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

TEST_F(ReportFiles, AGuideOnAScanWithoutFragmentsIsSeenOnItsBone)
{
  this->document = {};
  this->Do(AddObject<PlanVolume>{ { 1, "", std::string(64, 'a') } });
  PlanGuide guide{ 2, "", 1, {}, {}, BodySide::None };
  guide.recipe.landmarks = { { -4, -20, 0 }, { 4, -20, 0 } };
  this->Do(AddObject<PlanGuide>{ guide });
  this->bodies = { {}, { { 2, Ball({ 0, -20, 0 }, 4.0) } }, { { 1, Ball({ 0, 0, 0 }, 20.0) } } };
  const ReportContents contents = this->ContentsWithPictures();
  ASSERT_EQ(contents.pictures.size(), 8U);
  const QImage before = QImage::fromData(contents.pictures[0].png, "PNG");
  int bone = 0, blue = 0; // which the guide is
  for (int y = 0; y < before.height(); ++y)
    for (int x = 0; x < before.width(); ++x)
    {
      const QRgb at = before.pixel(x, y);
      bone += qRed(at) > qBlue(at) + 5 ? 1 : 0;
      blue += qBlue(at) > qRed(at) + 20 ? 1 : 0;
    }
  EXPECT_GT(blue, 1000);
  EXPECT_GT(bone, 10 * blue);
}

/// Data/phantom-transplant-edits.json: the jaw's scan 1 with cuts 4 and 5, stumps 6 and 7, chin 8
/// and transplant 10; the donor's scan 2 with the fibula 9 and mitre guide 11.
TEST_F(ReportFiles, EachPictureShowsOneScan)
{
  this->document = {};
  const fs::path edits = fs::path(HASP_PLAN_EDITS).parent_path() / "phantom-transplant-edits.json";
  for (const PlanEdit& edit : ParseEdits(ReadBytes(edits.string())))
    this->Do(edit);
  this->bodies = { { { 6, Ball({ -35, -45, -95 }, 10.0) }, { 7, Ball({ 35, -45, -95 }, 10.0) },
                     { 8, Ball({ -13, -75, -95 }, 8.0) }, { 9, Ball({ 0, 0, -20 }, 40.0) } },
    { { 10, Ball({ -13, -75, -95 }, 6.0) }, { 11, Ball({ 0, -40, -20 }, 5.0) } }, {} };
  const ReportBodies all = this->bodies;
  const auto pictures = [this](std::initializer_list<PlanId> without)
  {
    for (const PlanId id : without)
    {
      this->bodies.fragments.erase(id);
      this->bodies.parts.erase(id);
    }
    return this->ContentsWithPictures().pictures;
  };
  const std::vector<ReportPicture> both = pictures({}), jaw = pictures({ 9, 11 });
  this->bodies = all;
  const std::vector<ReportPicture> leg = pictures({ 6, 7, 8, 10 });
  ASSERT_EQ(jaw.size(), 8U);
  ASSERT_EQ(leg.size(), 4U);
  ASSERT_EQ(both.size(), 12U);
  for (std::size_t n = 0; n < 12; ++n)
  {
    const ReportPicture& alone = n < 8 ? jaw[n] : leg[n - 8];
    EXPECT_TRUE(both[n].png == alone.png) << both[n].caption.toStdString();
    EXPECT_EQ(both[n].caption, alone.caption);
  }
  EXPECT_EQ(
    both[0].caption, "Cuts and guides on the bone as it was scanned, volume 1, from the front.");
  EXPECT_EQ(both[4].caption, "As planned, volume 1, from the front.");
  EXPECT_EQ(both[8].caption,
    "Cuts and guides on the bone as it was scanned, volume 2, the donor's, from the front.");
}

TEST_F(ReportFiles, ThePdfHasPagesAndNoDate)
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
