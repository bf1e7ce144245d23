#include "Steps/IsovalueBox.h"

#include "Segmentation/ThresholdPresets.h"
#include "Segmentation/ThresholdProposal.h"
#include "vtkHaspVolumeView.h"

#include "vtkImageData.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include <cmath>

namespace hasp
{
namespace
{

constexpr int SliderSteps = 1000;

/// What ThresholdPresets calls them, for translators.
constexpr const char* PresetNames[] = { QT_TRANSLATE_NOOP("hasp::IsovalueBox", "bone"),
  QT_TRANSLATE_NOOP("hasp::IsovalueBox", "adult compact bone"),
  QT_TRANSLATE_NOOP("hasp::IsovalueBox", "adult spongial bone"),
  QT_TRANSLATE_NOOP("hasp::IsovalueBox", "adult enamel"),
  QT_TRANSLATE_NOOP("hasp::IsovalueBox", "child compact bone"),
  QT_TRANSLATE_NOOP("hasp::IsovalueBox", "child spongial bone"),
  QT_TRANSLATE_NOOP("hasp::IsovalueBox", "child enamel"),
  QT_TRANSLATE_NOOP("hasp::IsovalueBox", "soft tissue") };

} // namespace

IsovalueBox::IsovalueBox(Planner& planner, QWidget* parent)
  : QWidget(parent),
    Of(planner),
    Value(new QDoubleSpinBox),
    Slider(new QSlider(Qt::Horizontal)),
    Preset(new QComboBox),
    Proposal(new QPushButton(tr("Prop&ose")))
{
  this->Value->setObjectName("split.isovalue");
  this->Value->setRange(-1e6, 1e6);
  this->Value->setDecimals(1);
  this->Value->setKeyboardTracking(false);
  this->Slider->setObjectName("split.isovalue.slider");
  this->Slider->setAccessibleName(tr("Isovalue"));
  this->Slider->setRange(0, SliderSteps);
  this->Preset->setObjectName("split.preset");
  this->Preset->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  this->Preset->setMinimumContentsLength(12);
  this->Preset->addItem(tr("choose a range…"));
  for (const ThresholdPreset& preset : ThresholdPresets())
    this->Preset->addItem(
      tr("%1, from %2 HU").arg(tr(preset.name)).arg(preset.lowest), preset.lowest);
  static_assert(std::size(PresetNames) == 8);
  this->Proposal->setObjectName("split.propose");
  this->Proposal->setToolTip(
    tr("Finds where bone begins by the histogram: for values that are no HU"));

  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->addRow(tr("Bone is at &least"), this->Value);
  form->addRow(this->Slider);
  auto* row = new QHBoxLayout;
  row->addWidget(this->Preset, 1);
  row->addWidget(this->Proposal);
  form->addRow(row);

  connect(this->Value, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
    [this](double value) { this->Of.scene.SetIsovalue(value); });
  connect(this->Slider, &QSlider::valueChanged, this,
    [this](int step)
    {
      if (const ShelfScan* scan = this->Scan())
        this->Of.scene.SetIsovalue(
          std::round(scan->passport.minimum +
                     step * (scan->passport.maximum - scan->passport.minimum) / SliderSteps),
          this->Slider->isSliderDown());
    });
  connect(this->Slider, &QSlider::sliderReleased, this,
    [this] { this->Of.scene.SetIsovalue(this->Of.scene.Isovalue()); });
  connect(this->Preset, QOverload<int>::of(&QComboBox::activated), this, &IsovalueBox::TakePreset);
  connect(this->Proposal, &QPushButton::clicked, this, &IsovalueBox::Propose);
  connect(&planner.scene, &PlanScene::IsovalueChanged, this, &IsovalueBox::Refresh);
  connect(&planner.scene, &PlanScene::PropsChanged, this, &IsovalueBox::Refresh);
  connect(&planner.scans, &ScanShelf::Added, this, &IsovalueBox::Refresh);
  connect(&planner.plan, &PlanSession::Changed, this, &IsovalueBox::Refresh);
  this->Refresh();
}

const ShelfScan* IsovalueBox::Scan() const
{
  return this->Of.scans.OfVolume(this->Of.plan.Now(), this->Of.scene.ShownVolume());
}

void IsovalueBox::Refresh()
{
  const QSignalBlocker quiet(this->Value), still(this->Slider);
  const ShelfScan* scan = this->Scan();
  this->setEnabled(scan != nullptr);
  const double value = this->Of.scene.Isovalue();
  const bool typing = this->Value->hasFocus() && this->Value->findChild<QLineEdit*>()->isModified();
  if (!typing) // else both would write over it
  {
    this->Value->setValue(value);
    this->Value->setSuffix(scan && scan->passport.hounsfield ? tr(" HU") : QString());
  }
  if (!scan)
    return;
  const Passport& passport = scan->passport;
  this->Preset->setEnabled(passport.hounsfield);
  const double range = passport.maximum - passport.minimum;
  if (range > 0.0 && !this->Slider->isSliderDown())
    this->Slider->setValue(int(std::lround(SliderSteps * (value - passport.minimum) / range)));
}

void IsovalueBox::TakePreset(int row)
{
  if (row > 0)
    this->Of.scene.SetIsovalue(this->Preset->itemData(row).toDouble());
}

void IsovalueBox::Propose()
{
  const ShelfScan* scan = this->Scan();
  if (!scan)
    return;
  this->Of.jobs.Add(tr("Proposing where bone begins"),
    [me = QPointer<IsovalueBox>(this), image = scan->image, hash = scan->passport.hash](
      const ProgressFunction& progress) -> JobQueue::Finish
    {
      const ThresholdProposal found = ProposeThreshold(ViewImage(image), {}, progress);
      return [me, hash, found]
      {
        const ShelfScan* now = me ? me->Scan() : nullptr;
        if (!now || now->passport.hash != hash)
          return; // another scan is shown by now
        me->Of.scene.SetIsovalue(found.threshold);
        me->Of.Say(
          found.separation < 2.0
            ? tr("Bone begins at about %1, but soft tissue and bone run into each other: look at "
                 "thin bone, and set it by hand.")
                .arg(found.threshold)
            : tr("Bone begins at about %1. Thin bone may be lost: look at it.")
                .arg(found.threshold));
      };
    });
}

} // namespace hasp
