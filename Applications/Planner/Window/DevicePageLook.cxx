// What the page of the haptic device shows while it is open, and what it asks of the device.
#include "Window/DevicePage.h"

#include "Devices/Drivers/DeviceAddress.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include <glm/geometric.hpp>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace hasp
{
namespace
{
constexpr double MostRmsN =
  0.3; // a tenth of the largest force: readings that scatter more are none

QString ButtonsText(std::uint32_t buttons)
{
  QStringList held;
  for (int button = 0; button < 32; ++button)
    if ((buttons >> button & 1U) != 0)
      held << QString::number(button + 1);
  return held.isEmpty() ? DevicePage::tr("no button")
                        : DevicePage::tr("button %1").arg(held.join(", "));
}
} // namespace

void DevicePage::List()
{
  const QSignalBlocker quiet(this->Use);
  QStringList lines;
  bool locked = false;
  this->Use->clear();
  this->Use->addItem(tr("What pushes, when it is plugged in"), QString());
  this->Use->addItem(tr("None: the mouse"), QString("none"));
  for (const FoundDevice& device : this->Devices->Found())
  {
    const QString name = QString::fromStdString(device.name);
    lines << (device.remedy.empty()
                ? tr("%1: can be used").arg(name)
                : tr("%1: %2").arg(name, QString::fromStdString(device.remedy)));
    locked = locked || !device.mayOpen;
    // Numbers of nodes and sockets change: the first of its kind, as long as there is no second.
    const std::string kind = ParseDeviceAddress(device.address).driver;
    const auto others = std::ranges::count_if(this->Devices->Found(),
      [&](const FoundDevice& other) { return other.address.starts_with(kind); });
    this->Use->addItem(name, QString::fromStdString(others == 1 ? kind : device.address));
  }
  this->Use->addItem(tr("What is named below"), QString(Named));
  this->Found->setText(
    lines.isEmpty() ? tr("No haptic device and no 6-DOF mouse") : lines.join("\n"));
  this->Rules->setVisible(locked);
  const QString chosen = QString::fromStdString(this->Devices->Settings().device);
  const int listed = this->Use->findData(chosen);
  this->Use->setCurrentIndex(listed >= 0 ? listed : this->Use->count() - 1);
  if (!this->Other->isModified()) // somebody is typing
    this->Other->setText(listed >= 0 ? QString() : chosen);
  this->Other->setEnabled(this->Use->currentData().toString() == QLatin1String(Named));
}

void DevicePage::Look()
{
  const DeviceNews news = this->Devices->News();
  const bool runs = this->Device && news.phase == DevicePhase::Running;
  const bool pushes = runs && this->Device->Profile().forceAxes > 0;
  this->Test->setEnabled(pushes);
  this->Scale->setVisible(this->Device && this->Device->Profile().name == FalconProfile().name);
  this->Scale->setEnabled(pushes);
  if (!this->Device)
  {
    this->State->setText(tr("No device is used: the mouse moves what is in hand."));
    this->Pose->clear();
    return;
  }
  const QString name = QString::fromStdString(this->Device->Profile().name);
  const QString says = QString::fromStdString(news.advice.empty() ? news.says : news.advice);
  this->State->setText(tr("%1: %2").arg(name, says));
  if (!runs)
    return this->Pose->clear();
  const DeviceSight seen = this->Trial->Look();
  for (Reading& reading : this->Readings)
    reading.given =
      reading.given || (reading.push->isChecked() && seen.givenN >= reading.newton - 1e-9);
  const glm::dvec3& at = seen.sample.pose.position;
  this->Pose->setText(tr("%1 mm right, %2 up, %3 towards you; %4; pushed with %5 N")
                        .arg(at.x, 0, 'f', 1)
                        .arg(at.y, 0, 'f', 1)
                        .arg(at.z, 0, 'f', 1)
                        .arg(ButtonsText(seen.sample.buttons))
                        .arg(glm::length(seen.asked.force), 0, 'f', 1));
}

/// One thing at a time: what was pressed last.
void DevicePage::Push()
{
  auto* pressed = qobject_cast<QPushButton*>(this->sender());
  const auto raise = [pressed](QPushButton* other)
  {
    if (!pressed || pressed == other || !pressed->isChecked())
      return;
    const QSignalBlocker quiet(other);
    other->setChecked(false);
  };
  raise(this->Test);
  for (const Reading& reading : this->Readings)
    raise(reading.push);
  if (!this->Trial)
    return;
  ForceTrial trial;
  if (this->Test->isChecked())
    trial = { .kind = ForceTrial::Kind::Axes, .newton = this->Newton->value() };
  for (const Reading& reading : this->Readings)
    if (reading.push->isChecked())
      trial = { .kind = ForceTrial::Kind::Steady, .newton = reading.newton };
  this->Trial->Ask(trial);
}

void DevicePage::Keep()
{
  try
  {
    std::vector<ScaleReading> readings;
    for (const Reading& reading : this->Readings)
    {
      if (!reading.given)
        throw std::invalid_argument(tr(
          "%1 N was not felt yet: choose it, and hold the first button while you read the scale.")
                                      .arg(reading.newton)
                                      .toStdString());
      readings.push_back({ reading.newton, reading.read->value() });
    }
    const ScaleFit fit = FitScale(readings);
    if (fit.rmsN > MostRmsN)
      throw std::invalid_argument(tr("The readings scatter by %1 N: read them again.")
                                    .arg(fit.rmsN, 0, 'f', 2)
                                    .toStdString());
    DeviceSettings settings = this->Devices->Settings();
    settings.falcon.countsPerNm /= fit.share;
    this->Leave();
    const bool kept = this->Devices->SetSettings(settings);
    for (Reading& reading : this->Readings) // they were of the scale before
    {
      reading.read->setValue(0.0);
      reading.given = false;
    }
    this->Fit->setText(tr("%1 of what is asked for was felt, ± %2 N.")
                         .arg(fit.share, 0, 'f', 2)
                         .arg(fit.rmsN, 0, 'f', 2) +
                       " " + (kept ? tr("It is kept.") : tr("It holds until the program ends.")));
  }
  catch (const std::exception& error)
  {
    this->Fit->setText(QString::fromUtf8(error.what()));
  }
  this->Leave();
  this->Take();
}

} // namespace hasp
