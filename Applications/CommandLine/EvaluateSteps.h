#pragma once
#include "EvaluateSide.h"

#include <optional>
#include <string>
#include <vector>

/// What `hasp evaluate` does, one of three.
namespace hasp
{

struct Session;

struct EvaluateOptions
{
  std::string first, second, reference, scan, csv;
  std::vector<std::string> volumes;
  std::optional<double> isovalue; ///< of the other scan; none: as the reference's
  int series = 0;
};

/// Two plans, surfaces or folders of surfaces, fragment by fragment.
void EvaluatePair(const EvaluateOptions& options, Session& session);
/// A plan against the bone of another scan.
void EvaluateScan(const EvaluateOptions& options, Session& session);
/// A folder of trials: CASE/OPERATOR-TRIAL.json or .hasp; CASE/truth.json.
void EvaluateTrials(const EvaluateOptions& options, Session& session);

/// "fragment 5", or its name with --show-names.
std::string CalledFragment(
  const std::string& key, const EvaluatedFragment& fragment, const Session& session);

/// The pose of each fragment as if the reference stood where it was scanned. `reference` may be
/// empty.
RigidPose PoseBeside(
  const EvaluatedSide& side, const std::string& key, const std::string& reference);

} // namespace hasp
