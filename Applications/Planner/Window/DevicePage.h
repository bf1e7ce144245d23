#pragma once
#include "Tools/HandDevices.h"

#include "Devices/Drivers/DeviceTrial.h"

#include <QDialog>
#include <QPointer>
#include <QTimer>

#include <array>
#include <memory>

class QComboBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;

namespace hasp
{

class PlannerWindow;

/// The page of the haptic device: what is plugged in and whether it may be used, which one is,
/// homing, its pose and buttons, a test of its force, and the scale of a Falcon's force by a spring
/// scale. While it is shown it has the device, and tools the mouse.
///
/// Threads: RENDER; the device's and a loop of 1 kHz while it is shown and there is a device.
class DevicePage : public QDialog
{
  Q_OBJECT
public:
  DevicePage(PlannerWindow& window, HandDevices& devices);
  ~DevicePage() override;

protected:
  void hideEvent(QHideEvent* event) override; ///< gives the device back
  void showEvent(QShowEvent* event) override;

private:
  /// Of the choice: what the line below it says.
  static constexpr const char* Named = "?";
  struct Reading
  {
    double newton;
    QPushButton* push;
    QDoubleSpinBox* read;
    bool given = false; ///< the button was held, and all of the force was there
  };
  void BuildChoice();
  QWidget* MakeTest();
  QWidget* MakeScale();
  void List();
  void Choose();
  void Take();
  void Leave();
  void Look();
  void Push();
  void Keep();

  QPointer<HandDevices> Devices; ///< null while the window goes
  QComboBox* Use;
  QLineEdit* Other;
  QLabel* Found;
  QPushButton* Rules;
  QLabel* Refusal; ///< of what was chosen last
  QLabel* State;
  QLabel* Pose;
  QPushButton* Test = nullptr;
  QDoubleSpinBox* Newton = nullptr;
  QGroupBox* Scale = nullptr;
  QLabel* Fit = nullptr;
  std::array<Reading, 3> Readings{};
  QTimer Looking;
  std::shared_ptr<DrivenHapticDevice> Device;
  std::unique_ptr<DeviceTrial> Trial; ///< while there is a device
};

/// Adds "Haptic device …" to the menu. Threads: RENDER.
void AddDeviceAction(QMenu& menu, PlannerWindow& window);

} // namespace hasp
