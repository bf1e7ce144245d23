#include "KeptParts.h"

#include "PartReport.h"
#include "PlanInput.h"
#include "Session.h"
#include "VerbWork.h"

#include <exception>

namespace hasp
{
namespace
{

/// Of the plan as it is by now, while nobody else changes it.
template <typename Work>
void ChangeKept(const std::string& folder, const Work& work)
{
  Try(ExitCode::WrongUse, "",
    [&]
    {
      const PlanLock lock(folder);
      PlanDocument document = OpenPlan(folder);
      work(document.parts);
      StorePlan(folder, document);
    });
}
} // namespace

PartFile TakePart(const KeptParts& kept, PlanId object, Session& session)
{
  const Plan& plan = kept.document.history.Current();
  PartFile file{ object, PartInputs(plan, object), {}, {}, true };
  const DerivedPart* part = PartInDate(plan, kept.document.parts, object);
  if (!part || part->report.empty() || kept.none)
    return file;
  try
  {
    const std::string report = ReadBlob(kept.folder, part->report);
    const PartReport read = ReadPartReport(report);
    RecipeOfReport(report); // what it says must be read to the end before it is taken
    const bool isCertified = read.verdict != "not certified";
    if ((isCertified && kept.certified) || (read.warnings > 0 && !kept.said))
      return file;
    file.stl = ReadBlob(kept.folder, part->bytes);
    file.report = report;
    file.made = false;
    session.resources.push_back(
      { CalledObject(plan, object), 0, 0.0, "in date: it was not made again" });
  }
  catch (const std::exception& error)
  {
    SayWarning(session, CalledObject(plan, object) + " is made anew: " + SafeText(error));
  }
  return file;
}

void KeepInPlan(const std::string& folder, const std::vector<PartFile>& parts)
{
  if (parts.empty())
    return;
  ChangeKept(folder,
    [&](std::vector<DerivedPart>& kept)
    {
      for (const PartFile& part : parts)
        KeepPart(kept, { part.object, PartFormat::Stl, part.inputs, WriteBlob(folder, part.stl),
                         WriteBlob(folder, part.report) });
    });
}

void KeepInPlan(const std::string& folder, PlanId segmentation,
  const std::vector<PartInput>& inputs, const std::string& nrrd, const std::string& report)
{
  ChangeKept(folder,
    [&](std::vector<DerivedPart>& kept)
    {
      KeepPart(kept, { segmentation, PartFormat::Nrrd, inputs, WriteBlob(folder, nrrd),
                       WriteBlob(folder, report) });
    });
}

} // namespace hasp
