// What PlannerWindow does with files: plans, scans that a plan names, what is dropped on it.
#include "Model/RecentPlans.h"
#include "Model/WorkFolder.h"
#include "Steps/ImportPanel.h"
#include "Window/PlannerWindow.h"
#include "Window/Tour.h"

#include "Planning/DurableFile.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QInputDialog>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

namespace hasp
{
namespace
{
namespace fs = std::filesystem;

fs::path PathOf(const QString& text)
{
  return fs::u8path(text.toStdString());
}

/// A name for a plan's folder: of the case label what any file system takes.
QString FolderName(const std::string& caseLabel)
{
  QString name;
  for (const QChar letter : QString::fromStdString(caseLabel))
    name += letter.isLetterOrNumber() || letter == '-' ? letter : QChar('-');
  return (name.isEmpty() ? QString("plan") : name) + ".hasp";
}
} // namespace

void PlannerWindow::OpenPath(const QString& path)
{
  const fs::path place = PathOf(path);
  std::error_code ignored;
  if (fs::exists(place / "plan.json", ignored) || place.filename() == "plan.json")
  {
    this->OpenPlan(path);
    return;
  }
  this->ChooseStep("import");
  static_cast<ImportPanel*>(this->Step("import"))->ImportPath(path);
}

bool PlannerWindow::MayLeavePlan()
{
  this->TakeTyped();
  if (!this->Of->plan.IsModified())
    return true;
  QMessageBox question(QMessageBox::Question, tr("Save the plan?"),
    tr("The plan has changes that are not saved."),
    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  question.setObjectName("question.save");
  question.button(QMessageBox::Save)->setObjectName("question.save.save");
  question.button(QMessageBox::Discard)->setObjectName("question.save.discard");
  question.button(QMessageBox::Cancel)->setObjectName("question.save.cancel");
  switch (question.exec())
  {
    case QMessageBox::Save:
      return this->SavePlanHere();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

void PlannerWindow::LeavePlan()
{
  this->Of->jobs.CancelAll();
  this->Work.SetPlace(this->Of->folders.plans, {}); // after a crash the next would be saved there
}

void PlannerWindow::NewPlan()
{
  if (!this->MayLeavePlan())
    return;
  this->LeavePlan();
  this->Of->plan.BeginNew();
  this->Of->scans.KeepOnly(this->Of->plan.Now());
  this->ChooseStep("import");
}

void PlannerWindow::OpenPlan(const QString& folder)
{
  if (!this->MayLeavePlan())
    return;
  QString path = folder;
  if (path.isEmpty())
    path = QFileDialog::getExistingDirectory(this, tr("Open a plan: its folder, NAME.hasp"),
      QString::fromStdString(this->Of->folders.plans.string()));
  if (path.isEmpty())
    return;
  std::error_code ignored; // then it is not there, which Open says
  fs::path place = fs::absolute(PathOf(path), ignored);
  if (place.filename() == "plan.json")
    place = place.parent_path();
  this->LeavePlan();
  if (this->Of->plan.Open(place))
    this->Remember();
  else
    this->Work.SetPlace(this->Of->folders.plans, this->Of->plan.SavedIn());
}

bool PlannerWindow::SavePlanHere()
{
  this->TakeTyped();
  if (!this->Of->plan.HasPlace())
    return this->SavePlanAs();
  if (!this->Of->plan.Save())
    return false;
  this->Remember();
  this->Of->Say(tr("Saved."));
  return true;
}

bool PlannerWindow::SavePlanAs()
{
  this->TakeTyped();
  std::error_code error;
  fs::create_directories(this->Of->folders.plans, error);
  QFileDialog dialog(this, tr("Save the plan as a folder, NAME.hasp"));
  dialog.setObjectName("dialog.save");
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setFileMode(QFileDialog::AnyFile);
  dialog.setOption(QFileDialog::DontConfirmOverwrite); // a plan that is there is refused
  dialog.setDirectory(QString::fromStdString(this->Of->folders.plans.string()));
  dialog.selectFile(FolderName(this->Of->plan.Now().caseLabel));
  if (dialog.exec() != QDialog::Accepted)
    return false;
  QString name = dialog.selectedFiles().value(0);
  if (!name.endsWith(".hasp"))
    name += ".hasp";
  if (!this->Of->plan.SaveAs(PathOf(name)))
    return false;
  this->Remember();
  this->Of->Say(tr("Saved."));
  return true;
}

void PlannerWindow::Remember()
{
  const fs::path& place = this->Of->plan.SavedIn();
  RecentPlans recent(this->Of->folders.state, this->Of->folders.plans);
  recent.Add(this->Of->plan.Now().caseLabel, place);
  this->Work.SetPlace(this->Of->folders.plans, place);
}

void PlannerWindow::LoadMissing()
{
  delete this->Guided; // a tour is of the plan that it began with
  this->Of->scans.KeepOnly(this->Of->plan.Now());
  for (const PlanVolume& volume : this->Of->scans.Missing(this->Of->plan.Now()))
  {
    if (!this->Of->scans.IsKept(volume.hash))
      continue; // the import panel asks for it
    const fs::path folder = this->Of->scans.Folder();
    this->Of->jobs.Add(tr("Reading scan %1").arg(volume.id),
      [this, folder, hash = volume.hash](const ProgressFunction& progress) -> JobQueue::Finish
      {
        const std::optional<ShelfScan> scan = ScanShelf::ReadKept(folder, hash, progress);
        return [this, scan]
        {
          if (scan)
            this->Of->scans.Put(*scan);
        };
      });
  }
}

void PlannerWindow::TrySample(Sample sample)
{
  if (!this->MayLeavePlan())
    return;
  this->LeavePlan();
  this->Of->plan.BeginNew();
  const fs::path folder = this->Of->scans.Folder();
  this->Of->jobs.Add(tr("Making the sample"),
    [this, sample, folder, file = SampleFile()](
      const ProgressFunction& progress) -> JobQueue::Finish
    {
      const std::vector<ShelfScan> scans = MakeSample(sample, file, progress);
      for (const ShelfScan& scan : scans)
        ScanShelf::Keep(folder, scan);
      return [this, sample, scans, stands = sample == Sample::Skull && file.empty()]
      {
        this->BeginSample(sample, scans);
        if (stands)
          this->Of->Say(
            tr("The real CT is not here, so this is a generated phantom. The CT comes by "
               "Utilities/Scripts/cranium, or with Debian's invesalius-examples."));
      };
    });
}

void PlannerWindow::BeginSample(Sample sample, const std::vector<ShelfScan>& scans)
{
  std::vector<PlanEdit> edits{ SetCaseLabel{ "sample" } };
  PlanId id = this->Of->plan.NewId();
  for (const ShelfScan& scan : scans)
  {
    this->Of->scans.Put(scan);
    edits.push_back(AddObject<PlanVolume>{
      { id++, tr("sample %1").arg(edits.size()).toStdString(), scan.passport.hash } });
  }
  if (!this->Of->plan.Do(std::move(edits), tr("Begin with the sample")))
    return;
  this->Of->scene.LookFrom('A');
  this->Guided = new Tour(*this, sample);
  static_cast<QVBoxLayout*>(this->centralWidget()->layout())->insertWidget(1, this->Guided);
}

void PlannerWindow::closeEvent(QCloseEvent* event)
{
  if (!this->MayLeavePlan() || (this->mayClose && !this->mayClose()))
    return event->ignore();
  event->accept();
}

void PlannerWindow::dragEnterEvent(QDragEnterEvent* event)
{
  if (event->mimeData()->hasUrls() && !QApplication::activeModalWidget())
    event->acceptProposedAction();
}

void PlannerWindow::dropEvent(QDropEvent* event)
{
  event->acceptProposedAction();
  // Later: where it was dragged from all waits for the end of this, and a question may come first.
  QTimer::singleShot(0, this,
    [this, urls = event->mimeData()->urls()]
    {
      for (const QUrl& url : urls)
        if (url.isLocalFile())
          this->OpenPath(url.toLocalFile());
    });
}

} // namespace hasp
