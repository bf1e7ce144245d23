#pragma once
#include "Evaluation/FitCertificate.h"
#include "PlanRebuild.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

/// What was measured on a part of a plan, as the plan keeps it: JSON. Who can write the plan's
/// folder can write such a report, so that nothing of one is said but numbers and words of ours.
namespace hasp
{

struct PartReport
{
  std::string verdict; ///< "green", "red" or "not certified"
  double volumeMm3 = 0.0;
  std::vector<std::string> faults; ///< of a red one, at least one: what, which object, where
  std::vector<PlanId> cutsThatPartNothing;
  PlanId heldTo = 0;        ///< a fragment alone; 0: all bone of its scan, or not certified
  std::size_t warnings = 0; ///< that were said when it was made, and are not kept
};

/// Throws std::runtime_error, with no text of it, if it is none that Hasp writes.
PartReport ReadPartReport(const std::string& report);
/// One of a certificate's faults as a report has it, in words of ours. Throws likewise.
FitFault ReadFault(const nlohmann::ordered_json& fault);

/// "cut 3 does not part the bone that fragment 4 is a piece of: …", of each such cut.
std::vector<std::string> WarningsOf(const PartReport& report, const std::string& part);

/// "green, held to fragment 2 alone"
std::string VerdictOf(const PartReport& report);

/// Puts what a report says into a part of run.json, but for keys that are there already, and for
/// texts that are not Hasp's own. Faults are in the words of PartReport.
void AddReport(const std::string& report, nlohmann::ordered_json& part);

/// The recipe that a part was made by, as a recipe's file; empty if there is none.
std::string RecipeText(const PartCheck& check);
/// The same of its report. Throws std::runtime_error, with no text of it, on what is no recipe.
std::string RecipeOfReport(const std::string& report);

/// "guide-8"
std::string StemOfPart(const Plan& plan, PlanId object);

} // namespace hasp
