#pragma once
#include "Planning/PlanFile.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace hasp
{

struct Session;

/// `hasp plan --surface`: files of triangles that become fragments.
struct SurfaceEntries
{
  std::vector<std::string> files;
  double thicknessMm = 0.0; ///< of open ones, as SurfaceSource
  bool bothSides = false;
  double spacingMm = 0.5;
};

void AddSurfaceOptions(CLI::App& verb, SurfaceEntries& entries);

/// A surface and a fragment of it for each file, all as one step of the plan, without names: those
/// of files may be a patient's. Their ids go into the session's result as "entered". Returns what
/// to say once it is stored. Throws Failure: BadInput, by the file's place in the command line,
/// where triangles enclose nothing and have no thickness, or are in the plan already.
std::string EnterSurfaces(PlanDocument& document, const SurfaceEntries& entries, Session& session);

} // namespace hasp
