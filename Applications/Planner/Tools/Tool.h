#pragma once
#include <QObject>
#include <QString>

namespace hasp
{

/// What the mouse (or a device) does in the views while it is in hand. One at a time: ToolBox.
/// Threads: RENDER.
class Tool : public QObject
{
  Q_OBJECT
public:
  using QObject::QObject;
  virtual void Begin() = 0;         ///< takes its observers; what it needs is made now
  virtual void End() = 0;           ///< gives all of it back
  virtual QString Hint() const = 0; ///< a line for the status bar: what a drag does now
  /// Whether it has a haptic device for itself; else the device is its pointer (DevicePointer).
  virtual bool TakesDevice() const { return false; }
Q_SIGNALS:
  void HintChanged();
};

/// Which tool is in hand. Escape puts it away.
class ToolBox : public QObject
{
  Q_OBJECT
public:
  using QObject::QObject;
  void Take(Tool* tool); ///< ends the one before; nullptr: none, the mouse turns the view
  Tool* InHand() const { return this->Now; }
Q_SIGNALS:
  void Changed();

private:
  Tool* Now = nullptr;
};

} // namespace hasp
