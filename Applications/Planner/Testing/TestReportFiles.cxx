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
