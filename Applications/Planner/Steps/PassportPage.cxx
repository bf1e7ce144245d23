#include "Steps/PassportPage.h"

#include "Evaluation/MeshCheck.h"

#include "vtkHaspSurfaceFile.h"
#include "vtkHaspVolumeFile.h"

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace hasp
{
namespace
{

/// A table of what is known and lists of sentences below it.
class Page
{
public:
  void Add(const QString& what, const QString& value)
  {
    if (!value.isEmpty())
      this->Rows += QStringLiteral("<tr><td><b>%1</b>&nbsp;</td><td>%2</td></tr>")
                      .arg(what.toHtmlEscaped(), value.toHtmlEscaped());
  }
  void Say(const QString& what, const QString& sentence)
  {
    this->Sentences +=
      QStringLiteral("<p><b>%1</b> %2</p>").arg(what.toHtmlEscaped(), sentence.toHtmlEscaped());
  }
  QString Html() const { return "<table>" + this->Rows + "</table>" + this->Sentences; }

private:
  QString Rows, Sentences;
};

QString Three(const glm::dvec3& v, const QString& between)
{
  return QString::number(v.x) + between + QString::number(v.y) + between + QString::number(v.z);
}

QString Text(const std::string& text)
{
  return QString::fromUtf8(text.data(), int(text.size()));
}

} // namespace

QString PassportPage::FaultText(const std::string& text)
{
  QString said = Text(text);
  said.remove(QStringLiteral(" (--series, or SetSeries)"));
  return said;
}

QString PassportPage::OfFault(const QString& text)
{
  Page page;
  page.Say(tr("Fault:"), text);
  return page.Html();
}

QString PassportPage::Of(const Passport& passport)
{
  Page page;
  const QString times = QStringLiteral(" × ");
  const GridGeometry& grid = passport.geometry;
  page.Add(tr("Format"), Text(passport.format));
  page.Add(tr("Modality"), passport.modality.empty() ? tr("not said") : Text(passport.modality));
  if (grid.dims.x > 0)
  {
    page.Add(tr("Samples"), Three(grid.dims, times) + ", " + Text(passport.sampleType));
    page.Add(tr("Spacing"), tr("%1 mm").arg(Three(grid.spacing, times)));
    page.Add(tr("Size"), tr("%1 mm").arg(Three(glm::dvec3(grid.dims) * grid.spacing, times)));
  }
  if (passport.faults.empty())
    page.Add(
      tr("Values"), (passport.hounsfield ? tr("%1 to %2 HU") : tr("%1 to %2, not said to be HU"))
                      .arg(passport.minimum)
                      .arg(passport.maximum));
  if (passport.seriesFound > 1)
    page.Add(tr("Series"), tr("%1 of %2").arg(passport.seriesChosen).arg(passport.seriesFound));
  if (passport.kvp)
    page.Add(tr("Tube"), tr("%1 kV").arg(*passport.kvp));
  if (passport.thicknessMm)
    page.Add(tr("Slices"), tr("%1 mm thick, as the file says").arg(*passport.thicknessMm));
  if (passport.tiltDegrees > 0.0)
    page.Add(tr("Gantry tilt"), tr("%1°").arg(passport.tiltDegrees, 0, 'f', 2));
  if (passport.filesSkipped > 0)
    page.Add(tr("Skipped"), tr("files that are no images: %1").arg(passport.filesSkipped));
  if (passport.resampled)
  {
    const ResampleRecord& made = *passport.resampled;
    page.Add(tr("Resampled"),
      tr("%1 slices made, %2 measured").arg(made.slicesMade).arg(made.slicesCopied));
    page.Add(tr("Its error"), made.errorKnown
                                ? tr("at most %1 mm at 95 % of edges").arg(made.error95, 0, 'f', 3)
                                : tr("not known: there is nothing to measure it by"));
  }
  page.Add(tr("Hash"), Text(passport.hash.substr(0, 16)));
  for (const std::string& warning : passport.warnings)
    page.Say(tr("Note:"), Text(warning));
  for (const ImportFault& fault : passport.faults)
    page.Say(tr("Fault:"), FaultText(fault.text) + (fault.text.ends_with('.') ? "" : "."));
  return page.Html();
}

QString PassportPage::Of(const SurfacePassport& passport, const MeshCheck& mesh)
{
  Page page;
  page.Add(tr("Format"), Text(passport.format) + ", " + Text(passport.encoding));
  page.Add(
    tr("Space"), passport.space.empty() ? tr("not said, LPS is taken") : Text(passport.space));
  page.Add(tr("Triangles"), QString::number(passport.triangles));
  page.Add(
    tr("Size"), tr("%1 mm").arg(Three(passport.maximum - passport.minimum, QStringLiteral(" × "))));
  page.Add(tr("Closed"), mesh.Closed()
                           ? tr("yes, %1 cm³").arg(mesh.volumeMm3 / 1000.0, 0, 'f', 1)
                           : tr("no, it is a sheet; edges at its holes: %1").arg(mesh.borderEdges));
  if (mesh.pieces > 1)
    page.Add(tr("Pieces"), QString::number(mesh.pieces));
  for (const std::string& warning : passport.warnings)
    page.Say(tr("Note:"), Text(warning));
  return page.Html();
}

} // namespace hasp
