#pragma once
#include "Reduction/FitProposals.h"
#include "Studies/ReductionCases.h"

#include <functional>
#include <string>
#include <vector>

namespace hasp
{

struct ReportContext;

/// What `hasp report reduction` measures, free of VTK. Each puts rows into the report. WORKER.
///
/// Bones are broken with known poses and scanned anew (ReductionCases.h); half of the cases with
/// faces that lost up to 0.3 mm. Starts are uniform within 3 mm and 5 degrees unless said.

/// One fit from one start, before the truth.
struct FitTrial
{
  double startMm = 0.0; ///< rms over the surface, as all here
  double mm = 0.0, degrees = 0.0;
  double within95Mm = 0.0;   ///< stated
  bool inFirstThree = false; ///< of the proposals, one is the truth's
  double milliseconds = 0.0;
  RigidPose pose;        ///< that it came to
  bool captured = false; ///< TryCapture
};

/// Cases of the report: the broken mandible and the broken head in turn, or mandibles alone.
std::vector<ReductionCase> MakeTrialCases(
  ReportContext& context, int count, std::uint64_t firstSeed, bool jawsAlone = false);

/// try(case, moved body, scene, start pose, number) for `starts` starts of each moved body, on all
/// cores: many small fits side by side.
struct TrialStart
{
  const ReductionCase& broken;
  std::size_t body;
  std::vector<GroupBody> moved;
  const FitScene& scene;
  RigidPose start;
  std::uint64_t seed;
  std::size_t number; ///< of all starts, those of one body on end

  /// Of a pose that a method came to.
  FitTrial Of(const RigidPose& pose) const;
};
using TryStart = std::function<FitTrial(const TrialStart&)>;
std::vector<FitTrial> TryAll(const std::vector<ReductionCase>& cases, int starts, double mm,
  double degrees, std::uint64_t seed, const TryStart& trial);

/// reduction.tre, reduction.rotation: .snap (proposals, what `hasp reduce` does), .single (one
/// descent), .contact, .icp; reduction.coverage, reduction.top3; reduction.error_time.
void TryFits(ReportContext& context, const std::vector<ReductionCase>& cases);

/// reduction.capture: the farthest starts from which 95 % are captured, against ICP's. Captured is
/// what ends within half a millimetre of where the same method ends that begins at the truth, and
/// within 2 mm of the truth, which is what faces are planned to: a condyle's small face lets it end
/// 1.2 mm off from wherever it begins, and that is no matter of capture (reduction.tre).
void TryCapture(ReportContext& context, const std::vector<ReductionCase>& cases);

/// reduction.tre.assembled, reduction.rotation.assembled, reduction.coverage.assembled: whole
/// bones, all of whose pieces begin off, put together by Assemble.
void TryAssembly(ReportContext& context, const std::vector<ReductionCase>& cases);

/// reduction.pot: sherds of a pot of twelve that are placed within 0.5 mm (BrokenPot.h); unless
/// quick, reduction.pot@60: the same of a pot of sixty.
void TryPot(ReportContext& context);

/// reduction.fidelity: Paper VII's claim. Simulated operators put fractured blocks in place, with
/// few points and with all (SimulatedOperator.h): .p and .time of the same pairs; .points256,
/// .soft, .snap, .snap_worth: other pairs; .error and .seconds: each condition by itself.
void TryFidelity(ReportContext& context);

/// reduction.precision.intra, .inter, reduction.accuracy: Paper IV's table of simulated operators
/// who put broken mandibles together with Snap-to-fit (BoneTrial.h), made as `hasp evaluate FOLDER`
/// makes it (Evaluation/TrialTable.h).
void TryPrecision(ReportContext& context, const std::vector<ReductionCase>& jaws);

/// The fits of `hasp report stability`: what is predicted of smooth faces, one point of contact,
/// pieces that do not belong, starts inside of another and far away, and of poses in plan files;
/// each a case. Some seconds.
void TryReductionExtremes(ReportContext& context);
/// The last of them.
void TryPosesInPlans(ReportContext& context);

/// What is not made where nothing asks for it.
void AddUnusedReduction(ReportContext& context);

} // namespace hasp
