#pragma once
#include "Planning/StrictJson.h"

#include <span>
#include <string>

namespace hasp
{

/// How a plan's file of one version becomes one of the next. JSON in, JSON out: the file has not
/// been checked yet, and is read as strictly as any other afterwards. Internal.
struct PlanMigration
{
  /// Mends what is a plan: the present one and the history's start. May be null.
  void (*plan)(Json& plan);
  /// Mends one object, wherever it is: in a plan's list or in an edit. `noun`: "cut". May be null.
  void (*object)(const std::string& noun, Json& object);
  /// Mends one made part. May be null.
  void (*part)(Json& part);
};

/// Takes a file through steps[version - 1], steps[version], … to version steps.size() + 1.
void MigratePlanFile(Json& file, std::size_t version, std::span<const PlanMigration> steps);

/// N of a file whose "format" is BEGIN and N, from 1 to the newest; refuses all others.
std::size_t ReadFormatVersion(const StrictJson& file, const std::string& begin);

/// All that there are: a file of version N is one of N - 1 that went through entry N - 2.
std::span<const PlanMigration> PlanMigrations();

} // namespace hasp
