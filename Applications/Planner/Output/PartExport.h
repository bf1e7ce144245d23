#pragma once
#include "Planning/Plan.h"

#include <QString>

#include <filesystem>

namespace hasp
{

struct Planner;

/// Parts as files, written by a job of planner.jobs and read back before they count as written.
/// What is out of date, does not hold or was never certified does not leave the planner: these
/// refuse it as well as the panel. All return false, and say why, where nothing is begun; what goes
/// wrong later is told by JobQueue::Failed, and then there is no file. Texts hold no names of files
/// or folders. Threads: RENDER.

/// "guide-8.stl"
QString NameOfExport(const Planner& planner, PlanId object, const QString& format);
/// stl, 3mf, ply, obj: those that this build writes.
QStringList ExportFormats();

/// One part, in the format of the file's ending. What is there is replaced.
bool ExportPart(Planner& planner, PlanId object, const std::filesystem::path& file);

/// Why ExportAll refuses, a line each; empty: it does not.
QString WhyNotAll(Planner& planner);
/// All that `hasp run PLAN` writes, byte for byte: the parts, those of fragments that are moved as
/// planned, too, recipes, run.json. `folder`: not there yet, or empty; appears whole or not at all.
bool ExportAll(Planner& planner, const std::filesystem::path& folder, const QString& format);

} // namespace hasp
