#include "Steps/MissingInputs.h"

#include "Planning/PlanLists.h"
#include "Steps/FileQuestion.h"
#include "Steps/PanelWidgets.h"
#include "Steps/SurfaceShelf.h"
#include "vtkHaspSurfaceFile.h"
#include "vtkHaspSurfaceHash.h"
#include "vtkHaspVolumeView.h"

#include "vtkPolyData.h"

#include <QLabel>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hasp
{
namespace
{
constexpr int IdRole = Qt::UserRole;
}

MissingInputs::MissingInputs(Planner& planner, QWidget* parent)
  : QWidget(parent),
    Of(planner),
    Items(new QListWidget)
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* text = new QLabel(tr("The plan was made on what is not here:"));
  text->setWordWrap(true);
  layout->addWidget(text);
  this->Items->setObjectName("import.missing");
  this->Items->setAccessibleName(tr("Scans and surfaces that are not here"));
  this->Items->setMaximumHeight(90);
  layout->addWidget(this->Items);
  auto* row = new QHBoxLayout;
  this->File = AddButton(row, "import.locate", tr("&Locate its file…"));
  this->Folder = AddButton(row, "import.locatefolder", tr("Locate its fol&der…"));
  layout->addLayout(row);
  connect(this->File, &QPushButton::clicked, this,
    [this] { this->Locate(AskForFile(this, tr("Where is it?"), tr("All files (*)"))); });
  connect(this->Folder, &QPushButton::clicked, this,
    [this] { this->Locate(AskForFolder(this, tr("Where are this scan's slices?"))); });
  connect(&planner.plan, &PlanSession::Replaced, this, [this] { this->Tried.clear(); });
  connect(&planner.plan, &PlanSession::Changed, this, &MissingInputs::Refresh);
  connect(&planner.scans, &ScanShelf::Added, this, &MissingInputs::Refresh);
  connect(&SurfaceShelf::Of(planner), &SurfaceShelf::Added, this, &MissingInputs::Refresh);
  this->Refresh();
}

void MissingInputs::List(PlanId id, const QString& text)
{
  auto* item = new QListWidgetItem(text, this->Items);
  item->setData(IdRole, id);
}

void MissingInputs::Refresh()
{
  const Plan& plan = this->Of.plan.Now();
  const SurfaceShelf& surfaces = SurfaceShelf::Of(this->Of);
  const int row = std::max(0, this->Items->currentRow());
  this->Items->clear();
  for (const PlanVolume& volume : this->Of.scans.Missing(plan))
    this->List(volume.id, tr("scan %1 is not here").arg(volume.id));
  for (const PlanSurface& surface : surfaces.Missing(plan))
  {
    this->List(surface.id, tr("surface %1 is not here").arg(surface.id));
    if (this->Tried.insert(surface.hash).second && surfaces.IsKept(surface.hash))
      this->ReadKeptSurface(surface);
  }
  this->Items->setCurrentRow(std::min(row, this->Items->count() - 1));
  this->setVisible(this->Items->count() > 0);
}

void MissingInputs::ReadKeptSurface(const PlanSurface& surface)
{
  this->Of.jobs.Add(tr("Reading surface %1").arg(surface.id),
    [me = QPointer<MissingInputs>(this), folder = SurfaceShelf::Of(this->Of).Folder(),
      hash = surface.hash](const ProgressFunction& progress) -> JobQueue::Finish
    {
      SurfaceShelf::Mesh mesh = SurfaceShelf::ReadKept(folder, hash, progress);
      return [me, hash, mesh]
      {
        if (me && mesh)
          SurfaceShelf::Of(me->Of).Put(hash, mesh);
      };
    });
}

void MissingInputs::Locate(const QString& path)
{
  const QListWidgetItem* item = this->Items->currentItem();
  if (!item || path.isEmpty())
    return;
  const PlanId id = item->data(IdRole).toUInt();
  if (const auto* surface = FindPlanObject<PlanSurface>(this->Of.plan.Now(), id))
    this->LocateSurface(*surface, path.toStdString());
  else
    this->LocateScan(id, path.toStdString());
}

void MissingInputs::LocateScan(PlanId id, const std::string& path)
{
  this->Of.jobs.Add(tr("Reading scan %1").arg(id),
    [me = QPointer<MissingInputs>(this), id, path, folder = this->Of.scans.Folder()](
      const ProgressFunction& progress) -> JobQueue::Finish
    {
      ShelfScan scan = ScanShelf::Read(path, {}, progress);
      ScanShelf::Keep(folder, scan);
      return [me, id, scan = std::move(scan)]
      {
        if (!me)
          return;
        const std::vector<PlanVolume> missing = me->Of.scans.Missing(me->Of.plan.Now());
        const auto found = std::find_if(missing.begin(), missing.end(),
          [&](const PlanVolume& volume) { return volume.hash == scan.passport.hash; });
        if (found == missing.end())
        {
          me->Of.SayFault(
            tr("This is not scan %1: its samples are others. Choose the file or folder "
               "that the plan was made on; a copy in another format will do. One that "
               "was resampled then is to be imported, and resampled, again.")
              .arg(id));
          return;
        }
        me->Of.Say(tr("Scan %1 is here.").arg(found->id));
        me->Of.scans.Put(scan);
      };
    });
}

void MissingInputs::LocateSurface(const PlanSurface& surface, const std::string& path)
{
  this->Of.jobs.Add(tr("Reading surface %1").arg(surface.id),
    [me = QPointer<MissingInputs>(this), surface, path,
      folder = SurfaceShelf::Of(this->Of).Folder()](
      const ProgressFunction& progress) -> JobQueue::Finish
    {
      auto mesh = std::make_shared<const TriangleMesh>(
        MakeTriangleMesh(LoadSurface(path, {}, progress).surface));
      const bool same = SurfaceHash(*mesh) == surface.hash;
      if (same)
        SurfaceShelf::Keep(folder, surface.hash, *mesh);
      return [me, surface, mesh, same]
      {
        if (me && same)
          SurfaceShelf::Of(me->Of).Put(surface.hash, mesh);
        else if (me)
          me->Of.SayFault(
            tr("This is not surface %1: its triangles are others. Choose the file that "
               "the plan was made on.")
              .arg(surface.id));
      };
    });
}

} // namespace hasp
