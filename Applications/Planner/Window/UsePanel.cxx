#include "Window/UsePanel.h"

#include "Tools/Planner.h"

#include "vtkImageData.h"

#include <QHeaderView>
#include <QTimer>

namespace hasp
{
namespace
{
constexpr int BetweenMs = 1000;

QString BytesText(std::size_t bytes)
{
  return bytes >= 1u << 20 ? UsePanel::tr("%1 MiB").arg(double(bytes) / double(1 << 20), 0, 'f', 1)
                           : UsePanel::tr("%1 KiB").arg(double(bytes) / 1024.0, 0, 'f', 1);
}
} // namespace

UsePanel::UsePanel(Planner& planner, QWidget* parent)
  : QTableWidget(parent),
    Of(planner),
    Again(new QTimer(this))
{
  this->setObjectName("use");
  this->setColumnCount(4);
  this->setHorizontalHeaderLabels({ tr("Resource"), tr("Bytes"), tr("ms"), tr("Why") });
  this->horizontalHeader()->setStretchLastSection(true);
  this->verticalHeader()->hide();
  this->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->setTabKeyNavigation(false); // Tab goes on
  this->setAccessibleName(tr("What this scene uses"));
  this->Again->setSingleShot(true);
  connect(this->Again, &QTimer::timeout, this, &UsePanel::Refresh);
  const auto later = [this]
  {
    if (this->isVisible() && !this->Again->isActive())
      this->Again->start(BetweenMs);
  };
  connect(&planner.views.Scene(), &SceneView::Shown, this, later);
  connect(&planner.plan, &PlanSession::Changed, this, later);
}

ResourceList UsePanel::Resources(const Planner& planner)
{
  ResourceList list;
  for (const PlanVolume& volume : planner.plan.Now().volumes)
    if (const ShelfScan* scan = planner.scans.Find(volume.hash))
      list.push_back({ "scan " + std::to_string(volume.id),
        std::size_t(scan->image->GetActualMemorySize()) * 1024, 0.0, "samples" });
  planner.scene.ListResources(list);
  return list;
}

void UsePanel::showEvent(QShowEvent* event)
{
  QTableWidget::showEvent(event);
  this->Refresh();
}

void UsePanel::Refresh()
{
  const ResourceList list = Resources(this->Of);
  this->setRowCount(int(list.size()));
  for (int row = 0; row < int(list.size()); ++row)
  {
    const ResourceUse& use = list[std::size_t(row)];
    const QStringList texts{ QString::fromStdString(use.resource),
      use.bytes == 0 ? QString("0") : BytesText(use.bytes),
      QString::number(use.milliseconds, 'f', 1), QString::fromStdString(use.reason) };
    for (int column = 0; column < texts.size(); ++column)
      this->setItem(row, column, new QTableWidgetItem(texts[column]));
  }
  this->resizeColumnsToContents();
}

} // namespace hasp
