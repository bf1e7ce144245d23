#include "LoopTrial.h"

#include "Haptics/HapticStep.h"
#include "Realtime/LoopThread.h"
#include "ReportRegistry.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iterator>

namespace hasp
{

/// A bumpy ball on itself, half of its points in contact, in a hand that trembles.
struct LoopTrial::Tool
{
  TrialBody body{ 128, { 45.0, 3.0, 6.0 } };
  HapticStep step;

  Tool()
  {
    auto scene =
      std::make_unique<HapticScene>(std::vector<HapticShell>{ { this->body.Shell(20'000), {} } },
        std::vector<HapticBody>{ { this->body.Map(), {} } });
    this->step.Swap(scene);
    this->step.Place({});
  }
  void Tick(std::uint64_t number) noexcept
  {
    const double sway = 0.02 * std::sin(0.06 * static_cast<double>(number));
    this->step.Tick({ { sway, 0.7 * sway, -0.5 * sway }, TurnBy({ 0.0, 0.0, 0.002 * sway }) });
  }
};

LoopTrial::LoopTrial() : Held(std::make_unique<Tool>()) {}
LoopTrial::~LoopTrial() = default;

void LoopFigures::Add(const LoopFigures& other)
{
  NanosecondCounts& sum = this->lateness;
  const bool first = sum.total == 0;
  for (std::size_t bin = 0; bin < sum.counts.size(); ++bin)
    sum.counts[bin] += other.lateness.counts[bin];
  sum.total += other.lateness.total;
  sum.sumNs += other.lateness.sumNs;
  sum.leastNs = first ? other.lateness.leastNs : std::min(sum.leastNs, other.lateness.leastNs);
  sum.mostNs = std::max(sum.mostNs, other.lateness.mostNs);
  this->ticks += other.ticks;
  this->missed += other.missed;
  this->shortfalls = other.shortfalls;
}

LoopFigures LoopTrial::Run(double seconds, bool withTool, const std::function<void()>& beside)
{
  LoopThread loop;
  Tool* tool = withTool ? this->Held.get() : nullptr;
  LoopFigures figures;
  const SchedulingReport& got = loop.Start({},
    [tool](const LoopTick& tick) noexcept
    {
      if (tool != nullptr)
        tool->Tick(tick.number);
      return true;
    });
  for (const std::string& shortfall : got.Shortfalls())
    figures.shortfalls += (figures.shortfalls.empty() ? "" : " ") + shortfall;
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end)
    beside();
  loop.Stop();
  const RateCounts rates = loop.Rates();
  figures.lateness = rates.lateness;
  figures.ticks = rates.ticks;
  figures.missed = rates.skipped;
  return figures;
}

namespace
{

double MissedShare(const LoopFigures& figures)
{
  return static_cast<double>(figures.missed) /
         static_cast<double>(std::max<std::uint64_t>(1, figures.missed + figures.ticks));
}

std::string Text(double figure, const char* unit)
{
  char text[120];
  std::snprintf(
    text, sizeof text, "a loop that does nothing, in the same run: %.4g %s", figure, unit);
  return text;
}

void AddRow(ReportContext& context, const char* name, double ours, double bare, const char* unit,
  const LoopFigures& figures, const std::string& data)
{
  ReportRow row;
  row.id = std::string("haptics.loop.") + name;
  row.value = ours;
  row.unit = unit;
  row.better = Better::Lower;
  row.rival = Text(bare, unit);
  row.n = static_cast<int>(figures.ticks);
  row.data = data;
  context.report.rows.push_back(row);
}

/// Shares of ticks that began later than so many microseconds.
ReportCurve Histogram(const char* method, const LoopFigures& figures)
{
  ReportCurve curve{ "haptics.loop.lateness", method, "us late", "share of ticks later", {} };
  for (double us = 1.0; us < 1e5; us *= std::pow(10.0, 0.125))
    if (const auto above = figures.lateness.Above(static_cast<std::int64_t>(1e3 * us)); above > 0)
      curve.points.emplace_back(
        us, static_cast<double>(above) / static_cast<double>(figures.lateness.total));
  return curve;
}

} // namespace

void TryLoop(
  ReportContext& context, double seconds, const std::function<void()>& beside, const char* what)
{
  LoopTrial trial;
  LoopFigures ours, bare;
  const int turns = std::max(2, static_cast<int>(seconds / 10.0)); // a neighbour disturbs both
  for (int turn = 0; turn < turns; ++turn)
  {
    context.progress(turn / static_cast<double>(turns), "");
    ours.Add(trial.Run(seconds / turns, true, beside));
    bare.Add(trial.Run(seconds / turns, false, beside));
  }
  char text[240];
  std::snprintf(text, sizeof text,
    "20,000 points, half in contact, beside %s; %.0f s of each loop in turns; no bar: what else "
    "the "
    "machine does counts",
    what, seconds);
  std::string data = text;
  if (!ours.shortfalls.empty())
    data += "; not given: " + ours.shortfalls;
  const auto late = [](const LoopFigures& figures, double share)
  { return 1e-3 * figures.lateness.PercentileNs(share); };
  AddRow(context, "p50", late(ours, 0.5), late(bare, 0.5), "us late", ours, data);
  AddRow(context, "p99", late(ours, 0.99), late(bare, 0.99), "us late", ours, data + "; aim 130");
  AddRow(context, "p999", late(ours, 0.999), late(bare, 0.999), "us late", ours, data);
  AddRow(context, "missed", MissedShare(ours), MissedShare(bare), "share of periods", ours, data);
  for (const auto& [method, figures] :
    { std::pair("haptic loop", &ours), std::pair("bare loop", &bare) })
    if (ReportCurve curve = Histogram(method, *figures); !curve.points.empty())
      context.report.curves.push_back(curve);
}

void AddUnusedHaptics(ReportContext& context)
{
  const auto threads = []
  {
    std::error_code none;
    return std::distance(std::filesystem::directory_iterator("/proc/self/task", none),
      std::filesystem::directory_iterator());
  };
  constexpr std::size_t Stack = 8UL << 20;
  const auto before = threads();
  HapticStep step;
  const LoopThread loop;
  auto scene = std::make_unique<HapticScene>(std::vector<HapticShell>{}, std::vector<HapticBody>{});
  ResourceList working;
  scene->ListResources(working);
  step.Swap(scene);
  step.Tick({});
  std::size_t bytes = 0;
  for (const ResourceUse& use : working)
    bytes += use.bytes;
  const char* why = "nothing can be touched";
  const auto grown = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, threads() - before));
  context.report.unused.push_back({ "haptic maps and shells: working memory", bytes, 0.0, why });
  context.report.unused.push_back({ "haptic thread", grown * Stack, 0.0, why });
}

} // namespace hasp
