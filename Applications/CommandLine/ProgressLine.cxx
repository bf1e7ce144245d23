#include "ProgressLine.h"

#include "Grid/Progress.h"

#include <unistd.h>

#include <algorithm>
#include <ostream>

namespace hasp
{

ProgressLine::~ProgressLine()
{
  this->Wipe();
}

void ProgressLine::Step(const std::string& text)
{
  this->Text = text;
  this->Last = {};
  if (this->Watching)
  {
    if (!this->Watching(text, 0.0))
      throw Cancelled();
    return;
  }
  if (this->Choice == Style::Steps)
    this->Stream << "hasp: " << text << std::endl;
  else
    this->Share(0.0);
}

bool ProgressLine::Share(double share)
{
  using namespace std::chrono_literals;
  if (this->Watching)
    return this->Watching(this->Text, share);
  const auto now = std::chrono::steady_clock::now();
  if (this->Choice != Style::Terminal || now - this->Last < 100ms)
    return true;
  this->Last = now;
  this->Shown = true;
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  this->Stream << "\r\033[K"
               << (percent < 10     ? "  "
                    : percent < 100 ? " "
                                    : "")
               << percent << "% " << this->Text << std::flush;
  return true;
}

void ProgressLine::Wipe()
{
  if (this->Shown)
    this->Stream << "\r\033[K" << std::flush;
  this->Shown = false;
}

ProgressLine::Style StyleOfStderr()
{
  return isatty(STDERR_FILENO) ? ProgressLine::Style::Terminal : ProgressLine::Style::Steps;
}

} // namespace hasp
