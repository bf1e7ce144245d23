#pragma once
#include <chrono>
#include <functional>
#include <iosfwd>
#include <string>

namespace hasp
{

/// What the user sees while waiting. On a terminal one line that is rewritten, ten times a second
/// at most, and wiped at the end; elsewhere one plain line a step. Or, where somebody watches, all
/// of it is his and nothing is written. One thread, RENDER or a WORKER that owns it.
class ProgressLine
{
public:
  enum class Style
  {
    Quiet,
    Steps,
    Terminal
  };
  explicit ProgressLine(std::ostream& stream) : Stream(stream) {}
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  void operator=(const ProgressLine&) = delete;

  void SetStyle(Style style) { this->Choice = style; }

  /// Is told each step, and its share; false gives the work up. Empty: nobody watches.
  using Watch = std::function<bool(const std::string& step, double share)>;
  void SetWatch(Watch watch) { this->Watching = std::move(watch); }

  /// Begins a step: "reading head.mha". Throws Cancelled if who watches gives it up.
  void Step(const std::string& text);

  /// Share of the step done, in [0,1]. False: who watches gives it up; what a ProgressFunction is
  /// to return.
  bool Share(double share);

  /// Wipes the line, so that other text can be printed.
  void Wipe();

private:
  std::ostream& Stream;
  Style Choice = Style::Steps;
  Watch Watching;
  std::string Text;
  bool Shown = false;
  std::chrono::steady_clock::time_point Last{};
};

/// Terminal if stderr is one, else Steps.
ProgressLine::Style StyleOfStderr();

} // namespace hasp
