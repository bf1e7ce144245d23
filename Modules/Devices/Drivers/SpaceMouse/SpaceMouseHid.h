#pragma once
#include "Devices/Drivers/SpaceMouse/HidReportDescriptor.h"
#include "Devices/Drivers/SpaceMouse/HidTransport.h"
#include "Devices/Drivers/SpaceMouse/SixDofSource.h"
#include "Devices/Drivers/SpaceMouse/SpaceMouseReport.h"

#include <memory>

namespace hasp
{

/// A 3Dconnexion device over HID, read beside spacenavd and others: hidraw gives each its own copy.
///
/// The light of the cap is on while it is open; a device that takes no light, or not from us, is
/// none the worse. Axis ranges are those of the report descriptor.
/// Limits: a button that was held when a wireless device went out of reach stays held until the
/// device or its receiver says otherwise. A button pressed and let go between two reads was not
/// pressed.
class SpaceMouseHid : public SixDofSource
{
public:
  /// Throws std::invalid_argument if there is no transport.
  explicit SpaceMouseHid(std::unique_ptr<HidTransport> transport);
  ~SpaceMouseHid() override;

  const char* Name() const noexcept override { return "spacemouse"; }
  void Open(const DriverOpening& how) override;
  SixDofNews Read(SixDofState& state, int waitMs) override;
  void Close() noexcept override;
  std::optional<int> BatteryPercent() const noexcept override
  {
    return this->Reports.batteryPercent;
  }
  std::uint64_t WrongCount() const noexcept override { return this->Reports.wrong; }

  /// Null while it is closed.
  const SpaceMouseModel* Model() const noexcept { return this->Is; }
  /// As promised by the device, with the fault of its descriptor if it has one.
  const HidAxes& Axes() const noexcept { return this->Promised; }

private:
  void SetLight(bool on) noexcept;

  std::unique_ptr<HidTransport> Transport;
  const SpaceMouseModel* Is = nullptr;
  HidAxes Promised;
  SpaceMouseReports Reports;
};

} // namespace hasp
