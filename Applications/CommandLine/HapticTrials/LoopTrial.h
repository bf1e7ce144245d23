#pragma once
#include "Realtime/NanosecondHistogram.h"
#include "TrialBody.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace hasp
{

struct ReportContext;

/// How regular a loop of 1 kHz was.
struct LoopFigures
{
  NanosecondCounts lateness; ///< from when a tick was due to when it began
  std::uint64_t ticks = 0, missed = 0;
  std::string shortfalls; ///< what the system did not give; empty: all that was asked for

  void Add(const LoopFigures& other);
};

/// A loop at 1 kHz in which a tool touches, or nothing is done. `beside` is called again and again
/// on this thread meanwhile: it draws. RENDER.
class LoopTrial
{
public:
  LoopTrial();
  ~LoopTrial();
  LoopFigures Run(double seconds, bool withTool, const std::function<void()>& beside);

private:
  struct Tool;
  std::unique_ptr<Tool> Held;
};

/// haptics.loop.*: both loops in turn, `seconds` each in all, with `beside` beside them. Real time:
/// no figure of it is a bar.
void TryLoop(
  ReportContext& context, double seconds, const std::function<void()>& beside, const char* what);

/// What a program holds in which a step ticks and nothing can be touched: to be 0.
void AddUnusedHaptics(ReportContext& context);

} // namespace hasp
