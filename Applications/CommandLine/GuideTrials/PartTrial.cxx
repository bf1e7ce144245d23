#include "Grid/ParallelFor.h"
#include "GuideTrials.h"
#include "MeasuredRows.h"
#include "PartLine.h"
#include "ReportRegistry.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

namespace hasp
{
namespace
{

/// Parts a process, and processes: starting one takes time, and one alone does not fill the cores.
constexpr std::size_t MostOfBatch = 20, FewestBatches = 4;

struct Tried
{
  std::vector<PartLine> lines;
  std::vector<std::string> crashes; ///< "guide 17: exit code 139"
};

/// All parts of a batch; behind one that ends its process another goes on.
Tried RunBatch(
  const PartRunner& runner, const std::string& kind, std::uint32_t first, std::size_t count)
{
  Tried tried;
  for (std::uint32_t next = first, end = first + std::uint32_t(count); next < end;)
  {
    const PartRun run = runner.run(kind, next, end - next);
    std::istringstream output(run.output);
    for (std::string text; std::getline(output, text);)
      if (const auto line = ParsePartLine(text))
      {
        tried.lines.push_back(*line);
        next = line->seed + 1;
      }
    if (next >= end)
      break;
    tried.crashes.push_back(kind + " " + std::to_string(next) + ": " +
                            (run.ending.empty() ? "said nothing" : run.ending));
    ++next;
  }
  return tried;
}

/// As many processes at a time as cores help.
Tried RunAll(
  ReportContext& context, const PartRunner& runner, const std::string& kind, std::size_t count)
{
  const auto seed = static_cast<std::uint32_t>(context.settings.seed * 100'000);
  const std::size_t batch =
    std::clamp<std::size_t>((count + FewestBatches - 1) / FewestBatches, 1, MostOfBatch);
  const std::size_t batches = (count + batch - 1) / batch;
  constexpr std::size_t AtATime = 8;
  Tried all;
  for (std::size_t begin = 0; begin < batches; begin += AtATime)
  {
    context.progress(double(begin) / double(batches), "");
    std::vector<Tried> some(std::min(AtATime, batches - begin));
    ParallelFor(0, std::int64_t(some.size()), 1,
      [&](std::int64_t low, std::int64_t high)
      {
        for (std::int64_t n = low; n < high; ++n)
        {
          const std::size_t first = (begin + std::size_t(n)) * batch;
          some[std::size_t(n)] =
            RunBatch(runner, kind, seed + std::uint32_t(first), std::min(batch, count - first));
        }
      });
    for (const Tried& tried : some)
    {
      all.lines.insert(all.lines.end(), tried.lines.begin(), tried.lines.end());
      all.crashes.insert(all.crashes.end(), tried.crashes.begin(), tried.crashes.end());
    }
  }
  return all;
}

struct Sum
{
  std::array<std::size_t, 7> of{}; ///< by outcome
  std::size_t parts = 0, triangles = 0;
  double seconds = 0.0;
  std::string wrong{}; ///< a few
  std::vector<std::string> crashes{};

  std::size_t Of(PartOutcome outcome) const { return this->of[std::size_t(outcome)]; }
  std::size_t Made() const
  {
    return this->Of(PartOutcome::Sound) + this->Of(PartOutcome::Open) +
           this->Of(PartOutcome::Crossed) + this->Of(PartOutcome::Empty);
  }
  std::size_t Fine() const { return this->Of(PartOutcome::Sound) + this->Of(PartOutcome::Refused); }
  void Add(const std::string& kind, const Tried& tried)
  {
    for (const PartLine& line : tried.lines)
    {
      ++this->parts;
      ++this->of[std::size_t(line.outcome)];
      this->triangles += line.triangles;
      this->seconds += line.seconds;
      if (line.outcome != PartOutcome::Sound && line.outcome != PartOutcome::Refused &&
          this->wrong.size() < 400)
        this->wrong += "; " + kind + " " + std::to_string(line.seed) + ", " +
                       PartOutcomeName(line.outcome) + ", " + line.text;
    }
    this->parts += tried.crashes.size();
    this->crashes.insert(this->crashes.end(), tried.crashes.begin(), tried.crashes.end());
  }
  ReportRow Row(const char* id, double value, const char* unit, const char* asked) const
  {
    ReportRow row;
    row.id = id;
    row.value = value;
    row.unit = unit;
    row.rival = asked;
    row.n = int(this->parts);
    return row;
  }
};

std::string Said(const std::string& kind, const Sum& sum)
{
  return std::to_string(sum.parts) + " of kind " + kind + ": " +
         std::to_string(sum.Of(PartOutcome::Sound)) + " made and sound, " +
         std::to_string(sum.Of(PartOutcome::Refused)) + " refused by name, " +
         std::to_string(sum.Made() - sum.Of(PartOutcome::Sound)) + " unsound, " +
         std::to_string(sum.Of(PartOutcome::Wrong) + sum.Of(PartOutcome::FellBack)) + " else, " +
         std::to_string(sum.crashes.size()) + " crashed; ";
}

void AddSoundness(ReportContext& context, const Sum& sum, const std::string& said)
{
  const double made = double(std::max<std::size_t>(1, sum.Made()));
  ReportRow manifold = sum.Row("guides.manifold", double(sum.Of(PartOutcome::Sound)) / made,
    "share", "closed, 2-manifold, outward, one piece, does not meet itself, all as 32-bit floats");
  manifold.error = made - double(sum.Of(PartOutcome::Sound));
  manifold.errorUnit = "parts that are not";
  manifold.timeS = sum.seconds / double(std::max<std::size_t>(1, sum.parts));
  manifold.data = said + "of " + std::to_string(sum.triangles / std::size_t(made)) +
                  " triangles each, of small pieces of the phantom" + sum.wrong;
#if !HASP_WITH_CGAL
  manifold.data += "; whether they meet themselves was not looked at: this build has no CGAL";
#endif
  manifold.bars = { { 1.0, {} } };
  ReportRow crashes = sum.Row("guides.crashes", double(sum.crashes.size()), "parts", "none");
  for (std::size_t n = 0; n < sum.crashes.size() && n < 5; ++n)
    crashes.data += (n > 0 ? "; " : "") + sum.crashes[n];
  crashes.bars = { { {}, 0.0 } };
  ReportRow fallback = sum.Row("guides.fallback", double(sum.Of(PartOutcome::FellBack)), "parts",
    "none: each fault is one that the part itself names");
  fallback.bars = { { {}, 0.0 } };
  const double refused = double(sum.Of(PartOutcome::Refused)),
               wrong = double(sum.Of(PartOutcome::Wrong));
  ReportRow named =
    sum.Row("guides.refused", refused + wrong > 0.0 ? refused / (refused + wrong) : 1.0, "share",
      "what cannot be is refused, and the error names the key or the object");
  named.n = int(refused + wrong);
  named.bars = { { 1.0, {} } };
  for (const ReportRow& row : { manifold, crashes, fallback, named })
    context.report.rows.push_back(row);
}

/// The worst of what sound parts measured besides.
ReportRow Worst(const Tried& tried, const char* id, const char* unit, double PartLine::*figure)
{
  ReportRow row;
  row.id = id;
  row.unit = unit;
  row.better = Better::Lower;
  double worst = 0.0, seconds = 0.0;
  for (const PartLine& line : tried.lines)
    if (line.outcome == PartOutcome::Sound && line.*figure >= 0.0) // below: it has none
    {
      ++row.n;
      worst = std::max(worst, line.*figure);
      seconds += line.seconds;
    }
  row.value = worst;
  row.error = worst;
  row.errorUnit = std::string(unit) + " at worst";
  row.timeS = seconds / std::max(1, row.n);
  return row;
}

} // namespace

void TryParts(ReportContext& context, const PartRunner& runner, std::size_t parts, std::size_t cuts)
{
  if (!runner.absent.empty())
  {
    for (const char* id : { "guides.manifold", "guides.planes", "guides.conservation" })
      context.report.rows.push_back(AbsentRow(id, "random parts", runner.absent));
    return;
  }
  std::size_t shares = 0;
  for (const RandomKind& kind : runner.kinds)
    shares += kind.shares;
  std::map<std::string, Tried> tried;
  Sum all, cut;
  std::string said;
  for (const auto& [kind, its] : runner.kinds)
  {
    context.progress(0.0, "guides: random parts of kind " + kind);
    tried[kind] = RunAll(context, runner, kind, its > 0 ? parts * its / shares : cuts);
    (its > 0 ? all : cut).Add(kind, tried[kind]);
    if (its > 0)
    {
      Sum one;
      one.Add(kind, tried[kind]);
      said += Said(kind, one);
    }
  }
  AddSoundness(context, all, said);
  ReportRow planes = Worst(tried["guide"], "guides.planes", "mm", &PartLine::figure);
  planes.rival = "the recipe's saw planes, against those fitted to the guide's walls as written";
  planes.data = "random guides with a slot that nothing else crosses; bars: 0.1 mm, 0.5 degrees";
  const ReportRow degrees = Worst(tried["guide"], "", "degrees", &PartLine::second);
  planes.bars = { { {}, 0.1 }, { {}, 0.5, "tilt, degrees", *degrees.value } };
  ReportRow conserved = Worst(tried["cut"], "guides.conservation", "share", &PartLine::figure);
  conserved.rival = "the bone's own volume: fragments and kerfs, each a mesh of its own";
  conserved.data = "random osteotomies of vault, jaw and fibula of the phantom; " +
                   Said("cut", cut) + "bars: 0.001, and none that is not sound" + cut.wrong;
  conserved.bars = { { {}, 1e-3 },
    { {}, 0.0, "cuts that are not sound", double(cut.parts - cut.Fine()) } };
  context.report.rows.push_back(planes);
  context.report.rows.push_back(conserved);
}

} // namespace hasp
