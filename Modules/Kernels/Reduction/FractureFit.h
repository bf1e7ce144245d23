#pragma once
#include "Grid/Progress.h"
#include "Reduction/FitTerms.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace hasp
{

/// A body of a group that is moved as one.
struct GroupBody
{
  std::shared_ptr<const FitBody> body;
  RigidPose bodyInGroup;
};

struct FitSettings
{
  double captureMm =
    6.0;        ///< faces attract from so far at first, [0.5, 20]; at most the maps' range
  FitLaw law{}; ///< of the last stage
  int coarsePoints = 1024; ///< a body, while faces attract from 2 mm and farther, [64, 10^6]
  int points = 8192;       ///< a body, later, [64, 10^6]
  int steps = 20;          ///< of each stage, at most, [1, 1000]
};

/// How far a fit may be off, for all that can be told from its residuals.
struct FitSpread
{
  Symmetric6 covariance{}; ///< of a shift (mm) and a turn (rad) about the group's origin, world
  double within95Mm = 0.0; ///< the truth moves the surface by no more, rms over it, at 95 %
  double within95Degrees = 0.0; ///< and turns it by no more
};

/// One local fit.
struct FractureFit
{
  RigidPose groupInWorld;
  FitSums sums; ///< of the last law; a fit is the better the lower its energy
  FitSpread spread;
  double FaceRmsMm() const; ///< between faces that look at each other
  double StepRmsMm() const; ///< between surfaces that go on
  bool touches = false;     ///< anything at all held it; if not, it stands where it began
  bool settled = false;     ///< the last stage's steps became small
  int steps = 0;
};

/// Throws std::invalid_argument with the value and its legal range.
void CheckFitSettings(const FitSettings& settings);

/// Snap-to-fit without a hand (thesis 3.1, Paper I): from a coarse pose downhill to the local fit
/// near it. Faces attract from captureMm at first, then from ever nearer; steps are Gauss and
/// Newton's, damped (Levenberg and Marquardt), of 1 mm at most, and never uphill.
///
/// moved   one body or more; at most 1000
/// start   of the group, world
/// Deviations from Paper I: distances count in both directions, and outer surfaces go on (FitLaw).
/// Throws std::invalid_argument on settings, no body, or a pose that is not finite. Any thread;
/// one core; the same bits always. 20 to 100 ms for two bodies at the defaults. `spread` is left to
/// MeasureSpread.
FractureFit FitFracture(std::span<const GroupBody> moved, const RigidPose& start,
  const FitScene& scene, const FitSettings& settings = {});

/// The first stages alone, with few points: 5 ms. Good to choose starts by.
FractureFit FitCoarsely(std::span<const GroupBody> moved, const RigidPose& start,
  const FitScene& scene, const FitSettings& settings = {});

/// The last stages, from where FitCoarsely ended.
FractureFit RefineFit(std::span<const GroupBody> moved, const FractureFit& coarse,
  const FitScene& scene, const FitSettings& settings = {});

/// Root mean square way of the group's surface from one pose to the other, mm.
double RmsWay(std::span<const GroupBody> moved, const RigidPose& from, const RigidPose& to);

/// Who moves, at the fit: bodies that move as one.
struct SpreadUnit
{
  std::span<const GroupBody> bodies;
  RigidPose groupInWorld;
};

/// Two that pull at each other. Each pair is named once.
struct SpreadPair
{
  std::size_t unit;                 ///< index of one that moves
  std::optional<std::size_t> other; ///< index of the other; none: that stands, and has no error
  FitScene scene;                   ///< the other's bodies
};

/// How far fits that were made together may be off, each for itself: a sandwich of what holds them
/// all (their pulls' derivatives) and their residuals, those within 5 mm of each other counted as
/// one (they err together), and a gap between all faces that nobody knows, of `gapMm` (one standard
/// deviation: what faces may have lost, and half levels may be off), all that times `factor`. A
/// piece so has part in the errors of those that it stands on. Calibrated on simulated cases whose
/// truth is known (`hasp report reduction`, reduction.coverage). A direction that nothing holds is
/// given 10 mm before that.
/// Any thread; all cores, the same bits with any number of them. 13 sums over a pair's points.
std::vector<FitSpread> MeasureSpreads(std::span<const SpreadUnit> units,
  std::span<const SpreadPair> pairs, const FitSettings& settings, double gapMm = 0.15,
  double factor = 0.45);

/// Fills in `spread` of a fit before what stands: of one unit.
void MeasureSpread(std::span<const GroupBody> moved, const FitScene& scene,
  const FitSettings& settings, FractureFit& fit, double gapMm = 0.15, double factor = 0.45);

} // namespace hasp
