#include "ReductionTrials.h"
#include "Report.h"
#include "ReportRegistry.h"
#include "TrialRows.h"

#include "Distance/TetrahedraContour.h"
#include "Grid/ParallelFor.h"
#include "Studies/BoneTrial.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstdio>

namespace hasp
{
namespace
{

constexpr int Operators = 3, TrialsEach = 2;
constexpr double SurfaceMm = 1.5; // of the grid that surfaces are contoured on: thinner than bone
constexpr float Stiffness = 0.5F; // as reduction.fidelity
constexpr int Levels = 3;         // of points: 4096, a third of the time of all
constexpr double LimitS = 20.0;   // virtual, for a piece

/// The fragment's surface, in the scan.
std::shared_ptr<const MeasuredSurface> SurfaceOf(const BakedFitBody& body)
{
  GridGeometry grid = body.map->Geometry();
  const glm::dvec3 size = grid.spacing * glm::dvec3(grid.Cells());
  grid.spacing = glm::dvec3(SurfaceMm);
  grid.dims = glm::ivec3(glm::floor(size / SurfaceMm)) + 1;
  std::vector<float> distances(grid.Size());
  const std::int64_t row = grid.dims.x, rows = std::int64_t(grid.dims.y) * grid.dims.z;
  ParallelFor(0, rows, 64,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t r = begin; r < end; ++r)
        for (std::int64_t i = 0; i < row; ++i)
        {
          const glm::dvec3 index(double(i), double(r % grid.dims.y), double(r / grid.dims.y));
          distances[std::size_t(r * row + i)] = float(body.map->At(grid.IndexToWorld(index)).mm);
        }
    });
  return std::make_shared<const MeasuredSurface>(
    ContourTetrahedra(GridView<const float>{ distances.data(), grid }));
}

/// Poses as plans have them: from the scan to where the fragment is planned.
RigidPose ScanToPlanned(const ReductionCase& broken, std::size_t body, const RigidPose& inWorld)
{
  return inWorld * RigidPose{ broken.bodies[body].origin }.Inverse();
}

std::string CaseName(std::size_t n)
{
  return "case " + std::to_string(n + 1);
}

TrialCase CaseOf(const ReductionCase& broken, std::size_t number, std::size_t most)
{
  TrialCase made{ CaseName(number), {}, FragmentPoses{} };
  std::vector<std::size_t> pieces = OrderOfPieces(broken);
  pieces.resize(std::min(pieces.size(), most));
  for (const std::size_t piece : pieces)
  {
    made.fragments[broken.names[piece]] = SurfaceOf(broken.bodies[piece]);
    (*made.truth)[broken.names[piece]] =
      ScanToPlanned(broken, piece, broken.trueBodyInWorld[piece]);
  }
  return made;
}

OperatorHelp HelpWithSnap()
{
  OperatorHelp help;
  help.step.contact.stiffness = Stiffness;
  help.levels = Levels;
  help.snap = true;
  return help;
}

/// All operators' trials of all cases, by case, operator and number; side by side on all cores.
std::vector<BoneTrial> TryBones(
  ReportContext& context, const std::vector<ReductionCase>& cases, std::size_t most)
{
  context.progress(0.0, "reduction: simulated operators on broken bones");
  const std::int64_t each = Operators * TrialsEach;
  std::vector<BoneTrial> trials(cases.size() * std::size_t(each));
  const OperatorHelp help = HelpWithSnap();
  const std::uint64_t first = 50'000 * (1 + context.settings.seed);
  ParallelFor(0, std::int64_t(trials.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
      {
        OperatorSettings who =
          MakeOperator(first + std::uint64_t(n % each / TrialsEach)); // the same in all cases
        who.givesUpS = LimitS;
        trials[std::size_t(n)] = PutBoneTogether(
          cases[std::size_t(n / each)], who, help, first + 10 + std::uint64_t(n), most);
      }
    });
  return trials;
}

std::vector<Trial> NamedTrials(
  const std::vector<ReductionCase>& cases, const std::vector<BoneTrial>& made)
{
  std::vector<Trial> trials;
  const std::size_t each = Operators * TrialsEach;
  for (std::size_t n = 0; n < made.size(); ++n)
  {
    const ReductionCase& broken = cases[n / each];
    Trial trial{ CaseName(n / each), "operator " + std::to_string(1 + n % each / TrialsEach),
      int(1 + n % TrialsEach), {} };
    for (std::size_t k = 0; k < made[n].pieces.size(); ++k)
    {
      const std::size_t piece = made[n].pieces[k];
      trial.poses[broken.names[piece]] = ScanToPlanned(broken, piece, made[n].bodyInWorld[k]);
    }
    trials.push_back(std::move(trial));
  }
  return trials;
}

std::string DataOf(std::size_t cases, const std::vector<BoneTrial>& trials)
{
  std::size_t pieces = 0;
  int content = 0;
  std::uint64_t faults = 0;
  double seconds = 0.0;
  for (const BoneTrial& trial : trials)
  {
    pieces += trial.pieces.size();
    content += trial.content;
    faults += trial.faults;
    seconds += trial.seconds;
  }
  char text[320];
  std::snprintf(text, sizeof text,
    "%zu broken mandibles x %d simulated operators x %d trials = %zu trials of %zu pieces, through "
    "the haptic step with Snap-to-fit, from 12 to 18 mm before their places; %d left by "
    "themselves, the others after %.0f s; %.0f virtual seconds a trial; %llu ticks beyond limits",
    cases, Operators, TrialsEach, trials.size(), pieces, content, LimitS,
    seconds / double(trials.size()), static_cast<unsigned long long>(faults));
  return text;
}

} // namespace

void TryPrecision(ReportContext& context, const std::vector<ReductionCase>& cases)
{
  const std::size_t most = context.settings.quick ? 1 : 2;
  const std::vector<BoneTrial> made = TryBones(context, cases, most);
  context.progress(0.8, "reduction: measuring trials");
  std::vector<TrialCase> named;
  for (std::size_t n = 0; n < cases.size(); ++n)
    named.push_back(CaseOf(cases[n], n, most));
  const std::vector<Trial> trials = NamedTrials(cases, made);
  AddTrialRows(context, MakeTrialTable(named, trials), DataOf(cases.size(), made));
}

} // namespace hasp
