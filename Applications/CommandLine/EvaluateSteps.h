#pragma once
#include "EvaluateSide.h"
#include "EvaluateText.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/// What `hasp evaluate` does, one of four.
namespace hasp
{

struct Session;

struct EvaluateOptions
{
  std::string first, second, reference, scan, csv;
  std::vector<std::string> volumes, surfaces; ///< the plans' own
  double reachMm = 5.0;                       ///< as StepAndGapSettings
  std::optional<double> isovalue;             ///< of the other scan; none: as the reference's
  int series = 0;
};

/// Two plans, surfaces or folders of surfaces, fragment by fragment.
void EvaluatePair(const EvaluateOptions& options, Session& session);
/// Step-off and gap along the fractures of one plan, or of a folder of surfaces.
void EvaluateFractures(const EvaluateOptions& options, Session& session);
/// A plan against the bone of another scan.
void EvaluateScan(const EvaluateOptions& options, Session& session);
/// A folder of trials: CASE/OPERATOR-TRIAL.json or .hasp; CASE/truth.json.
void EvaluateTrials(const EvaluateOptions& options, Session& session);

/// The surface of a fragment by its key; nothing where there is none.
using SurfaceLookup = std::function<std::optional<EvaluatedSurface>(const std::string& key)>;
/// Of each two fragments of a side whose faces are within reach, where the side has them.
FracturesResult MeasureFractures(
  const EvaluatedSide& side, const SurfaceLookup& surfaceOf, double reachMm, Session& session);

/// "fragment 5", or its name with --show-names.
std::string CalledFragment(
  const std::string& key, const EvaluatedFragment& fragment, const Session& session);

/// The pose of each fragment as if the reference stood where it was scanned. `reference` may be
/// empty.
RigidPose PoseBeside(
  const EvaluatedSide& side, const std::string& key, const std::string& reference);

} // namespace hasp
