#pragma once
#include <QSize>

#include <filesystem>
#include <string>
#include <vector>

namespace hasp
{

/// What the command line says.
struct PlannerOptions
{
  std::vector<std::string> inputs;  ///< scans, surfaces, label maps, or a plan
  std::string plan;                 ///< a plan's folder, or its plan.json
  std::vector<std::string> volumes; ///< where its scans are
  std::string step;                 ///< shown first, "guide"
  std::string screenshot;           ///< .png of the window
  std::string exportTo;             ///< a folder, as hasp run --output
  std::string format = "stl";       ///< of its parts
  bool make = false;                ///< all parts that are not in date
  bool exit = false;                ///< when all that is done
  bool sample = false;              ///< the first run's tour
  bool explain = false;             ///< lists what the scene uses, before the end
  std::string study, studyOperator; ///< study mode: its folder, and who works
  int trial = 0;
  std::string measure;  ///< a file for the figures of `hasp report planner`
  bool quick = false;   ///< of these, fewer
  std::string device;   ///< a recorded hand; empty: no haptic device
  std::string layout;   ///< a file that says what is on the screen
  std::string language; ///< "sv"; empty: the system's
  std::filesystem::path state, plans;
  QSize size{ 1280, 800 };
  bool recover = true; ///< offer what a crash left

  /// Does anything but the window's opening wait?
  bool IsScript() const
  {
    return this->exit || this->make || !this->measure.empty() || !this->screenshot.empty() ||
           !this->exportTo.empty();
  }
};

/// Understands the words behind the program's name. What they ask for at once (--help, --version)
/// is printed, and what is wrong with them is said on standard error; then false, and the exit
/// code.
bool ReadPlannerOptions(int argc, const char* const* argv, PlannerOptions& options, int& exitCode);

} // namespace hasp
