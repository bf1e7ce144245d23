#include "Output/PartFacts.h"

#include "CertificateRead.h"
#include "Output/RedParts.h"
#include "PartReport.h"
#include "RunParts.h"
#include "Tools/Planner.h"

#include "Planning/PlanFile.h"
#include "Planning/PlanLists.h"

#include <QCoreApplication>

#include <algorithm>
#include <exception>

namespace hasp
{
namespace
{

struct Words
{
  Q_DECLARE_TR_FUNCTIONS(PartFacts)
};

/// Throws std::runtime_error on what is no report.
void AddReport(PartFacts& facts, const std::string& text)
{
  const PartReport report = ReadPartReport(text);
  facts.verdict = report.verdict == "green" ? FitVerdict::Green
                  : report.verdict == "red" ? FitVerdict::Red
                                            : FitVerdict::NotCertified;
  facts.volumeMm3 = report.volumeMm3;
  facts.heldTo = report.heldTo;
  for (const std::string& fault : report.faults)
    facts.faults << QString::fromStdString(fault);
  facts.certificate = CertificateOfReport(text);
  facts.report = text;
}

/// Faults in the words of who has measured the part: they are ours, and say more.
void SayMore(PartFacts& facts, const Plan& plan, const RedParts::Part& red)
{
  const std::vector<std::string> texts = FaultsOf(
    plan, { .object = facts.object, .inputs = {}, .stl = {}, .report = red.report, .made = true });
  const int called = facts.called.size() + 2; // "guide 8: "
  facts.faults.clear();
  for (const std::string& text : texts)
    facts.faults << QString::fromStdString(text).mid(called);
  if (facts.certificate && facts.certificate->faults.size() == texts.size())
    for (std::size_t n = 0; n < texts.size(); ++n)
      facts.certificate->faults[n].text = facts.faults[int(n)].toStdString();
}

} // namespace

PartFacts FactsOf(Planner& planner, PlanId object)
{
  const Plan& plan = planner.plan.Now();
  const PlanDocument& document = planner.plan.Document();
  PartFacts facts;
  facts.object = object;
  facts.called = QString::fromStdString(CalledObject(plan, object));
  try
  {
    if (const DerivedPart* part = PartInDate(plan, document.parts, object))
    {
      facts.state = PartState::InDate;
      facts.stl = part->bytes;
      if (!part->report.empty())
        AddReport(facts, ReadBlob(planner.plan.Folder(), part->report));
      return facts;
    }
    facts.why = planner.plan.WhyNot(object);
    if (const RedParts::Part* red = RedParts::Of(planner).Find(object))
    {
      facts.state = PartState::DoesNotHold;
      AddReport(facts, red->report);
      SayMore(facts, plan, *red);
      facts.why = Words::tr("%1 does not hold").arg(facts.called);
      return facts;
    }
    const bool wasMade = std::any_of(document.parts.begin(), document.parts.end(),
      [&](const DerivedPart& part)
      { return part.object == object && part.format == PartFormat::Stl; });
    facts.state = wasMade ? PartState::OutOfDate : PartState::NotMade;
  }
  catch (const std::exception& error)
  {
    facts.state = PartState::NotMade;
    facts.verdict.reset();
    facts.why =
      Words::tr("%1 must be made again: %2").arg(facts.called, QString::fromUtf8(error.what()));
  }
  return facts;
}

QString WhyNotCertified(const Plan& plan, const PartFacts& facts)
{
  if (facts.verdict != FitVerdict::NotCertified)
    return {};
  if (!FindPlanObject<PlanPlate>(plan, facts.object))
    return Words::tr("%1 is exported as it is: nothing is claimed of its fit, so that there is "
                     "nothing to certify.")
      .arg(facts.called);
  return Words::tr(
    "%1 is not certified: it lies on fragments where the plan puts them, so that its "
    "gap to scanned bone cannot be measured, and it has no screw whose bore could "
    "be. Touch screws in the step Plate and make it again.")
    .arg(facts.called);
}

bool IsPutOnBone(const PartFacts& facts)
{
  return facts.certificate &&
         (facts.certificate->claims.withdrawal || facts.certificate->claims.shell);
}

QString WhyNotExported(const PartFacts& facts)
{
  if (!facts.why.isEmpty())
    return facts.why;
  if (facts.verdict == FitVerdict::Red)
    return Words::tr("%1 does not hold: %2").arg(facts.called, facts.faults.join("; "));
  return facts.verdict ? QString()
                       : Words::tr("%1 was kept without what was measured on it: make it again")
                           .arg(facts.called);
}

} // namespace hasp
