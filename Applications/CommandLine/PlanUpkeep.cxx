#include "PlanUpkeep.h"

#include "Failure.h"
#include "PlanInput.h"
#include "PlanText.h"
#include "Session.h"
#include "VerbWork.h"

#include "Planning/DerivedPart.h"

#include <stdexcept>

namespace hasp
{

void CheckPlan(const std::string& folder, Session& session)
{
  const std::vector<std::string> faults = PlanFaults(folder);
  session.result["faults"] = faults;
  session.resultStands = true;
  if (!faults.empty())
    throw FailedCheck(
      "the plan is damaged; if it is only in what was made, --prune mends it", faults);
  Say(session, "every byte of the plan is as it was written");
}

void PrunePlan(PlanDocument& document, const std::string& folder, Session& session)
{
  const std::size_t before = document.parts.size();
  std::erase_if(document.parts,
    [&](const DerivedPart& part)
    {
      try
      {
        ReadBlob(folder, part.bytes);
        if (!part.report.empty())
          ReadBlob(folder, part.report);
        return !WhyOutOfDate(document.history.Current(), part).empty();
      }
      catch (const std::runtime_error&)
      {
        return true; // damaged or missing
      }
    });
  StorePlan(folder, document);
  Try(ExitCode::WrongUse, "", [&] { RemoveUnusedBlobs(folder, document); });
  const std::size_t gone = before - document.parts.size();
  session.result["pruned"] = gone;
  Say(session, std::to_string(gone) + " parts that were out of date or damaged are forgotten");
}

} // namespace hasp
