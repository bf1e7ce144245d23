#include "Output/PartWork.h"

#include "Failure.h"
#include "PartReport.h"
#include "Report/ScratchFolder.h"
#include "RunCertificate.h"
#include "RunFaults.h"
#include "RunLabels.h"
#include "Session.h"
#include "Tools/Planner.h"
#include "VerbWork.h"

#include "Planning/PlanLists.h"

#include <QCoreApplication>

#include <optional>
#include <stdexcept>

namespace hasp
{
namespace
{

QString ScanIsMissing(const std::string& called, const std::string& scan)
{
  return QCoreApplication::translate("PartWork",
    "%1 cannot be made: its scan, %2, is not in memory. Give the scan that the plan was made on, "
    "at the step Import.")
    .arg(QString::fromStdString(called), QString::fromStdString(scan));
}

Failure AllOf(const std::vector<std::string>& texts)
{
  std::string all;
  for (const std::string& text : texts)
    all += (all.empty() ? "" : "\n") + text;
  return { ExitCode::BadInput, all };
}

} // namespace

void AttachSession(
  Session& session, const ProgressFunction& progress, std::vector<std::string>& warnings)
{
  session.sayWarning = [&warnings](const std::string& text) { warnings.push_back(text); };
  session.progress.SetWatch(
    [progress, now = std::optional<std::string>(), left = 2.0](
      const std::string& step, double share) mutable
    {
      if (step != now)
      {
        now = step;
        left *= 0.5;
      }
      return !progress || progress(1.0 - left + 0.5 * left * share);
    });
}

PartWork::PartWork(const Planner& planner, const std::vector<PlanId>& objects)
  : Document(planner.plan.Document()),
    Folder(planner.plan.Folder())
{
  const Plan& plan = this->Now();
  for (const PlanId object : objects)
    for (const PlanId image : ImagesOf(plan, object))
    {
      if (!FindPlanObject<PlanVolume>(plan, image) || this->Images.images.contains(image))
        continue;
      const ShelfScan* scan = planner.scans.OfVolume(plan, image);
      if (!scan)
        throw std::runtime_error(
          ScanIsMissing(CalledObject(plan, object), CalledObject(plan, image)).toStdString());
      this->Images.Add(image, scan->image);
    }
}

PartWork::~PartWork() = default;

PlanRebuild& PartWork::Ready(PlanId object, std::vector<DerivedPart>& kept, Session& session)
{
  const ScratchFolder scratch;
  RunFaults faults;
  const auto keep = [&](PlanId segmentation, const std::vector<PartInput>& inputs,
                      const std::string& nrrd, const std::string& report)
  {
    kept.push_back({ segmentation, PartFormat::Nrrd, inputs, WriteBlob(this->Folder, nrrd),
      WriteBlob(this->Folder, report) });
    KeepPart(this->Document.parts, kept.back());
  };
  AddLabelMaps({ this->Document, this->Folder.string(), scratch.Path(), false, keep },
    { { .object = object, .inputs = {}, .stl = {}, .report = {}, .made = true } }, this->Images,
    faults, session);
  if (!faults.Texts().empty())
    throw AllOf(faults.Texts());
  if (this->Images.images.size() != this->Seen)
  {
    this->Seen = this->Images.images.size();
    this->Builder = std::make_unique<PlanRebuild>(this->Now(), this->Images.images);
  }
  return *this->Builder;
}

MadePart PartWork::Make(PlanId object, const ProgressFunction& progress)
{
  return Try(ExitCode::BadInput, "",
    [&]
    {
      MadePart made;
      Session session;
      AttachSession(session, progress, made.warnings);
      PlanRebuild& builder = this->Ready(object, made.kept, session);
      const ScratchFolder scratch;
      made.file = MakePart(builder, this->Now(), object, scratch.Path(), PartPages{}, session);
      made.faults = FaultsOf(this->Now(), made.file);
      for (const std::string& warning :
        WarningsOf(ReadPartReport(made.file.report), CalledObject(this->Now(), object)))
        made.warnings.push_back(warning);
      return made;
    });
}

RebuiltPart PartWork::Rebuild(PlanId object, const ProgressFunction& progress)
{
  return Try(ExitCode::BadInput, "",
    [&]
    {
      std::vector<std::string> said; // when it was made
      std::vector<DerivedPart> notKept;
      Session session;
      AttachSession(session, progress, said);
      PlanRebuild& builder = this->Ready(object, notKept, session);
      session.progress.Step("making " + CalledObject(this->Now(), object));
      return builder.Make(
        object, [&session](double share) { return session.progress.Share(share); });
    });
}

} // namespace hasp
