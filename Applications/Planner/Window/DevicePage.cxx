#include "Window/DevicePage.h"

#include "Devices/Drivers/DeviceAddress.h"
#include "Window/PlannerWindow.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>

#include <stdexcept>

namespace hasp
{
namespace
{
constexpr int LookMs = 100;

QLabel* Line(const char* name)
{
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText); // names are somebody else's
  label->setMinimumWidth(420);
  return label;
}

QDoubleSpinBox* NewtonBox(const char* name, double least, double most, double value)
{
  auto* box = new QDoubleSpinBox;
  box->setObjectName(name);
  box->setRange(least, most);
  box->setSingleStep(0.1);
  box->setSuffix(" N");
  box->setValue(value);
  return box;
}
} // namespace

DevicePage::DevicePage(PlannerWindow& window, HandDevices& devices)
  : QDialog(&window),
    Devices(&devices),
    Use(new QComboBox),
    Other(new QLineEdit),
    Found(Line("device.found")),
    Rules(new QPushButton(tr("&Copy the udev rules"))),
    Refusal(Line("device.refusal")),
    State(Line("device.state")),
    Pose(Line("device.pose"))
{
  this->setObjectName("device.page");
  this->setWindowTitle(tr("Haptic device"));
  this->Rules->setObjectName("device.rules");
  auto* form = new QFormLayout(this);
  form->setSizeConstraint(QLayout::SetFixedSize); // as large as what is shown
  form->addRow(tr("Plugged in"), this->Found);
  form->addRow(this->Rules);
  this->BuildChoice();
  form->addRow(tr("&Use"), this->Use);
  form->addRow(tr("&Named"), this->Other);
  form->addRow(this->Refusal);
  this->Refusal->hide();
  form->addRow(tr("State"), this->State);
  form->addRow(tr("It says"), this->Pose);
  form->addRow(this->MakeTest());
  form->addRow(this->MakeScale());
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->button(QDialogButtonBox::Close)->setObjectName("device.close");
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  form->addRow(buttons);
  this->Looking.setInterval(LookMs);
  connect(&this->Looking, &QTimer::timeout, this, &DevicePage::Look);
  connect(&devices, &HandDevices::FoundChanged, this,
    [this]
    {
      this->List();
      if (!this->isVisible())
        return;
      this->Leave(); // it may be another one now
      this->Take();
    });
  connect(this->Rules, &QPushButton::clicked, this,
    [] { QGuiApplication::clipboard()->setText(QString::fromStdString(UdevRules())); });
}

DevicePage::~DevicePage()
{
  this->Leave();
}

void DevicePage::BuildChoice()
{
  this->Use->setObjectName("device.use");
  this->Other->setObjectName("device.named");
  this->Other->setPlaceholderText("plugin:FILE.so, inverse3, spacenav");
  connect(this->Use, qOverload<int>(&QComboBox::activated), this, &DevicePage::Choose);
  connect(this->Other, &QLineEdit::editingFinished, this,
    [this]
    {
      if (this->Other->isModified())
        this->Choose();
      this->Other->setModified(false);
    });
}

QWidget* DevicePage::MakeTest()
{
  auto* box = new QGroupBox(tr("Test of the force"));
  auto* form = new QFormLayout(box);
  this->Newton = NewtonBox("device.newton", 0.1, ForceTrial::mostN, 1.0);
  this->Test = new QPushButton(tr("&Push along each axis"));
  this->Test->setObjectName("device.test");
  this->Test->setCheckable(true);
  form->addRow(tr("&Largest force"), this->Newton);
  form->addRow(this->Test);
  auto* hint = Line("device.hint");
  hint->setText(tr("Hold the grip, and its first button for as long as you want to feel it: right, "
                   "left, up, down, towards you, away."));
  form->addRow(hint);
  connect(this->Test, &QPushButton::toggled, this, &DevicePage::Push);
  connect(this->Newton, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &DevicePage::Push);
  return box;
}

QWidget* DevicePage::MakeScale()
{
  this->Scale = new QGroupBox(tr("Scale of the force"));
  auto* form = new QFormLayout(this->Scale);
  auto* hint = Line("device.scale.hint");
  hint->setText(tr("Hang a spring scale between grip and table, so that it is pulled when the grip "
                   "moves towards you. Choose a force, hold the first button and read the scale."));
  form->addRow(hint);
  for (std::size_t n = 0; n < this->Readings.size(); ++n)
  {
    const double newton = 1.0 + double(n);
    auto* push = new QPushButton(tr("Push with %1 N").arg(newton));
    push->setObjectName(QString("device.push.%1").arg(n + 1));
    push->setCheckable(true);
    auto* read = NewtonBox("", 0.0, 50.0, 0.0);
    read->setObjectName(QString("device.read.%1").arg(n + 1));
    read->setDecimals(2);
    this->Readings[n] = { newton, push, read, false };
    form->addRow(push, read);
    connect(push, &QPushButton::toggled, this, &DevicePage::Push);
  }
  auto* keep = new QPushButton(tr("&Keep the scale"));
  keep->setObjectName("device.keep");
  connect(keep, &QPushButton::clicked, this, &DevicePage::Keep);
  this->Fit = Line("device.fit");
  form->addRow(keep, this->Fit);
  return this->Scale;
}

void DevicePage::Choose()
{
  const QString use = this->Use->currentData().toString();
  this->Other->setEnabled(use == QLatin1String(Named));
  const std::string address =
    (use == QLatin1String(Named) ? this->Other->text() : use).toStdString();
  if (use == QLatin1String(Named) && address.empty())
    return this->Other->setFocus();
  DeviceSettings settings = this->Devices->Settings();
  settings.device = address;
  this->Leave();
  QString refusal;
  try
  {
    if (!address.empty() && address != "none")
      ParseDeviceAddress(address);
    this->Devices->SetSettings(settings);
  }
  catch (const std::exception& error)
  {
    refusal = QString::fromUtf8(error.what());
  }
  this->Refusal->setText(refusal);
  this->Refusal->setVisible(!refusal.isEmpty());
  this->Take();
}

void DevicePage::showEvent(QShowEvent* event)
{
  QDialog::showEvent(event);
  this->List();
  this->Take();
}

void DevicePage::hideEvent(QHideEvent* event)
{
  this->Leave();
  QDialog::hideEvent(event);
}

void DevicePage::Take()
{
  this->Device = this->Devices->Hold();
  if (this->Device)
    this->Trial = std::make_unique<DeviceTrial>(*this->Device);
  this->Looking.start();
  this->Look();
}

void DevicePage::Leave()
{
  this->Looking.stop();
  this->Test->setChecked(false);
  for (const Reading& reading : this->Readings)
    reading.push->setChecked(false);
  this->Trial.reset(); // without force
  this->Device.reset();
  if (this->Devices)
    this->Devices->LetGo();
}

void AddDeviceAction(QMenu& menu, PlannerWindow& window)
{
  QAction* action = menu.addAction(PlannerWindow::tr("Haptic &device …"));
  action->setObjectName("view.device");
  QObject::connect(action, &QAction::triggered, &window,
    [&window]
    {
      HandDevices* devices = window.Parts().devices;
      if (!devices)
        return window.Parts().Say(PlannerWindow::tr("A recorded hand is in the device's place."));
      auto* page = window.findChild<DevicePage*>();
      if (!page)
        page = new DevicePage(window, *devices);
      page->show();
      page->raise();
    });
}

} // namespace hasp
