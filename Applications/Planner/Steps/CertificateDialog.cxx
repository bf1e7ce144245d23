#include "Steps/CertificateDialog.h"

#include "CertificatePage.h"
#include "Failure.h"
#include "Files.h"
#include "PartReport.h"
#include "Steps/FileQuestion.h"
#include "Steps/PanelWidgets.h"
#include "Tools/Planner.h"

#include "Planning/Sha256.h"

#include <QPushButton>
#include <QRegularExpression>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <exception>

namespace hasp
{
namespace
{

std::string PageOf(const PartFacts& facts)
{
  CertificatePage page;
  page.partHash = facts.stl;
  const std::string recipe = RecipeOfReport(facts.report);
  page.recipeHash = recipe.empty() ? "" : Sha256(recipe);
  page.noPictures = CertificateDialog::tr("the planner's views show the part").toStdString();
  if (facts.state == PartState::DoesNotHold)
    page.fate = CertificateDialog::tr("The part was not kept.").toStdString();
  if (facts.heldTo != 0)
    page.fate += CertificateDialog::tr(
      " It was held to fragment %1 alone: other bone of the scan was not looked at.")
                   .arg(facts.heldTo)
                   .toStdString();
  return CertificateHtml(*facts.certificate, page);
}

/// Qt's texts know no SVG, and would show its words.
QString WithoutDrawings(const std::string& html)
{
  static const QRegularExpression drawing(
    QStringLiteral("<svg.*?</svg>"), QRegularExpression::DotMatchesEverythingOption);
  return QString::fromStdString(html).remove(drawing);
}

} // namespace

CertificateDialog::CertificateDialog(Planner& planner, const PartFacts& facts, QWidget* parent)
  : QDialog(parent),
    Of(planner),
    Called(facts.called),
    Html(PageOf(facts))
{
  this->setWindowTitle(tr("Certificate of %1").arg(facts.called));
  this->resize(900, 700);
  auto* layout = new QVBoxLayout(this);
  auto* text = new QTextBrowser;
  text->setObjectName("check.page.text");
  text->setOpenLinks(false);
  text->setHtml(WithoutDrawings(this->Html));
  layout->addWidget(text);
  auto* row = new QHBoxLayout;
  row->addStretch(1);
  QPushButton* save = AddButton(row, "check.page.save", tr("&Save the page…"));
  QPushButton* close = AddButton(row, "check.page.close", tr("&Close"));
  layout->addLayout(row);
  connect(save, &QPushButton::clicked, this, &CertificateDialog::Save);
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
}

void CertificateDialog::Save()
{
  const QString file = AskForNewFile(this, tr("Save the certificate of %1").arg(this->Called),
    tr("certificate.html"), tr("Web pages (*.html)"));
  if (file.isEmpty())
    return;
  try
  {
    RequireWritable(file.toStdString(), { ".html" });
    WriteFile(file.toStdString(), this->Html);
    this->Of.Say(tr("The certificate of %1 is saved.").arg(this->Called));
  }
  catch (const std::exception& error)
  {
    this->Of.SayFault(tr("The certificate is not saved: %1").arg(QString::fromUtf8(error.what())));
  }
}

} // namespace hasp
