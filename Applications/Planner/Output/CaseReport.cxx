#include "Output/CaseReport.h"

#include "Output/ReportPage.h"
#include "Output/ReportParts.h"
#include "Output/ReportTables.h"
#include "Output/ReportVoxels.h"
#include "Planning/DurableFile.h"
#include "Planning/PlanLists.h"
#include "Tools/Planner.h"
#include "Version.h"

#include "vtkVersion.h"

#include <QApplication>

#include <exception>

namespace hasp
{
namespace
{

QString Title(const Plan& plan)
{
  return plan.caseLabel.empty()
           ? ReportText::tr("Case report")
           : ReportText::tr("Case report: %1").arg(QString::fromStdString(plan.caseLabel));
}

QStringList Lead(const Plan& plan, const CaseReportOptions& options)
{
  std::size_t kept = 0, resected = 0, moved = 0;
  for (const PlanFragment& fragment : plan.fragments)
    if (!IsDivided(plan, fragment.id))
    {
      const bool isKept = fragment.state == FragmentState::Kept;
      ++(isKept ? kept : resected);
      moved += isKept && !(fragment.scanToPlanned == PlanPose{}) ? 1 : 0;
    }
  QStringList lead{ ReportText::tr(
                      "Planned: kept fragments: %1, of them moved: %2; resected: %3; cuts: "
                      "%4; guides: %5; plates: %6; implants: %7; transplants: %8.")
                      .arg(kept)
                      .arg(moved)
                      .arg(resected)
                      .arg(plan.cuts.size())
                      .arg(plan.guides.size() + plan.mitreGuides.size())
                      .arg(plan.plates.size())
                      .arg(plan.implants.size())
                      .arg(plan.transplants.size()),
    ReportText::tr("Plan, SHA-256: %1").arg(QString::fromStdString(PlanHash(plan))) };
  if (!options.date.isEmpty())
    lead.append(ReportText::tr("Date: %1").arg(options.date));
  return lead;
}

ReportTable ProgramTable(const QString& renderer)
{
  return {
    ReportText::tr("Program"), {}, { ReportText::tr("what"), ReportText::tr("version") },
    { { "hasp-planner", ReportText::tr("%1, commit %2").arg(Version(), Commit()) },
      { "VTK", vtkVersion::GetVTKVersion() }, { "Qt", qVersion() },
      { "OpenGL", renderer.isEmpty() ? ReportText::tr("none: no pictures are drawn") : renderer } }
  };
}

/// The waiting pointer, while it lives.
struct Waiting
{
  Waiting() { QApplication::setOverrideCursor(Qt::WaitCursor); }
  ~Waiting() { QApplication::restoreOverrideCursor(); }
};

} // namespace

ReportContents DescribeCase(const PlanDocument& document, const std::filesystem::path& blobs,
  const ReportBodies& bodies, ReportDrawing drawing, const QStringList& missing,
  const CaseReportOptions& options)
{
  const Plan& plan = document.history.Current();
  const ReportNaming naming{ plan, options.names };
  std::map<PlanId, glm::dvec3> middles;
  for (const auto& [id, surface] : bodies.fragments)
    if (const auto middle = MiddleOf(surface))
      middles[id] = *middle;
  ReportContents contents{ Title(plan), Lead(plan, options), {}, std::move(drawing.pictures),
    missing };
  if (drawing.renderer.isEmpty())
    contents.missing.append(
      ReportText::tr("There are no pictures: OpenGL 3.2 or later is needed."));
  contents.tables = { FragmentTable(naming, middles), GroupTable(naming), CutTable(naming),
    MeasureTable(naming) };
  for (ReportTable& table : PartTables(document, blobs, naming))
    contents.tables.push_back(std::move(table));
  contents.tables.push_back(SourceTable(plan));
  contents.tables.push_back(ProgramTable(drawing.renderer));
  return contents;
}

void SaveReport(const ReportContents& contents, const std::filesystem::path& html)
{
  const QByteArray page = ReportPage(contents), pdf = ReportPdf(contents);
  std::filesystem::path beside = html, place = html;
  beside.replace_extension(".pdf");
  if (beside == place) // it was named as the PDF is
    place.replace_extension(".html");
  WriteDurably(beside, { pdf.constData(), std::size_t(pdf.size()) }, "the report's PDF");
  WriteDurably(place, { page.constData(), std::size_t(page.size()) }, "the report's page");
}

bool WriteCaseReport(
  Planner& planner, const std::filesystem::path& html, const CaseReportOptions& options)
{
  try
  {
    const Waiting waiting;
    QStringList missing;
    const ReportBodies bodies = BodiesOf(planner, missing);
    SaveReport(DescribeCase(planner.plan.Document(), planner.plan.Folder(), bodies,
                 DrawReport(planner.plan.Now(), bodies), missing, options),
      html);
  }
  catch (const std::exception& error)
  {
    planner.SayFault(
      ReportText::tr("The report is not written: %1. Choose a folder that can be written, "
                     "or make room on its disk.")
        .arg(QString::fromUtf8(error.what())));
    return false;
  }
  planner.Say(ReportText::tr("The report is written, as a page and as a PDF beside it."));
  return true;
}

} // namespace hasp
