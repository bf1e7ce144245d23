#include "CertificatePage.h"

#include "CertificateTable.h"
#include "CertificateText.h"
#include "GapColours.h"
#include "ReportChart.h"
#include "Version.h"

#include <cstdint>
#include <string_view>

namespace hasp
{
namespace
{

constexpr const char* Style = R"(<style>
body { font: 15px/1.5 system-ui, sans-serif; max-width: 68em; margin: 2em auto; padding: 0 1em; color: #222 }
table { border-collapse: collapse; width: 100%; margin: 1em 0 } th, td { padding: .3em .6em; text-align: left; border-bottom: 1px solid #ddd }
h1 { padding: .4em .6em; border-radius: .2em; color: #fff } h1.good { background: #1d6b34 } h1.bad { background: #a40000 } h1.unheld { background: #5c5c5c }
td.good { color: #1d6b34 } td.bad { color: #a40000; font-weight: bold } .faint { color: #666 } code { overflow-wrap: anywhere }
figure { display: inline-block; margin: .5em 1em .5em 0; max-width: 640px } figure img { max-width: 100% }
svg { max-width: 640px; font: 12px system-ui, sans-serif; display: block }
</style>
)";

std::string Base64(std::string_view bytes)
{
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(4 * ((bytes.size() + 2) / 3));
  for (std::size_t n = 0; n < bytes.size(); n += 3)
  {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (n + k < bytes.size() ? std::uint8_t(bytes[n + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += n + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string Title(const FitCertificate& c)
{
  std::string verdict = CertificateVerdict(c);
  if (ClaimFit(c.claims) || !c.Holds())
    return "The part " + verdict;
  verdict.front() = 'T';
  return verdict;
}

std::string Verdict(const FitCertificate& c, const CertificatePage& page)
{
  if (c.Holds() && !ClaimFit(c.claims))
    return "<h1 class=\"unheld\">" + Title(c) +
           "</h1>\n<p>It was read back from its file and measured. No recipe says what the part "
           "must be: whether it fits the bone is not known.</p>\n";
  if (c.Holds())
    return "<h1 class=\"good\">" + Title(c) +
           "</h1>\n<p>It was read back from its file and measured: nothing of what it must be is "
           "missing.</p>\n";
  std::string html = "<h1 class=\"bad\">" + Title(c) + "</h1>\n";
  if (!page.fate.empty())
    html += "<p><b>" + EscapeHtml(page.fate) + "</b></p>\n";
  html += "<p>It must not be used, because:</p>\n<ol>\n";
  for (const FitFault& fault : c.faults)
    html += "<li>" + EscapeHtml(fault.text) + "</li>\n";
  return html + "</ol>\n";
}

const char* VerdictCell(const CertificateRow& row)
{
  if (row.fault)
    return "<td class=\"bad\">does not hold</td>";
  if (row.limit.empty())
    return "<td></td>";
  return row.missing ? "<td class=\"faint\">not measured</td>" : "<td class=\"good\">holds</td>";
}

std::string Measures(const FitCertificate& c)
{
  std::string html = "<h2>What was measured</h2>\n<table><tr><th>measure</th><th>measured</th>"
                     "<th>must be</th><th></th></tr>\n";
  for (const CertificateRow& row : CertificateTable(c))
    html += "<tr><td>" + EscapeHtml(row.measure) + "</td><td>" + EscapeHtml(row.measured) +
            "</td><td>" + EscapeHtml(row.limit) + "</td>" + VerdictCell(row) + "</tr>\n";
  html += "</table>\n";
  if (!ClaimFit(c.claims))
    html += "<p>There was no recipe to hold the part to: no gap, slot or hole was looked "
            "for.</p>\n";
  else if (!c.claims.shell)
    html += "<p>The gap to the bone is not claimed of such a part, and was not measured.</p>\n";
  return html;
}

std::string Histogram(const FitCertificate& c)
{
  if (!c.gap || !c.claims.shell)
    return "";
  return "<h2>The gap to the bone</h2>\n" + GapHistogramSvg(*c.gap, *c.claims.shell);
}

std::string Pictures(const FitCertificate& c, const CertificatePage& page)
{
  std::string html = "<h2>Pictures</h2>\n";
  if (page.pictures.empty())
    return html + "<p>There are none: " + EscapeHtml(page.noPictures) + ".</p>\n";
  if (!c.Holds())
    html +=
      "<p>Red balls are faults, by their numbers above; they are drawn in front of what hides "
      "them.</p>\n";
  for (const CertificatePicture& picture : page.pictures)
    html += "<figure><img alt=\"" + EscapeHtml(picture.caption) +
            "\" src=\"data:image/png;base64," + Base64(picture.png) + "\">" +
            (picture.ofGap && c.claims.shell ? GapScaleSvg(*c.claims.shell) : "") + "<figcaption>" +
            EscapeHtml(picture.caption) + "</figcaption></figure>\n";
  return html;
}

std::string Hash(const char* what, const std::string& hash, const char* without)
{
  return std::string("<tr><td>") + what + "</td><td>" +
         (hash.empty() ? without : "SHA-256 <code>" + hash + "</code>") + "</td></tr>\n";
}

std::string Origin(const FitCertificate& c, const CertificatePage& page)
{
  char isovalue[40];
  std::snprintf(isovalue, sizeof isovalue, "%g", c.claims.isovalue);
  return std::string("<h2>What was held to what</h2>\n<table>") +
         Hash("part", page.partHash, "not hashed: this build has no OpenSSL") +
         Hash("recipe", page.recipeHash, "none given, or not hashed: this build has no OpenSSL") +
         "<tr><td>bone</td><td>where the scan is at or above " + isovalue +
         "; places are patient LPS, mm</td></tr>\n<tr><td>program</td><td>hasp " + Version() +
         ", commit " + EscapeHtml(Commit()) + "</td></tr>\n<tr><td>licence</td><td>" +
#if HASP_WITH_CGAL
         "CGAL (GPL) is in this program: it finds triangles that meet" +
#else
         "CGAL (GPL) is not in this program: triangles that meet are not looked for" +
#endif
         "</td></tr>\n</table>\n<p><b>Research use only, not a medical device.</b></p>\n";
}

} // namespace

std::string CertificateHtml(const FitCertificate& certificate, const CertificatePage& page)
{
  return std::string("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>") +
         Title(certificate) + "</title>\n" + Style + "</head><body>\n" +
         Verdict(certificate, page) + Measures(certificate) + Histogram(certificate) +
         Pictures(certificate, page) + Origin(certificate, page) + "</body></html>\n";
}

} // namespace hasp
