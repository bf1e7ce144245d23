#include "Output/PartMaking.h"

#include "Output/PartWork.h"
#include "Output/RedParts.h"
#include "PartReport.h"
#include "Tools/Planner.h"

#include "Planning/PlanLists.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <exception>

namespace hasp
{
namespace
{

struct Words
{
  Q_DECLARE_TR_FUNCTIONS(PartMaking)
};

QString Called(const Planner& planner, PlanId object)
{
  return QString::fromStdString(CalledObject(planner.plan.Now(), object));
}

QString Lines(const std::vector<std::string>& texts)
{
  QStringList lines;
  for (const std::string& text : texts)
    lines << QString::fromStdString(text);
  return lines.join('\n');
}

void KeepRed(Planner& planner, const MadePart& made)
{
  const PlanId object = made.file.object;
  RedParts::Of(planner).Put(object, { made.file.inputs, made.file.stl, made.file.report });
  planner.SayFault(Words::tr(
    "%1 does not hold and is not kept: change what it is made of, and make it again. The step "
    "Check shows where.\n%2")
                     .arg(Called(planner, object), Lines(made.faults)));
}

/// What RENDER does with a part.
void Keep(Planner& planner, const MadePart& made, const DerivedPart& part)
{
  for (const DerivedPart& labels : made.kept)
    if (FindPlanObject<PlanSegmentation>(planner.plan.Now(), labels.object))
      planner.plan.KeepMade(labels);
  if (!IsPartObject(planner.plan.Now(), part.object))
    return; // removed meanwhile
  if (!made.faults.empty())
    return KeepRed(planner, made);
  planner.plan.KeepMade(part);
  RedParts::Of(planner).Drop(part.object);
  const QString verdict = QString::fromStdString(VerdictOf(ReadPartReport(made.file.report)));
  const QString done = Words::tr("%1 is made: %2.").arg(Called(planner, part.object), verdict);
  planner.Say(made.warnings.empty() ? done : done + '\n' + Lines(made.warnings));
}

void AddJob(Planner& planner, const std::shared_ptr<PartWork>& work, PlanId object)
{
  const int round = RedParts::Of(planner).Round();
  planner.jobs.Add(Words::tr("Making %1").arg(Called(planner, object)),
    [&planner, work, object, round, folder = planner.plan.Folder()](
      const ProgressFunction& progress) -> JobQueue::Finish
    {
      const auto made = std::make_shared<const MadePart>(work->Make(object, progress));
      DerivedPart part{ object, PartFormat::Stl, made->file.inputs, {}, {} };
      if (made->faults.empty())
      {
        part.bytes = WriteBlob(folder, made->file.stl);
        part.report = WriteBlob(folder, made->file.report);
      }
      return [&planner, made, part, round]
      {
        if (round == RedParts::Of(planner).Round())
          Keep(planner, *made, part);
      };
    });
}

void Make(Planner& planner, const std::vector<PlanId>& objects)
{
  try
  {
    const auto work = std::make_shared<PartWork>(planner, objects);
    for (const PlanId object : objects)
      AddJob(planner, work, object);
  }
  catch (const std::exception& error)
  {
    planner.SayFault(QString::fromUtf8(error.what()));
  }
}

} // namespace

void MakePart(Planner& planner, PlanId object)
{
  if (!IsPartObject(planner.plan.Now(), object))
    return planner.SayFault(Words::tr("%1: no part is made of it.").arg(Called(planner, object)));
  Make(planner, { object });
}

void MakeAll(Planner& planner)
{
  std::vector<PlanId> objects = PartObjects(planner.plan.Now());
  if (objects.empty())
    return planner.SayFault(
      Words::tr("Nothing is made of this plan yet: add a fragment, a guide, a "
                "plate or an implant first."));
  std::erase_if(objects, [&](PlanId object) { return planner.plan.WhyNot(object).isEmpty(); });
  if (objects.empty())
    return planner.Say(Words::tr("All parts are in date."));
  const auto red =
    std::erase_if(objects, [&](PlanId object) { return RedParts::Of(planner).Find(object); });
  if (objects.empty()) // they would be the same again
    return planner.SayFault(
      Words::tr("Parts that do not hold: %1. Change what they are made of first.").arg(red));
  Make(planner, objects);
}

} // namespace hasp
