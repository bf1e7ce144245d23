#include "Steps/CertificateBox.h"

#include "CertificateTable.h"
#include "Steps/CertificateDialog.h"
#include "Steps/PanelWidgets.h"
#include "Tools/Planner.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <QHeaderView>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace hasp
{
namespace
{

const QColor Green(29, 107, 52), Red(164, 0, 0);

QString VerdictOf(const CertificateRow& row)
{
  if (row.fault)
    return CertificateBox::tr("does not hold");
  if (row.limit.empty())
    return {};
  return row.missing ? CertificateBox::tr("not measured") : CertificateBox::tr("holds");
}

/// Looks at a place as it looks now, only elsewhere.
void LookAt(SceneView& view, const glm::dvec3& place)
{
  vtkCamera* camera = view.Renderer()->GetActiveCamera();
  double from[3], to[3];
  camera->GetPosition(from);
  camera->GetFocalPoint(to);
  camera->SetFocalPoint(place.x, place.y, place.z);
  camera->SetPosition(
    from[0] + place.x - to[0], from[1] + place.y - to[1], from[2] + place.z - to[2]);
  view.Renderer()->ResetCameraClippingRange();
  view.Draw();
}

} // namespace

CertificateBox::CertificateBox(Planner& planner, QWidget* parent)
  : QGroupBox(tr("Certificate"), parent),
    Of(planner),
    Faults(new QListWidget),
    Measures(new QTableWidget(0, 4))
{
  auto* layout = new QVBoxLayout(this);
  this->Faults->setObjectName("check.faults");
  this->Faults->setAccessibleName(tr("Faults of the part"));
  this->Faults->setWordWrap(true);
  this->Faults->setMaximumHeight(6 * this->fontMetrics().lineSpacing());
  layout->addWidget(this->Faults);
  this->Place = AddButton(layout, "check.show", tr("Sho&w the fault's place"));
  this->Measures->setObjectName("check.measures");
  this->Measures->setAccessibleName(tr("What was measured"));
  this->Measures->setHorizontalHeaderLabels(
    { tr("Measure"), tr("Measured"), tr("Must be"), QString() });
  this->Measures->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Measures->setTabKeyNavigation(false);
  this->Measures->verticalHeader()->hide();
  // A panel is narrow: long cells go on in the next line.
  this->Measures->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  this->Measures->horizontalHeader()->setSectionResizeMode(3, QHeaderView::ResizeToContents);
  layout->addWidget(this->Measures);
  this->Page = AddButton(layout, "check.page", tr("Open the certificate's &page"));
  connect(this->Faults, &QListWidget::currentRowChanged, this,
    [this](int row)
    {
      this->Place->setEnabled(row >= 0 && this->Shown && this->Shown->certificate &&
                              row < int(this->Shown->certificate->faults.size()) &&
                              this->Shown->certificate->faults[std::size_t(row)].at);
      Q_EMIT this->FaultChosen(row);
    });
  connect(this->Faults, &QListWidget::itemActivated, this, &CertificateBox::ShowPlace);
  connect(this->Place, &QPushButton::clicked, this, &CertificateBox::ShowPlace);
  connect(this->Page, &QPushButton::clicked, this, &CertificateBox::OpenPage);
  this->Show(nullptr);
}

void CertificateBox::Show(const PartFacts* facts)
{
  const int row =
    this->Shown && facts && this->Shown->object == facts->object ? this->Faults->currentRow() : 0;
  this->Shown = facts ? std::optional<PartFacts>(*facts) : std::nullopt;
  this->setTitle(facts ? tr("Certificate of %1").arg(facts->called) : tr("Certificate"));
  this->Faults->clear();
  this->Measures->setRowCount(0);
  const bool measured = facts && facts->certificate;
  this->Page->setEnabled(measured);
  if (facts)
    this->Faults->addItems(facts->faults);
  this->Faults->setVisible(facts && !facts->faults.isEmpty());
  this->Place->setVisible(this->Faults->isVisibleTo(this));
  this->Faults->setCurrentRow(facts && row < facts->faults.size() ? row : -1);
  if (!measured)
    return;
  for (const CertificateRow& line : CertificateTable(*facts->certificate))
  {
    const int at = this->Measures->rowCount();
    this->Measures->insertRow(at);
    const QString cells[] = { QString::fromStdString(line.measure),
      QString::fromStdString(line.measured), QString::fromStdString(line.limit), VerdictOf(line) };
    for (int column = 0; column < 4; ++column)
      this->Measures->setItem(at, column, new QTableWidgetItem(cells[column]));
    if (!cells[3].isEmpty() && !line.missing)
      this->Measures->item(at, 3)->setForeground(line.fault ? Red : Green);
  }
  this->Measures->resizeRowsToContents();
}

void CertificateBox::ShowPlace()
{
  const int row = this->Faults->currentRow();
  if (row < 0 || !this->Shown || !this->Shown->certificate ||
      row >= int(this->Shown->certificate->faults.size()))
    return;
  const auto& at = this->Shown->certificate->faults[std::size_t(row)].at;
  if (!at)
    return;
  this->Of.views.SetCrosshair(*at);
  LookAt(this->Of.views.Scene(), *at);
}

void CertificateBox::OpenPage()
{
  if (!this->Shown)
    return;
  auto* dialog = new CertificateDialog(this->Of, *this->Shown, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

} // namespace hasp
