#pragma once
#include <nlohmann/json_fwd.hpp>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <filesystem>
#include <functional>
#include <string>

class QEvent;

namespace hasp
{

/// What is on the screen, in a file that is kept up to date while this lives: for tests that drive
/// the program as a user does, and for assistive tools. JSON, "hasp-layout-1":
///
///   widgets   LayoutWidgets.h: where each named widget is and what it says
///   modal     the dialog that must be answered first, {name, class, title}; null: none
///   popup     the name of the menu or list that is open; null: none
///   focus     the name of the widget that has the keyboard; null: none that has a name
///   state     what the program says of itself, and of this:
///     events    presses and releases of buttons, presses of keys (repeated ones too) and steps of
///               the wheel so far
///     settled   all that was sent to the program has been handled, and nothing is pending
///
/// Whoever sends an input waits until `events` has grown by it and `settled` is true. A click that
/// a dialog keeps from another window is no event.
///
/// The file is another one each time (a temporary beside it, renamed), and only when something has
/// changed, 50 ms after the last time at the earliest. It goes with this. No word of the user's is
/// in it: names and texts that hold one are left out.
///
/// Threads: RENDER. Cost: a counter an event; where something has happened a walk over the widgets,
/// about a millisecond; no timer while nothing happens.
class LayoutFile : public QObject
{
  Q_OBJECT
public:
  /// An object; "busy" and "pending", where they are there, keep `settled` false: there is a job,
  /// or a frame is to come.
  using State = std::function<nlohmann::ordered_json()>;
  /// What no text may hold: the names in the plan.
  using UserWords = std::function<QStringList()>;

  LayoutFile(std::filesystem::path file, State state, UserWords words, QObject* parent = nullptr);
  ~LayoutFile() override;

Q_SIGNALS:
  void Failed(const QString& text); ///< once: it cannot be written

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void Count(QObject* watched, QEvent* event);
  void Look();
  bool ComesUpSoon() const;
  std::string Describe(bool quiet) const;
  void Write(const std::string& text);

  std::filesystem::path File;
  State Of;
  UserWords Words;
  QTimer Looking;
  QElapsedTimer Noise, Wrote, Input; ///< since the first event after rest; the file; an input
  unsigned long long Seen = 0, SeenAtLook = 0, Events = 0;
  bool Overridden = false; ///< the key that is pressed has been counted
  bool Told = false;       ///< Failed
  std::string Last;
};

} // namespace hasp
