#include "Steps/ImportPanel.h"

#include "Model/ObjectNames.h"
#include "PlanFragmentLabels.h"
#include "Planning/PlanLists.h"
#include "Steps/FileQuestion.h"
#include "Steps/ImportEdits.h"
#include "Steps/ImportRemedies.h"
#include "Steps/MissingInputs.h"
#include "Steps/PanelWidgets.h"
#include "Steps/PassportBrowser.h"
#include "Steps/PassportPage.h"
#include "Steps/SurfaceShelf.h"
#include "vtkHaspVolumeView.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include <memory>

namespace hasp
{

ImportPanel::ImportPanel(Planner& planner, QWidget* parent) : StepPanel(planner, parent)
{
  this->Build();
  connect(&planner.plan, &PlanSession::Changed, this, &ImportPanel::Refresh);
  connect(this->Case, &QLineEdit::editingFinished, this, &ImportPanel::SetCase);
  this->Refresh();
}

void ImportPanel::Build()
{
  auto* layout = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  QPushButton* open = AddButton(row, "import.open", tr("O&pen file…"));
  connect(open, &QPushButton::clicked, this,
    [this]
    {
      this->ImportPath(AskForFile(this, tr("Open a scan, a label map or a surface"),
        tr("Scans, label maps and surfaces (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.vti *.inv3 "
           "*.stl *.ply *.obj *.3mf *.vtp);;All files (*)")));
    });
  QPushButton* folder = AddButton(row, "import.folder", tr("Open f&older…"));
  folder->setToolTip(tr("A folder of DICOM slices, or a plan (.hasp)"));
  connect(folder, &QPushButton::clicked, this,
    [this] { this->ImportPath(AskForFolder(this, tr("Open a folder of slices, or a plan"))); });
  layout->addLayout(row);
  layout->addWidget(new MissingInputs(this->Of));

  this->Remedies = new ImportRemedies;
  layout->addWidget(this->Remedies);
  connect(this->Remedies, &ImportRemedies::TryAgain, this, [this] { this->Read(this->Path); });
  // It is another case, and what was refused was of the one before.
  connect(&this->Of.plan, &PlanSession::Replaced, this->Remedies, &ImportRemedies::Withdraw);

  this->Page = new PassportBrowser(this->Of);
  layout->addWidget(this->Page, 1);

  auto* form = new QFormLayout;
  this->Case = new QLineEdit;
  this->Case->setObjectName("import.case");
  this->Case->setMaxLength(50); // of 4 bytes each: what a plan takes
  this->Case->setPlaceholderText(tr("a pseudonym, no name"));
  this->Case->setToolTip(tr("It is written on parts and into reports."));
  form->addRow(tr("&Case"), this->Case);
  this->Thickness = new QDoubleSpinBox;
  this->Thickness->setObjectName("import.thickness");
  this->Thickness->setRange(1.0, 50.0);
  this->Thickness->setValue(2.0);
  this->Thickness->setSuffix(tr(" mm"));
  this->Thickness->setToolTip(
    tr("An open surface is taken as a sheet, so thick behind the face that it shows."));
  form->addRow(tr("Open surfaces are thic&k"), this->Thickness);
  layout->addLayout(form);
}

void ImportPanel::Refresh()
{
  const QString label = QString::fromStdString(this->Of.plan.Now().caseLabel);
  if (this->Case->text() != label && !this->Case->isModified())
    this->Case->setText(label);
}

void ImportPanel::SetCase()
{
  const QString label = this->Case->text().trimmed(),
                before = QString::fromStdString(this->Of.plan.Now().caseLabel);
  this->Case->setModified(false);
  if (label != before.left(this->Case->maxLength())) // a longer one is cut off in the line
    this->Of.plan.Do(SetCaseLabel{ label.toStdString() }, tr("Set the case label"));
  this->Refresh(); // as the plan has it, also where it was refused
}

void ImportPanel::ImportPath(const QString& path)
{
  if (path.isEmpty())
    return;
  if (HoldsPlan(path.toStdString()))
  {
    this->OpenPlan(path);
    return;
  }
  this->Remedies->Withdraw();
  this->Read(path);
}

void ImportPanel::OpenPlan(const QString& folder)
{
  if (this->openPlan)
    this->openPlan(folder);
  else if (this->Of.plan.IsModified())
    this->Of.SayFault(tr("This plan has changes that are not saved: save it, then open another."));
  else
    this->Of.plan.Open(folder.toStdString());
}

void ImportPanel::Read(const QString& path)
{
  this->Path = path;
  ImportRequest request;
  request.path = path.toStdString();
  request.settings = this->Remedies->Settings();
  if (vtkImageData* shown = this->Of.scene.ShownImage())
  {
    request.volume = this->Of.scene.ShownVolume();
    request.scan = ImageGeometry(shown);
  }
  request.keepIn = this->Of.scans.Folder();
  request.keepSurfacesIn = SurfaceShelf::Of(this->Of).Folder();
  request.blobs = this->Of.plan.Folder();
  this->Of.jobs.Add(tr("Reading what was chosen"),
    [me = QPointer<ImportPanel>(this), request = std::move(request)](
      const ProgressFunction& progress) -> JobQueue::Finish
    {
      auto imported = std::make_shared<Imported>(ReadImport(request, progress));
      return [me, imported]
      {
        if (me)
          me->Take(*imported);
      };
    });
}

void ImportPanel::Take(Imported& imported)
{
  if (const auto* refused = std::get_if<RefusedScan>(&imported))
  {
    this->Page->SetAbove(PassportPage::Of(refused->passport));
    this->Remedies->Offer(refused->passport);
    this->Of.SayFault(PassportPage::FaultText(refused->passport.faults.front().text));
    return;
  }
  this->Remedies->Withdraw();
  if (const auto* refused = std::get_if<RefusedFile>(&imported))
  {
    const QString text = PassportPage::FaultText(refused->text);
    this->Page->SetAbove(PassportPage::OfFault(text));
    this->Of.SayFault(text);
  }
  else if (auto* scan = std::get_if<ImportedScan>(&imported))
    this->TakeScan(*scan);
  else if (const auto* labels = std::get_if<ImportedLabels>(&imported))
    this->TakeLabels(*labels);
  else if (const auto* surface = std::get_if<ImportedSurface>(&imported))
    this->TakeSurface(*surface);
}

void ImportPanel::TakeScan(ImportedScan& imported)
{
  const std::string hash = imported.scan.passport.hash;
  this->Of.scans.Put(std::move(imported.scan)); // first: what follows the plan finds it
  const Plan& plan = this->Of.plan.Now();
  PlanId id = VolumeOfHash(plan, hash);
  if (id != 0)
    this->Of.Say(tr("Scan %1 of the plan: it was here before.").arg(id));
  else
  {
    id = this->Of.plan.NewId();
    if (!this->Of.plan.Do(AddObject<PlanVolume>{ { id, ObjectNames::Of<PlanVolume>(id), hash } }))
    {
      this->Of.scans.KeepOnly(this->Of.plan.Now());
      return;
    }
  }
  this->Of.scene.SetShownVolume(id);
  this->Page->SetAbove({});
}

void ImportPanel::TakeLabels(const ImportedLabels& labels)
{
  this->Page->SetAbove(PassportPage::Of(labels.passport));
  const Plan& plan = this->Of.plan.Now();
  const ShelfScan* scan = this->Of.scans.OfVolume(plan, labels.volume);
  if (!scan)
  {
    this->Of.SayFault(tr("The scan that these labels are of is no longer in the plan: import it, "
                         "and then the labels again."));
    return;
  }
  if (const PlanId there = SegmentationOfBlob(plan, labels.blob))
  {
    this->Of.Say(tr("These labels are segmentation %1 of the plan already.").arg(there));
    return;
  }
  const bool isShown = this->Of.scene.ShownVolume() == labels.volume;
  LabelMapFragments made{ labels.volume, labels.blob, labels.present,
    isShown ? this->Of.scene.Isovalue() : LabelSource{}.isovalue,
    FragmentSpacing(scan->passport.geometry.spacing) };
  this->Of.plan.Do(FragmentEdits(this->Of.plan.NewId(), made), tr("Import fragments"));
}

void ImportPanel::TakeSurface(const ImportedSurface& surface)
{
  this->Page->SetAbove(PassportPage::Of(surface.passport, surface.check));
  const double thicknessMm = surface.check.Closed() ? 0.0 : this->Thickness->value();
  SurfaceShelf::Of(this->Of).Put(surface.hash, surface.mesh);
  this->Of.plan.Do(
    SurfaceEdits(this->Of.plan.Now(), this->Of.plan.NewId(), surface.hash, thicknessMm),
    tr("Import a surface"));
}

} // namespace hasp
