#include "Steps/ImportRemedies.h"

#include "Steps/PanelWidgets.h"
#include "vtkHaspVolumeFile.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hasp
{

ImportRemedies::ImportRemedies(QWidget* parent)
  : QWidget(parent),
    Series(new QComboBox),
    Resample(new QCheckBox(tr("Me&nd it by resampling")))
{
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  this->Series->setObjectName("import.series");
  this->Series->setAccessibleName(tr("Series of the folder"));
  layout->addWidget(this->Series);
  this->Resample->setObjectName("import.resample");
  layout->addWidget(this->Resample);
  this->Again = AddButton(layout, "import.again", tr("&Try again"));
  connect(this->Again, &QPushButton::clicked, this, &ImportRemedies::TryAgain);
  this->Withdraw();
}

void ImportRemedies::Offer(const Passport& refused)
{
  const bool several = std::any_of(refused.faults.begin(), refused.faults.end(),
    [](const ImportFault& fault) { return fault.kind == FaultKind::MixedSeries; });
  if (several)
  {
    this->Series->clear();
    for (int n = 1; n <= refused.seriesFound; ++n)
      this->Series->addItem(tr("Series %1").arg(n));
  }
  // One that was chosen stays so while it is mended.
  this->HasSeries = refused.seriesFound > 1 && (several || this->HasSeries);
  this->Mends = std::all_of(refused.faults.begin(), refused.faults.end(),
    [](const ImportFault& fault) { return fault.resamplable; });
  this->Series->setVisible(this->HasSeries);
  this->Resample->setVisible(this->Mends);
  this->Resample->setChecked(this->Mends);
  this->setVisible(this->HasSeries || this->Mends);
}

void ImportRemedies::Withdraw()
{
  this->HasSeries = this->Mends = false;
  this->hide();
}

VolumeReadSettings ImportRemedies::Settings() const
{
  VolumeReadSettings settings;
  settings.series = this->HasSeries ? this->Series->currentIndex() + 1 : 0;
  settings.resample = this->Mends && this->Resample->isChecked();
  return settings;
}

} // namespace hasp
