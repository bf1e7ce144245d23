#pragma once
#include "Evaluation/PoseDifference.h"
#include "Evaluation/SurfaceDifference.h"
#include "Grid/Progress.h"
#include "Grid/RigidPose.h"

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// Precision and accuracy of operators who reduce the same cases again and again (Paper IV).
namespace hasp
{

/// Poses of a case's fragments by their names, scanToPlanned. All trials of a case, and its truth,
/// have the reference (the cranium) where it was scanned: see RelativeTo.
using FragmentPoses = std::map<std::string, RigidPose>;

struct TrialCase
{
  std::string name;
  std::map<std::string, std::shared_ptr<const MeasuredSurface>> fragments; ///< in the scan
  std::optional<FragmentPoses> truth{}; ///< where it is known; fragments may be missing
};

struct Trial
{
  std::string caseName, operatorName;
  int trial = 1; ///< of that operator on that case
  FragmentPoses poses;
};

/// The same poses as if the reference had not been moved: inverse(reference) * pose. The reference
/// itself is left out. Throws std::invalid_argument if it has no pose.
FragmentPoses RelativeTo(const FragmentPoses& poses, const std::string& reference);

/// What a pair of poses of one fragment is held to, in the order of the table's columns.
enum class TrialMeasure
{
  SurfaceMeanMm, ///< SurfaceDifference, of both directions
  SurfaceMaxMm,
  RotationDegrees,
  TranslationMm, ///< of the fragment's centroid
  TreMm          ///< mean displacement of places all over the fragment
};
inline constexpr std::size_t TrialMeasures = 5;
using TrialFigures = std::array<double, TrialMeasures>; ///< by TrialMeasure

/// Two trials, or a trial and the truth, of one fragment.
struct TrialPair
{
  std::string caseName, fragment;
  std::size_t first = 0;               ///< of the trials that were given
  std::optional<std::size_t> second{}; ///< none: the truth
  bool oneOperator = false;            ///< of both trials
  TrialFigures figures{};
};

/// Over pairs; all 0 where there are none.
struct TrialSummary
{
  std::size_t pairs = 0;
  TrialFigures mean{}, deviation{}, most{}; ///< deviation: of pairs (n - 1), 0 of one
};

struct TrialRow
{
  std::string caseName;       ///< of all cases: empty
  TrialSummary intraOperator; ///< precision: every two trials of one operator
  TrialSummary interOperator; ///< precision: every two trials of different operators
  TrialSummary accuracy;      ///< every trial against the truth, where that is known
};

/// What a full table would have. Without a fragment: the whole trial; without an operator: the
/// truth.
struct MissingTrial
{
  std::string caseName, operatorName;
  int trial = 0;
  std::string fragment;
};

struct TrialTable
{
  std::vector<TrialPair> pairs; ///< by case, in the order in which trials were given
  std::vector<TrialRow> rows;   ///< by case, in the order in which cases were given
  TrialRow overall;             ///< over all pairs of all cases, each with the same weight
  /// Every operator of any case is expected to have done every trial number of any case. Nothing is
  /// filled in for what is missing: its pairs are not there.
  std::vector<MissingTrial> missing;
};

/// Paper IV's table. A truth that is known of some fragments is used for those and said to miss the
/// others; a case without a truth misses nothing.
///
/// Throws std::invalid_argument (by place, from 0, never by name) on a case that is named twice or
/// has no fragments, a fragment without a surface, a trial of no case, a trial that is there twice,
/// poses of fragments that a case has not, and poses as CheckedPose does; Cancelled. Any thread;
/// all cores; the same bits on any number of them. O(pairs) times MeasureSurfaceDifference.
TrialTable MakeTrialTable(std::span<const TrialCase> cases, std::span<const Trial> trials,
  const ProgressFunction& progress = {});

} // namespace hasp
