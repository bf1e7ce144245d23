#include "Output/ReportPage.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QHash>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>

namespace hasp
{
namespace
{

constexpr int Dpi = 96; // of layout; text and pictures keep their own
constexpr double MarginMm = 15.0, FootMm = 10.0;
constexpr double PixelsPerMm = Dpi / 25.4;

QString Address(std::size_t n)
{
  return "picture:" + QString::number(n);
}

/// Qt numbers a file's fonts in the order in which a hash table has them, which is another one in
/// each process. While this lives new tables have one order.
struct OrderedHashes
{
  OrderedHashes() { qSetGlobalQHashSeed(0); }
  ~OrderedHashes() { qSetGlobalQHashSeed(-1); } // at random
};

constexpr int EntryBytes = 20; // of a PDF's table of where its objects are

/// Takes bytes out of a PDF, and sets right what its table says of all behind them.
void TakeOut(QByteArray& pdf, int from, int count)
{
  pdf.remove(from, count);
  const QByteArray key = "startxref\n";
  const int start = pdf.lastIndexOf(key) + key.size();
  const int digits = pdf.indexOf('\n', start) - start;
  const int table = pdf.mid(start, digits).toInt() - count;
  pdf.replace(start, digits, QByteArray::number(table));
  const int entries = pdf.indexOf('\n', table + 5) + 1; // behind "xref\n0 45\n"
  for (int at = entries; pdf.mid(at + 17, 1) == "n" || pdf.mid(at + 17, 1) == "f"; at += EntryBytes)
    if (const int place = pdf.mid(at, 10).toInt(); place > from)
      pdf.replace(at, 10, QByteArray::number(place - count).rightJustified(10, '0'));
}

/// Qt writes when the file was made, and leaves no way to say that it should not.
void TakeOutDate(QByteArray& pdf)
{
  const int from = pdf.indexOf("/CreationDate ("), to = from < 0 ? -1 : pdf.indexOf(')', from);
  if (to >= 0)
    TakeOut(pdf, from, to + 1 - from);
}

void DrawPage(QPainter& painter, const QTextDocument& document, int page, int pages)
{
  const QSizeF size = document.pageSize();
  painter.save();
  painter.translate(0.0, -page * size.height());
  const QRectF seen(0.0, page * size.height(), size.width(), size.height());
  painter.setClipRect(seen);
  QAbstractTextDocumentLayout::PaintContext context;
  context.clip = seen;
  context.palette.setColor(QPalette::Text, Qt::black);
  document.documentLayout()->draw(&painter, context);
  painter.restore();
  QFont font = document.defaultFont();
  font.setPixelSize(11);
  painter.setFont(font);
  painter.setPen(Qt::darkGray);
  const QRectF foot(0.0, size.height(), size.width(), FootMm * PixelsPerMm);
  painter.drawText(foot, Qt::AlignLeft | Qt::AlignBottom, IntendedUse());
  painter.drawText(foot, Qt::AlignRight | Qt::AlignBottom,
    ReportText::tr("page %1 of %2").arg(page + 1).arg(pages));
}

} // namespace

QByteArray ReportPdf(const ReportContents& contents)
{
  const OrderedHashes ordered;
  QByteArray pdf;
  QBuffer buffer(&pdf);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setResolution(Dpi);
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(MarginMm, MarginMm, MarginMm, MarginMm), QPageLayout::Millimeter);
  writer.setCreator("hasp-planner");
  writer.setTitle(contents.title);
  QTextDocument document;
  QFont font("DejaVu Sans");
  font.setPixelSize(12);
  document.setDefaultFont(font);
  document.setDocumentMargin(0.0);
  for (std::size_t n = 0; n < contents.pictures.size(); ++n)
    document.addResource(QTextDocument::ImageResource, QUrl(Address(n)),
      QImage::fromData(contents.pictures[n].png, "PNG"));
  document.setHtml(ReportHtml(contents, Address));
  document.documentLayout()->setPaintDevice(&writer);
  document.setPageSize(
    QSizeF(writer.width(), writer.height() - FootMm * PixelsPerMm)); // above its foot
  QPainter painter(&writer);
  const int pages = document.pageCount();
  for (int page = 0; page < pages; ++page)
  {
    if (page > 0)
      writer.newPage();
    DrawPage(painter, document, page, pages);
  }
  painter.end();
  buffer.close();
  TakeOutDate(pdf);
  return pdf;
}

} // namespace hasp
