#include "Output/ReportPage.h"

#include <algorithm>

namespace hasp
{
namespace
{

/// Of HTML 4 and CSS 2.1 what Qt's rich text has, too.
constexpr const char* Style = R"(<style>
body { font-family: sans-serif; color: #222222; max-width: 900px }
h1 { font-size: 22px } h2 { font-size: 16px; margin-top: 18px }
td.use { background-color: #a40000; color: #ffffff; font-weight: bold; border: none }
p.note { color: #555555 } p.fault { color: #a40000; font-weight: bold }
th { text-align: left; background-color: #eeeeee } td { border-bottom: 1px solid #dddddd }
td.hash { font-family: monospace; font-size: 11px }
</style>
)";

/// A table, for paragraphs have no room around their text in Qt.
QString UseHtml()
{
  return "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"8\"><tr><td class=\"use\">" +
         IntendedUse().toHtmlEscaped() + "</td></tr></table>\n";
}

constexpr int HashDigits = 64;

bool IsHash(const QString& text)
{
  return text.size() == HashDigits &&
         std::all_of(text.begin(), text.end(),
           [](QChar letter) { return QString("0123456789abcdef").contains(letter); });
}

/// A hash is cut in two, for a page is not that wide.
QString Cell(const QString& text)
{
  if (IsHash(text))
    return "<td class=\"hash\">" + text.left(HashDigits / 2) + "<br/>" + text.mid(HashDigits / 2) +
           "</td>";
  return "<td>" + text.toHtmlEscaped() + "</td>";
}

QString TableHtml(const ReportTable& table)
{
  if (table.rows.empty())
    return {};
  QString html = "<h2>" + table.title.toHtmlEscaped() + "</h2>\n";
  if (!table.note.isEmpty())
    html += "<p class=\"note\">" + table.note.toHtmlEscaped() + "</p>\n";
  html += "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"4\"><tr>";
  for (const QString& column : table.columns)
    html += "<th>" + column.toHtmlEscaped() + "</th>";
  html += "</tr>\n";
  for (const QStringList& row : table.rows)
  {
    html += "<tr>";
    for (const QString& cell : row)
      html += Cell(cell);
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

QString PicturesHtml(const ReportContents& contents, const PictureSource& source)
{
  QString html = "<h2>" + ReportText::tr("Pictures").toHtmlEscaped() + "</h2>\n";
  for (const QString& sentence : contents.missing)
    html += "<p class=\"fault\">" + sentence.toHtmlEscaped() + "</p>\n";
  html += "<table width=\"100%\" cellspacing=\"0\" cellpadding=\"4\">\n";
  for (std::size_t n = 0; n < contents.pictures.size(); ++n)
  {
    const QString caption = contents.pictures[n].caption.toHtmlEscaped();
    html += QString(n % 2 == 0 ? "<tr>" : "") +
            "<td width=\"50%\"><img width=\"320\" height=\"240\" alt=\"" + caption + "\" src=\"" +
            source(n) + "\"/><br/>" + caption + "</td>" +
            (n % 2 == 1 || n + 1 == contents.pictures.size() ? "</tr>\n" : "");
  }
  return contents.pictures.empty() ? html.left(html.lastIndexOf("<table")) : html + "</table>\n";
}

} // namespace

QString IntendedUse()
{
  return ReportText::tr("Research use only, not a medical device. Not for clinical use.");
}

QString ReportHtml(const ReportContents& contents, const PictureSource& source)
{
  const QString title = contents.title.toHtmlEscaped();
  QString html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n<title>" +
                 title + "</title>\n" + Style + "</head><body>\n<h1>" + title + "</h1>\n" +
                 UseHtml();
  for (const QString& sentence : contents.lead)
    html += "<p>" + sentence.toHtmlEscaped() + "</p>\n";
  html += PicturesHtml(contents, source);
  for (const ReportTable& table : contents.tables)
    html += TableHtml(table);
  return html + "<p></p>" + UseHtml() + "</body></html>\n";
}

QByteArray ReportPage(const ReportContents& contents)
{
  return ReportHtml(contents, [&](std::size_t n)
    { return "data:image/png;base64," + QString::fromLatin1(contents.pictures[n].png.toBase64()); })
    .toUtf8();
}

} // namespace hasp
