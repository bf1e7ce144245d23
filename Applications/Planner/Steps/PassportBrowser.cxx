#include "Steps/PassportBrowser.h"

#include "Steps/PassportPage.h"
#include "Tools/Planner.h"

namespace hasp
{

PassportBrowser::PassportBrowser(Planner& planner, QWidget* parent)
  : QTextBrowser(parent),
    Of(planner)
{
  this->setObjectName("import.passport");
  this->setAccessibleName(tr("What is known of what was imported"));
  connect(&planner.plan, &PlanSession::Replaced, this, [this] { this->SetAbove({}); });
  connect(&planner.plan, &PlanSession::Changed, this, &PassportBrowser::Refresh);
  connect(&planner.scans, &ScanShelf::Added, this, &PassportBrowser::Refresh);
  connect(&planner.scene, &PlanScene::PropsChanged, this, &PassportBrowser::Refresh);
  this->Refresh();
}

void PassportBrowser::SetAbove(const QString& html)
{
  this->Above = html;
  this->Refresh();
}

void PassportBrowser::Refresh()
{
  const ShelfScan* scan =
    this->Of.scans.OfVolume(this->Of.plan.Now(), this->Of.scene.ShownVolume());
  QString html = this->Above;
  if (scan && !html.isEmpty())
    html += "<hr><p>" + tr("The scan that is shown:") + "</p>";
  if (scan)
    html += PassportPage::Of(scan->passport);
  if (html == this->Now)
    return; // it may have been scrolled
  this->Now = html;
  this->setHtml(html);
}

} // namespace hasp
