#include "Output/ReportParts.h"

#include "CertificateRead.h"
#include "CertificateTable.h"
#include "PartReport.h"
#include "Planning/PlanLists.h"

#include <optional>
#include <stdexcept>

namespace hasp
{
namespace
{

QString NameOf(PartFormat format)
{
  switch (format)
  {
    case PartFormat::Stl:
      return "STL";
    case PartFormat::ThreeMf:
      return "3MF";
    case PartFormat::Ply:
      return "PLY";
    case PartFormat::Obj:
      return "OBJ";
    default:
      return "NRRD";
  }
}

struct Measured
{
  QString verdict, volume;
  QStringList faults; ///< and warnings
  std::optional<FitCertificate> certificate;
};

Measured ReadMeasured(
  const DerivedPart& part, const std::filesystem::path& blobs, const ReportNaming& of)
{
  if (part.report.empty())
    return { ReportText::tr("not certified"), "–", {}, {} };
  try
  {
    const std::string text = ReadBlob(blobs, part.report);
    const PartReport report = ReadPartReport(text);
    Measured measured{ QString::fromStdString(VerdictOf(report)), Decimal(report.volumeMm3, 1), {},
      CertificateOfReport(text) };
    for (const std::string& fault : report.faults)
      measured.faults.append(QString::fromStdString(fault));
    for (const std::string& line : WarningsOf(report, CalledObject(of.plan, part.object)))
      measured.faults.append(QString::fromStdString(line));
    return measured;
  }
  catch (const std::exception&) // what is damaged is no part's certificate
  {
    return { ReportText::tr("what was measured on it cannot be read: make it again"), "–", {}, {} };
  }
}

ReportTable CertificateRows(
  const FitCertificate& certificate, const QString& part, const QStringList& faults)
{
  ReportTable table{ ReportText::tr("Certificate of %1").arg(part), faults.join("; "),
    { ReportText::tr("measure"), ReportText::tr("measured"), ReportText::tr("must be"),
      ReportText::tr("verdict") },
    {} };
  for (const CertificateRow& row : CertificateTable(certificate))
    table.rows.push_back({ QString::fromStdString(row.measure),
      QString::fromStdString(row.measured), QString::fromStdString(row.limit),
      row.fault           ? ReportText::tr("DOES NOT HOLD")
      : row.limit.empty() ? QString()
      : row.missing       ? ReportText::tr("not measured")
                          : ReportText::tr("holds") });
  return table;
}

} // namespace

std::vector<ReportTable> PartTables(
  const PlanDocument& document, const std::filesystem::path& blobs, const ReportNaming& of)
{
  std::vector<ReportTable> tables{ { ReportText::tr("Parts"),
    ReportText::tr("A part is its file: by the SHA-256 of that it is known again."),
    { ReportText::tr("part"), ReportText::tr("file"), ReportText::tr("verdict"),
      ReportText::tr("volume, mm³"), ReportText::tr("SHA-256") },
    {} } };
  for (const PlanId object : PartObjects(of.plan))
  {
    const QString called = CalledInReport(of, object);
    bool isMade = false;
    for (const PartFormat format :
      { PartFormat::Stl, PartFormat::ThreeMf, PartFormat::Ply, PartFormat::Obj })
    {
      const DerivedPart* part = PartInDate(of.plan, document.parts, object, format);
      if (!part)
        continue;
      const Measured measured = ReadMeasured(*part, blobs, of);
      tables.front().rows.push_back({ called, NameOf(format), measured.verdict, measured.volume,
        QString::fromStdString(part->bytes) });
      if (!isMade && measured.certificate)
        tables.push_back(CertificateRows(*measured.certificate, called, measured.faults));
      isMade = true;
    }
    // Bone is a part only where somebody wants it printed.
    const bool isBone =
      FindPlanObject<PlanFragment>(of.plan, object) || FindPlanObject<PlanGroup>(of.plan, object);
    if (!isMade && !isBone)
      tables.front().rows.push_back({ called, "–",
        QString::fromStdString(WhyNoPart(of.plan, document.parts, object)), "–", "–" });
  }
  return tables;
}

} // namespace hasp
