#include "Steps/ExportPanel.h"

#include "Output/CaseReport.h"
#include "Output/PartExport.h"
#include "Output/PartFacts.h"
#include "Output/RedParts.h"
#include "Planning/DerivedPart.h"
#include "Steps/FileQuestion.h"
#include "Steps/PanelWidgets.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hasp
{
namespace
{

std::filesystem::path PathOf(const QString& text)
{
  return std::filesystem::path(QFile::encodeName(text).toStdString());
}

QLabel* AddReason(QBoxLayout* layout, const QString& name)
{
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  layout->addWidget(label, 1);
  return label;
}

} // namespace

ExportPanel::ExportPanel(Planner& planner, QWidget* parent)
  : StepPanel(planner, parent),
    Folder(new QLineEdit),
    Formats(new QComboBox)
{
  auto* layout = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  auto* formats = new QLabel(tr("Forma&t"));
  formats->setBuddy(this->Formats);
  this->Formats->setObjectName("export.format");
  this->Formats->addItems(ExportFormats());
  row->addWidget(formats);
  row->addWidget(this->Formats, 1);
  layout->addLayout(row);

  auto* single = new QGroupBox(tr("One part"));
  this->Parts = new QVBoxLayout(single);
  layout->addWidget(single);

  auto* whole = new QGroupBox(tr("All parts, with their recipes and run.json"));
  auto* inWhole = new QVBoxLayout(whole);
  auto* place = new QHBoxLayout;
  auto* folder = new QLabel(tr("Fol&der"));
  folder->setBuddy(this->Folder);
  this->Folder->setObjectName("export.folder");
  this->Folder->setPlaceholderText(tr("not there yet, or empty"));
  place->addWidget(folder);
  place->addWidget(this->Folder, 1);
  QPushButton* browse = AddButton(place, "export.browse", tr("&Choose…"));
  inWhole->addLayout(place);
  this->All = AddButton(inWhole, "export.all", tr("Export &all"));
  this->AllWhy = AddReason(inWhole, "export.all.why");
  layout->addWidget(whole);

  this->Reporting = AddButton(layout, "export.report", tr("&Report of the case…"));
  this->Names = new QCheckBox(tr("With the &names of objects"));
  this->Names->setObjectName("export.report.names");
  this->Names->setToolTip(tr("They are your own words: make sure that they name no patient"));
  layout->addWidget(this->Names);
  layout->addStretch(1);

  connect(browse, &QPushButton::clicked, this,
    [this]
    {
      const QString chosen = AskForNewFolder(this, tr("A folder for all parts"), tr("parts"));
      if (!chosen.isEmpty())
        this->Folder->setText(chosen);
    });
  connect(this->All, &QPushButton::clicked, this,
    [this] { ExportAll(this->Of, PathOf(this->Folder->text().trimmed()), this->Format()); });
  connect(this->Reporting, &QPushButton::clicked, this, &ExportPanel::Report);
  connect(this->Folder, &QLineEdit::textChanged, this, &ExportPanel::Refresh);
  connect(&planner.plan, &PlanSession::Replaced, this->Folder, &QLineEdit::clear);
  connect(&planner.plan, &PlanSession::Changed, this, &ExportPanel::Refresh);
  connect(&planner.plan, &PlanSession::PartsChanged, this, &ExportPanel::Refresh);
  connect(&RedParts::Of(planner), &RedParts::Changed, this, &ExportPanel::Refresh);
}

QString ExportPanel::StillNeeds() const
{
  return PartObjects(this->Of.plan.Now()).empty()
           ? tr("Plan something that parts are made of first.")
           : QString();
}

void ExportPanel::showEvent(QShowEvent* event)
{
  StepPanel::showEvent(event);
  if (this->Stale)
    this->Refresh();
}

QString ExportPanel::Format() const
{
  return this->Formats->currentText();
}

ExportPanel::Row ExportPanel::MakeRow(PlanId object)
{
  auto* all = new QWidget;
  auto* layout = new QHBoxLayout(all);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* button = new QPushButton;
  button->setObjectName(QStringLiteral("export.part.%1").arg(object));
  layout->addWidget(button);
  QLabel* why = AddReason(layout, QStringLiteral("export.why.%1").arg(object));
  connect(button, &QPushButton::clicked, this, [this, object] { this->ExportOne(object); });
  this->Parts->addWidget(all);
  PutInTabOrder(this->Parts->parentWidget(), button);
  return { all, button, why };
}

void ExportPanel::Refresh()
{
  this->Stale = !this->isVisible();
  if (this->Stale)
    return;
  const std::vector<PlanId> objects = PartObjects(this->Of.plan.Now());
  std::erase_if(this->Rows,
    [&](const auto& row)
    {
      if (std::find(objects.begin(), objects.end(), row.first) != objects.end())
        return false;
      row.second.all->deleteLater();
      return true;
    });
  QStringList reasons;
  for (const PlanId object : objects)
  {
    if (!this->Rows.contains(object))
      this->Rows[object] = this->MakeRow(object);
    const PartFacts facts = FactsOf(this->Of, object);
    const QString why = WhyNotExported(facts);
    const Row& row = this->Rows.at(object);
    row.button->setText(tr("%1…").arg(facts.called));
    row.button->setEnabled(why.isEmpty());
    row.why->setText(why);
    if (!why.isEmpty())
      reasons << why;
  }
  if (objects.empty())
    reasons << tr("nothing is made of this plan yet");
  else if (reasons.isEmpty() && this->Folder->text().trimmed().isEmpty())
    reasons << tr("choose a folder that is not there yet, or empty");
  this->All->setEnabled(reasons.isEmpty());
  this->AllWhy->setText(reasons.join('\n'));
  this->AllWhy->setVisible(!reasons.isEmpty());
}

void ExportPanel::ExportOne(PlanId object)
{
  const QString format = this->Format();
  const QString name = NameOfExport(this->Of, object, format);
  const QString file =
    AskForNewFile(this, tr("Export %1").arg(name), name, tr("Parts (*.%1)").arg(format));
  if (!file.isEmpty())
    ExportPart(this->Of, object, PathOf(file));
}

void ExportPanel::Report()
{
  const QString file = AskForNewFile(this, tr("Report of the case"), tr("report.html"),
    tr("Web pages (*.html)"), QStringLiteral(".pdf"));
  if (!file.isEmpty())
    WriteCaseReport(this->Of, PathOf(file), { .names = this->Names->isChecked() });
}

} // namespace hasp
