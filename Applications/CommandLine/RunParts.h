#pragma once
#include "PlanRebuild.h"

#include "Planning/PlanFile.h"

#include <filesystem>
#include <string>
#include <vector>

/// The parts of a plan as files.
namespace hasp
{

struct PartPages;
struct Session;

/// A part as a file, and what was measured on it.
struct PartFile
{
  PlanId object = 0;
  std::vector<PartInput> inputs;
  std::string stl; ///< its bytes
  std::string
    report; ///< JSON: triangles, volume, cuts, segments, "verdict", "faults", certificate, recipe
  bool made = false; ///< now; else taken from the plan
};

/// Makes a part and writes it below `folder`; reads it back and certifies what has claims. A part
/// that does not hold says so in its file; what else a surgeon must know is said as a warning.
PartFile MakePart(PlanRebuild& rebuild, const Plan& plan, PlanId object,
  const std::filesystem::path& folder, const PartPages& pages, Session& session);

/// "guide-8.stl"
std::string NameOfPart(const Plan& plan, PlanId object, const std::string& more = {});

/// The reasons why a part does not hold, each begun with the object; none if it does. Of one that
/// was kept in words of ours (PartReport.h).
std::vector<std::string> FaultsOf(const Plan& plan, const PartFile& part);

/// All parts, as run.json says them; their files, those of fragments that the reduction moves, and
/// the recipes of parts that were certified, are put below `folder`.
std::string WriteParts(const Plan& plan, const std::vector<PartFile>& parts,
  const std::filesystem::path& folder, Session& session);
/// That, in a format that PartEndings has ("stl"), and run.json beside them: all that `hasp run`
/// writes.
void WriteRun(const Plan& plan, const std::vector<PartFile>& parts, const std::string& format,
  const std::filesystem::path& folder, Session& session);

} // namespace hasp
