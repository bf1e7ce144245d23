#include "Output/PartExport.h"

#include "Failure.h"
#include "Files.h"
#include "KeptParts.h"
#include "Output/PartFacts.h"
#include "Output/PartWork.h"
#include "PartFormats.h"
#include "PartReport.h"
#include "RunSegments.h"
#include "Session.h"
#include "Tools/Planner.h"
#include "VerbWork.h"
#include "vtkHaspOutputFile.h"

#include "Planning/PlanFile.h"
#include "Planning/PlanLists.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <exception>
#include <functional>
#include <memory>

namespace hasp
{
namespace
{

namespace fs = std::filesystem;

struct Words
{
  Q_DECLARE_TR_FUNCTIONS(PartExport)
};

/// Why, without what "Nothing is written" says already: Files.h says that of itself, too.
QString ReasonOf(const std::exception& error)
{
  static const QRegularExpression said("^cannot write [^:]+: |[;:] nothing was written$");
  return QString::fromUtf8(error.what()).remove(said);
}

bool CanWrite(Planner& planner, const std::function<void()>& require)
{
  try
  {
    require();
    return true;
  }
  catch (const std::exception& error)
  {
    planner.SayFault(Words::tr("Nothing is written: %1").arg(ReasonOf(error)));
    return false;
  }
}

Failure WrittenWrong()
{
  return { ExitCode::FailedCheck, "what was written is not what was made, and was not kept" };
}

/// And reads it back: WriteStlAs does so of all formats but the part's own.
void WriteAndCompare(const std::string& stl, const std::string& file, Session& session)
{
  WriteStlAs(stl, file, session);
  if (file.ends_with(".stl") && ReadWholeFile(file) != stl)
  {
    std::error_code ignored;
    fs::remove(fs::u8path(file), ignored);
    throw WrittenWrong();
  }
}

std::vector<PartFile> KeptFiles(const PlanDocument& document, const fs::path& folder,
  const std::vector<PlanId>& objects, Session& session)
{
  std::vector<PartFile> files;
  for (const PlanId object : objects)
  {
    files.push_back(
      TakePart({ .document = document, .folder = folder.string(), .said = true }, object, session));
    if (files.back().made) // it cannot be read: why has been said as a warning
      throw Failure(ExitCode::BadInput,
        CalledObject(document.history.Current(), object) + " cannot be read; make it again");
  }
  return files;
}

} // namespace

QStringList ExportFormats()
{
  QStringList formats;
  for (const std::string& ending : PartEndings())
    formats << QString::fromStdString(ending.substr(1));
  try
  {
    RequireThreeMf();
  }
  catch (const Failure&)
  {
    formats.removeAll(QStringLiteral("3mf"));
  }
  return formats;
}

QString NameOfExport(const Planner& planner, PlanId object, const QString& format)
{
  return QString::fromStdString(StemOfPart(planner.plan.Now(), object)) + '.' + format;
}

bool ExportPart(Planner& planner, PlanId object, const fs::path& file)
{
  const PartFacts facts = FactsOf(planner, object);
  if (const QString why = WhyNotExported(facts); !why.isEmpty())
  {
    planner.SayFault(Words::tr("Nothing is written: %1").arg(why));
    return false;
  }
  const std::string path = file.string();
  if (!CanWrite(planner, [&] { RequireWritable(path, PartEndings()); }))
    return false;
  planner.jobs.Add(Words::tr("Writing %1").arg(facts.called),
    [&planner, path, called = facts.called, hash = facts.stl, folder = planner.plan.Folder()](
      const ProgressFunction& progress) -> JobQueue::Finish
    {
      std::vector<std::string> warnings;
      Session session;
      AttachSession(session, progress, warnings);
      Try(ExitCode::WrongUse, "", [&] { WriteAndCompare(ReadBlob(folder, hash), path, session); });
      return [&planner, called]
      { planner.Say(Words::tr("%1 is written, read back, and the same.").arg(called)); };
    });
  return true;
}

QString WhyNotAll(Planner& planner)
{
  const std::vector<PlanId> objects = PartObjects(planner.plan.Now());
  QStringList reasons;
  if (objects.empty())
    reasons << Words::tr("nothing is made of this plan yet");
  for (const PlanId object : objects)
    if (const QString why = WhyNotExported(FactsOf(planner, object)); !why.isEmpty())
      reasons << why;
  return reasons.join('\n');
}

bool ExportAll(Planner& planner, const fs::path& folder, const QString& format)
{
  if (const QString why = WhyNotAll(planner); !why.isEmpty())
  {
    planner.SayFault(Words::tr("Nothing is written: %1").arg(why));
    return false;
  }
  const std::string path = folder.string();
  const auto require = [&]
  {
    RequireWritableFolder(path);
    if (format == QLatin1String("3mf"))
      RequireThreeMf();
  };
  if (!CanWrite(planner, require))
    return false;
  const auto document = std::make_shared<const PlanDocument>(planner.plan.Document());
  planner.jobs.Add(Words::tr("Writing all parts"),
    [&planner, path, document, ending = format.toStdString(), from = planner.plan.Folder()](
      const ProgressFunction& progress) -> JobQueue::Finish
    {
      const Plan& plan = document->history.Current();
      std::vector<std::string> warnings;
      Session session;
      AttachSession(session, progress, warnings);
      const std::vector<PartFile> parts = KeptFiles(*document, from, PartObjects(plan), session);
      const auto write = [&](const std::string& pending)
      {
        fs::create_directory(fs::u8path(pending));
        WriteRun(plan, parts, ending, fs::u8path(pending), session);
      };
      const auto inspect = [&](const std::string& pending)
      {
        for (const PartFile& part : parts) // other formats were read back when they were written
          if (ending == "stl" &&
              ReadWholeFile((fs::u8path(pending) / NameOfPart(plan, part.object)).string()) !=
                part.stl)
            throw WrittenWrong();
      };
      Try(ExitCode::WrongUse, "", [&] { WriteInspected(path, write, inspect); });
      return [&planner, count = int(parts.size())]
      { planner.Say(Words::tr("Parts written: %1.").arg(count)); };
    });
  return true;
}

} // namespace hasp
