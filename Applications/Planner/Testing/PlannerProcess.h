#pragma once
#include "ScreenHand.h"

#include <nlohmann/json.hpp>

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// What a user did and waited for.
struct UserEffort
{
  std::size_t clicks = 0;    ///< presses of buttons
  std::size_t keys = 0;      ///< but for modifiers
  double machineWaitS = 0.0; ///< from inputs until all that came of them was done
  double ofThemBusyS = 0.0;  ///< while a job ran
};

/// How the program is started on a screen: everything of its own lies in `home`, which a second one
/// finds again.
struct PlannerStart
{
  std::string display;              ///< of TestScreen
  std::filesystem::path home;       ///< made if it is not there
  std::vector<std::string> words{}; ///< besides --layout FILE
  double patienceS = 60.0;
};

/// The program HASP_PLANNER_PROGRAM, which writes a layout file (Window/LayoutFile.h), used as a
/// user does: by the pointer and the keys of its screen. Each action finds its widget by its name,
/// waits until it can be seen and is enabled (it scrolls to it), acts with real events, and waits
/// until the program has handled them and has nothing left to do. Nothing sleeps for a fixed time.
///
/// Throws std::runtime_error where something does not come within `patienceS`, with what is on the
/// screen and what the program has written.
class PlannerProcess
{
public:
  using Json = nlohmann::json;

  /// Starts it, lets its window fill the screen and waits until it is settled.
  explicit PlannerProcess(const PlannerStart& start);
  ~PlannerProcess(); ///< ends it, if it still runs

  ///@{
  void Click(const std::string& name, int button = 1);
  int ClickToEnd(const std::string& name); ///< what ends the program; its exit code
  void DoubleClick(const std::string& name);
  /// Of a list, a tree, or tabs: the row with that id; in the order of rows (from 0).
  void ClickId(const std::string& name, long long id, int column = 0, int button = 1);
  void ClickRow(const std::string& name, int row, int column = 0);
  /// In a view: shares of its width and height, from the upper left.
  void ClickAt(const std::string& name, double x, double y, int button = 1);
  void Drag(
    const std::string& name, double fromX, double fromY, double toX, double toY, int button = 1);
  void Wheel(const std::string& name, double x, double y, int steps);
  ///@}
  ///@{
  void Choose(const std::string& combo, int index);      ///< opens it; then the keys: Qt ignores a
                                                         ///< click that soon
  void SetNumber(const std::string& spin, double value); ///< clicks, types, Tab
  void SetText(const std::string& line, const std::string& latin1);
  void SetChecked(const std::string& name, bool checked); ///< a click, if it is not
  void AnswerFile(const std::string& path);        ///< in a dialog that asks for a file or a folder
  void Menu(const std::vector<std::string>& path); ///< {"menu.file", "file.save"}
  ///@}
  void Key(const std::string& keys); ///< as ScreenHand's: "ctrl+z"
  void Type(const std::string& latin1);

  ///@{
  /// What is on the screen now.
  const Json& Layout();
  bool Has(const std::string& name); ///< visible
  /// The widget's entry. Waits for it.
  Json Widget(const std::string& name);
  Json State(const std::string& key);
  std::string Text(const std::string& name);
  void WaitUntil(const std::string& what, const std::function<bool(const Json&)>& holds);
  void WaitSettled();
  ///@}

  UserEffort Effort() const;
  ScreenHand& Hand() { return this->User; }
  void SavePicture(const std::filesystem::path& png) const; ///< of the screen

  void CloseWindow(); ///< the close button of the window on top
  void Kill9();
  int ExitCode(); ///< waits for its end; 128 + signal if one ended it
  bool IsRunning();
  pid_t Process() const { return this->Child; }
  std::string Output() const; ///< what it has written on both streams

  double patienceS;

private:
  void Start(const PlannerStart& start);
  bool ReadLayout();
  void Act(const std::function<void()>& input);
  void Await(const std::string& what, const std::function<bool(const Json&)>& holds, bool counted);
  /// False: not within that time.
  bool Comes(double withinS, const std::function<bool(const Json&)>& holds, bool counted);
  Json Ready(const std::string& name);
  void ScrollTo(const std::string& name);
  Json Row(const std::string& name, const std::function<bool(const Json&)>& fits);
  [[noreturn]] void Fail(const std::string& what) const;

  ScreenHand User;
  std::filesystem::path File, Written;
  std::filesystem::file_time_type ReadAt{};
  Json Now;
  pid_t Child = 0;
  int Code = -1;
  double WaitS = 0.0, BusyS = 0.0;
};
