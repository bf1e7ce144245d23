#include "GuideTrials.h"
#include "MeasuredRows.h"
#include "Planning/DerivedPart.h"
#include "RandomDocument.h"
#include "ReportRegistry.h"
#include "ScratchFolder.h"

#include <chrono>
#include <exception>
#include <filesystem>

namespace hasp
{
namespace
{

/// Undo to the start, redo to the end: the same hashes both ways.
bool ComesBack(PlanDocument document)
{
  PlanHistory& history = document.history;
  std::vector<std::string> hashes;
  for (; history.ToUndo(); history.Undo())
    hashes.push_back(PlanHash(history.Current()));
  if (PlanHash(history.Current()) != PlanHash(history.Start()))
    return false;
  for (; !hashes.empty(); hashes.pop_back())
  {
    history.Redo();
    if (PlanHash(history.Current()) != hashes.back())
      return false;
  }
  return true;
}

/// Is a byte that is not what it was found?
bool IsFound(std::string text, RandomEdits& random)
{
  char& byte = text[std::size_t(random.Below(text.size()))];
  byte = char(byte ^ char(1 + random.Below(255)));
  try
  {
    ParsePlan(text);
  }
  catch (const std::exception&)
  {
    return true;
  }
  return false;
}

} // namespace

void TryPlans(ReportContext& context, std::size_t plans)
{
  context.progress(0.0, "guides: random plans");
  constexpr unsigned OnDisk = 20; ///< each of these waits for the disk; the others are texts
  constexpr int FlipsOfEach = 4;
  const auto seed = static_cast<unsigned>(context.settings.seed * 100'000);
  const ScratchFolder scratch;
  const std::filesystem::path folder = scratch.Path() / "plan.hasp";
  std::size_t lost = 0, undone = 0, unseen = 0;
  double seconds = 0.0;
  for (unsigned n = 0; n < plans; ++n)
  {
    context.progress(double(n) / double(plans), "");
    const PlanDocument document = RandomDocument(seed + n, int(n % 12));
    const auto start = std::chrono::steady_clock::now();
    const std::string text = FormatPlan(document);
    bool same = ParsePlan(text) == document;
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (n < OnDisk)
    {
      SavePlan(folder, document);
      same = same && LoadPlan(folder) == document;
    }
    lost += !same;
    undone += !ComesBack(document);
    RandomEdits random(seed + n);
    for (int flip = 0; flip < FlipsOfEach; ++flip)
      unseen += !IsFound(text, random);
  }
  ReportRow row;
  row.id = "guides.plan";
  row.value = double(plans - lost) / double(plans);
  row.unit = "share";
  row.rival = "the plan as it was saved";
  row.error = double(lost + undone + unseen);
  row.errorUnit = "plans lost or not undone, bytes not found";
  row.timeS = seconds / double(plans);
  row.n = int(plans);
  row.data = "random plans, load(save(plan)) = plan, " + std::to_string(OnDisk) +
             " of them through the disk; undone to the start and redone by hash; " +
             std::to_string(FlipsOfEach) + " wrong bytes in each";
  row.bars = { { 1.0, {} },
    { {}, 0.0, "plans that undo and redo do not bring back", double(undone) },
    { {}, 0.0, "wrong bytes not found", double(unseen) } };
  context.report.rows.push_back(row);
}

} // namespace hasp
