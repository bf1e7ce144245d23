#pragma once
#include "Grid/Progress.h"
#include "Planning/PlanFile.h"
#include "RunImages.h"
#include "RunParts.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace hasp
{

struct Planner;
struct Session;

/// A part that a job has made, and what else came of it.
struct MadePart
{
  PartFile file;
  std::vector<std::string> faults;   ///< why it does not hold; none: it does, or has no claims
  std::vector<std::string> warnings; ///< what the user must know of it
  std::vector<DerivedPart> kept; ///< label maps that were made on the way; their blobs are there
};

/// What parts are made of: the plan as it was when somebody asked for them, its scans, and the
/// label maps and bones that several of them share. The parts have the bytes, and the reports, that
/// `hasp run` writes: both are made by MakePart (RunParts.h).
///
/// Threads: made on RENDER; then one WORKER at a time, which touches no more of the planner than
/// files in the plan's folder. Errors: Failure (Failure.h), whose text names objects by kind and
/// id; Cancelled.
class PartWork
{
public:
  /// RENDER. Of these objects, in this order. Throws std::runtime_error where a scan that they need
  /// is not in memory, with what to do.
  PartWork(const Planner& planner, const std::vector<PlanId>& objects);
  ~PartWork();

  /// Makes and certifies it.
  MadePart Make(PlanId object, const ProgressFunction& progress);
  /// The mesh and what it is held to, alone. The bone is good until the next call.
  RebuiltPart Rebuild(PlanId object, const ProgressFunction& progress);

  const Plan& Now() const { return this->Document.history.Current(); }

private:
  /// With the label maps that the object needs; those that are made are added to `kept`.
  PlanRebuild& Ready(PlanId object, std::vector<DerivedPart>& kept, Session& session);

  PlanDocument Document;
  std::filesystem::path Folder;
  RunImages Images;
  std::size_t Seen = 0; ///< of the images, by Builder
  std::unique_ptr<PlanRebuild> Builder;
};

/// A session whose warnings go to a list, and whose progress to a job: each step gets half of what
/// is left, for nobody knows how many there will be.
void AttachSession(
  Session& session, const ProgressFunction& progress, std::vector<std::string>& warnings);

} // namespace hasp
