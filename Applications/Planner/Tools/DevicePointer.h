#pragma once
#include "Tools/VtkFaults.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <QEvent>
#include <QObject>
#include <QPointF>
#include <QTimer>

#include <memory>
#include <vector>

class QPainter;
class vtkHaspHapticInteractor;

namespace hasp
{

struct MarkedView;
struct Planner;
class ToolMarks;

/// Gives a hand the planner's device. False: there is none, or it was refused, which is said.
bool GiveDevice(vtkHaspHapticInteractor& hand, Planner& planner);

/// The planner's haptic device as a mouse in the 3D view, for tools that have no way of their own
/// with it: the device's tip is marked in all views, and where it is seen in 3D the pointer is. Its
/// first button is the left one; the second one, held, moves the device and leaves the tip where
/// it is. So a tip on bone touches that bone; one in mid-air touches what is seen behind it.
///
/// Threads: RENDER; the device on HAPTIC. Cost: nothing without a device, or without a tool in
/// hand; else a tick a millisecond (no bodies), and a look at it 60 times a second, without frames.
class DevicePointer : public QObject
{
  Q_OBJECT
public:
  explicit DevicePointer(Planner& planner, QObject* parent = nullptr);
  ~DevicePointer() override;

  /// Whether it is the pointer now.
  bool IsOn() const { return this->Hand != nullptr; }

private:
  void Follow();
  void Begin();
  void End();
  void Look();
  void Send(QEvent::Type type);
  void Paint(QPainter& painter, const MarkedView& view) const;

  Planner& Of;
  VtkFaults Faults;
  vtkNew<vtkCallbackCommand> Command;
  vtkSmartPointer<vtkHaspHapticInteractor> Hand; ///< while it is the pointer
  std::unique_ptr<ToolMarks> Marks;
  std::vector<QEvent::Type> Pressed; ///< heard in an update, done after it
  QTimer Looking;
  QPointF At;
  bool IsDown = false;
};

} // namespace hasp
