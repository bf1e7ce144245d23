#pragma once
#include <chrono>
#include <iosfwd>
#include <string>

namespace hasp
{

/// What the user sees while waiting. On a terminal one line that is rewritten, ten times a second
/// at most, and wiped at the end; elsewhere one plain line a step. RENDER thread only.
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

  /// Begins a step: "reading head.mha".
  void Step(const std::string& text);

  /// Share of the step done, in [0,1].
  void Share(double share);

  /// Wipes the line, so that other text can be printed.
  void Wipe();

private:
  std::ostream& Stream;
  Style Choice = Style::Steps;
  std::string Text;
  bool Shown = false;
  std::chrono::steady_clock::time_point Last{};
};

/// Terminal if stderr is one, else Steps.
ProgressLine::Style StyleOfStderr();

} // namespace hasp
